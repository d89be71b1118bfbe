#pragma once
// Numbers as most files write them, read without what the others need.

#include <array>
#include <cstddef>
#include <cstdint>

namespace aomd::io::detail {

/// Digits from `p` on; `value` becomes what they say, modulo 2^64. Returns where they end.
inline const char* pass_digits(const char* p, const char* end, std::uint64_t& value) {
  for (; p != end; ++p) {
    const unsigned digit = static_cast<unsigned char>(*p) - unsigned{'0'};
    if (digit > 9) break;
    value = value * 10 + digit;
  }
  return p;
}

/// Reads "-12.345" and the like from `p` on: without an exponent, and with so few digits that they
/// are a whole number which a double holds. As a power of ten up to the 22nd is another, dividing
/// gives the double nearest to what is written, the same as std::from_chars. Returns where the
/// number ends, or null where it is of another kind.
inline const char* plain_real(const char* p, const char* end, double& value) {
  constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::ptrdiff_t most_digits = 19;  // of 64 bits
  const bool negative = p != end && *p == '-';
  const char* const first = p += negative;
  std::uint64_t digits = 0;
  p = pass_digits(p, end, digits);
  const char* const point = p;
  std::ptrdiff_t behind = 0;
  if (p != end && *p == '.') {
    p = pass_digits(p + 1, end, digits);
    behind = p - point - 1;
  }
  const std::ptrdiff_t count = point - first + behind;
  if (count == 0 || count > most_digits || digits > std::uint64_t{1} << 53) return nullptr;
  const double size = static_cast<double>(static_cast<std::int64_t>(digits)) /
                      powers[static_cast<std::size_t>(behind)];
  value = negative ? -size : size;
  return p;
}

/// The same for whole numbers of at most 18 digits.
inline const char* plain_integer(const char* p, const char* end, std::int64_t& value) {
  const bool negative = p != end && *p == '-';
  const char* const first = p += negative;
  std::uint64_t digits = 0;
  p = pass_digits(p, end, digits);
  if (p == first || p - first > 18) return nullptr;
  value = static_cast<std::int64_t>(digits);
  if (negative) value = -value;
  return p;
}

}  // namespace aomd::io::detail
