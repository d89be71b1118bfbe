#include "core/io/stored_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aomd::io::detail {

void round_as(NumberType type, std::vector<double>& values) {
  if (type != NumberType::Float32) return;
  for (double& x : values) x = static_cast<double>(static_cast<float>(x));
}

bool fit_int32(std::span<const double> values) {
  using Limits = std::numeric_limits<std::int32_t>;
  return std::all_of(values.begin(), values.end(),
                     [](double x) { return x >= Limits::min() && x <= Limits::max(); });
}

bool fit_values(Attribute& array) {
  const NumberType type =
      array.type.value_or(array.integer ? NumberType::Int32 : NumberType::Float64);
  for (double& x : array.values) {
    double held = 0;
    use_as(type, x, [&](auto value) { held = static_cast<double>(value); });
    const bool fits = is_integer(type) ? held == x : std::isfinite(held) || !std::isfinite(x);
    if (!fits) {
      array.integer = false;
      array.type = {};
      return false;
    }
    x = held;
  }
  return true;
}

const char* ply_name(NumberType type) {
  constexpr const char* names[] = {"char", "uchar",  "short",  "ushort", "int",
                                   "uint", "double", "double", "float",  "double"};
  return names[static_cast<std::size_t>(type)];
}

}  // namespace aomd::io::detail
