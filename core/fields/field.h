#pragma once
// What an array on the entities of a mesh is, and what it comes to over the whole mesh.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::fields {

/// How the values of an array move when the geometry does.
enum class FieldKind {
  Interpolated,  ///< real numbers on vertices: linear inside tetrahedra and triangles
  Conserved,     ///< real numbers on edges, faces and regions: densities, whose integrals stay
  Label,         ///< whole numbers: never mixed
  Unit,          ///< normals: interpolated, and made unit vectors again
  Colour         ///< interpolated, and rounded where the file has whole numbers
};

[[nodiscard]] FieldKind kind_of(const Attribute& array);
/// "interpolated", "conserved", "label", "unit vector" or "colour".
[[nodiscard]] std::string_view kind_name(FieldKind kind);

/// The array without its values.
[[nodiscard]] Attribute like(const Attribute& array);
/// Makes the mixed values of one entity what the array's kind says: of length 1, or whole.
void settle(const Attribute& array, std::span<double> values);

/// A sum with what rounding takes from it kept beside it (Neumaier 1974).
class Sum {
 public:
  void add(double x) {
    const double next = sum_ + x;
    rest_ += (sum_ < 0 ? -sum_ : sum_) >= (x < 0 ? -x : x) ? (sum_ - next) + x : (x - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0, rest_ = 0;
};

/// One component over all entities that have a number.
struct ComponentFacts {
  double low = 0, high = 0;
  double integral = 0;  ///< values times measures
};

struct FieldFacts {
  std::vector<ComponentFacts> components;
  std::size_t missing = 0;  ///< values that are no finite number
};

/// `measures` has what each entity stands for. Cost: linear.
[[nodiscard]] FieldFacts facts_of(const Attribute& array, std::span<const double> measures);

}  // namespace aomd::fields
