#pragma once
// How files store numbers.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#pragma GCC visibility push(default)

namespace aomd {

enum class NumberType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/// Bytes that one number takes in binary files.
[[nodiscard]] constexpr std::size_t size_of(NumberType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool is_integer(NumberType type) { return type < NumberType::Float32; }

/// The whole number of a type that is nearest; 0 for what is no number.
template <class Whole>
[[nodiscard]] Whole nearest_whole(double x) {
  using Limits = std::numeric_limits<Whole>;
  const double rounded = std::round(x);
  if (std::isnan(rounded)) return 0;
  if (rounded <= static_cast<double>(Limits::min())) return Limits::min();
  if (rounded >= static_cast<double>(Limits::max())) return Limits::max();
  return static_cast<Whole>(rounded);
}

/// Calls use(x) with the number as its type holds it: a float or the nearest whole number.
template <class Use>
void use_as(NumberType type, double x, Use&& use) {
  switch (type) {
    case NumberType::Int8:
      return use(nearest_whole<std::int8_t>(x));
    case NumberType::UInt8:
      return use(nearest_whole<std::uint8_t>(x));
    case NumberType::Int16:
      return use(nearest_whole<std::int16_t>(x));
    case NumberType::UInt16:
      return use(nearest_whole<std::uint16_t>(x));
    case NumberType::Int32:
      return use(nearest_whole<std::int32_t>(x));
    case NumberType::UInt32:
      return use(nearest_whole<std::uint32_t>(x));
    case NumberType::Int64:
      return use(nearest_whole<std::int64_t>(x));
    case NumberType::UInt64:
      return use(nearest_whole<std::uint64_t>(x));
    case NumberType::Float32:
      return use(static_cast<float>(x));
    case NumberType::Float64:
      break;
  }
  use(x);
}

}  // namespace aomd

#pragma GCC visibility pop
