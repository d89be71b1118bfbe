#pragma once
// The types by which files store the numbers of an array.

#include <span>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// The array, an Attribute or the like, is of a file that stores it so.
template <class Array>
void store_as(Array& array, NumberType type) {
  array.integer = is_integer(type);
  array.type = type;
  if (type == NumberType::Float64 || type == NumberType::Int32) array.type = {};
}

/// What text says of floats, as the floats that it stands for.
void round_as(NumberType type, std::vector<double>& values);

/// True where whole numbers of 32 bits hold all of these.
[[nodiscard]] bool fit_int32(std::span<const double> values);

/// The type to store an array by: that of the file it is from, or the one that its values need.
template <class Array>
[[nodiscard]] NumberType stored_type(const Array& array) {
  if (array.type) return *array.type;
  if (!array.integer) return NumberType::Float64;
  return fit_int32(array.values) ? NumberType::Int32 : NumberType::Int64;
}

/// Makes the values of an array whose type is set what that holds: floats are rounded. Returns
/// false where some do not fit, as text may say 0.5 of whole numbers; the array then has doubles.
bool fit_values(Attribute& array);

/// "uchar" and so on, as PLY names types.
[[nodiscard]] const char* ply_name(NumberType type);

}  // namespace aomd::io::detail
