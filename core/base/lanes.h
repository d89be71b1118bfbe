#pragma once
// Several numbers that are computed with at once.

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/vec3.hpp>

#pragma GCC visibility push(default)

namespace aomd {

/// The vector types of the compilers, and what comparing two of them gives.
template <typename Number>
struct LaneTypes;
template <>
struct LaneTypes<float> {
  using Values = float __attribute__((vector_size(16)));
  using Mask = int __attribute__((vector_size(16)));
};
template <>
struct LaneTypes<double> {
  using Values = double __attribute__((vector_size(16)));
  using Mask = long long __attribute__((vector_size(16)));
};

/// As many numbers as fill 16 bytes. Each lane gets what one number would get, bit by bit.
/// Comparisons give a mask: all bits set, or none, in each lane.
template <typename Number>
class LanesOf {
 public:
  static constexpr std::size_t count = 16 / sizeof(Number);
  using Values = typename LaneTypes<Number>::Values;
  using Mask = typename LaneTypes<Number>::Mask;

  LanesOf() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for as many of it
  LanesOf(Number all) : values_(all - Values{}) {}
  /// From value(0), value(1) and so on.
  template <typename Value>
  [[nodiscard]] static LanesOf each(const Value& value) {
    return each(value, std::make_index_sequence<count>());
  }
  [[nodiscard]] Number operator[](std::size_t i) const { return values_[i]; }

  friend LanesOf operator+(LanesOf a, LanesOf b) { return LanesOf(a.values_ + b.values_); }
  friend LanesOf operator-(LanesOf a, LanesOf b) { return LanesOf(a.values_ - b.values_); }
  friend LanesOf operator*(LanesOf a, LanesOf b) { return LanesOf(a.values_ * b.values_); }
  friend LanesOf operator/(LanesOf a, LanesOf b) { return LanesOf(a.values_ / b.values_); }
  friend LanesOf operator-(LanesOf a) { return LanesOf(-a.values_); }
  LanesOf& operator+=(LanesOf a) { return *this = *this + a; }
  LanesOf& operator-=(LanesOf a) { return *this = *this - a; }
  LanesOf& operator*=(LanesOf a) { return *this = *this * a; }
  friend Mask operator<(LanesOf a, LanesOf b) { return a.values_ < b.values_; }
  friend Mask operator>(LanesOf a, LanesOf b) { return a.values_ > b.values_; }
  friend Mask operator<=(LanesOf a, LanesOf b) { return a.values_ <= b.values_; }
  friend Mask operator>=(LanesOf a, LanesOf b) { return a.values_ >= b.values_; }
  friend Mask operator==(LanesOf a, LanesOf b) { return a.values_ == b.values_; }
  /// `a` where the mask is set, else `b`.
  friend LanesOf select(Mask mask, LanesOf a, LanesOf b) {
    return LanesOf(mask ? a.values_ : b.values_);
  }
  friend LanesOf abs(LanesOf a) { return select(a < LanesOf(Number(0)), -a, a); }
  friend LanesOf sqrt(LanesOf a) {
    return each([&](std::size_t i) { return std::sqrt(a[i]); });
  }

 private:
  explicit LanesOf(Values values) : values_(values) {}
  template <typename Value, std::size_t... I>
  static LanesOf each(const Value& value, std::index_sequence<I...>) {
    return LanesOf(Values{value(I)...});
  }

  Values values_;
};

using Lanes = LanesOf<float>;
using DoubleLanes = LanesOf<double>;

/// Two points, one in each lane.
using TwoPoints = glm::vec<3, DoubleLanes>;
[[nodiscard]] inline TwoPoints two_points(const glm::dvec3& first, const glm::dvec3& second) {
  static_assert(DoubleLanes::count == 2);
  const auto lanes = [&](int k) {
    return DoubleLanes::each([&](std::size_t i) { return i == 0 ? first[k] : second[k]; });
  };
  return {lanes(0), lanes(1), lanes(2)};
}

/// The same for one number, so that templates serve both.
inline float select(bool which, float a, float b) { return which ? a : b; }
inline double select(bool which, double a, double b) { return which ? a : b; }

}  // namespace aomd

template <typename Number>
struct std::numeric_limits<aomd::LanesOf<Number>> : std::numeric_limits<Number> {};

#pragma GCC visibility pop
