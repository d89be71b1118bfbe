#pragma once
// Sums of squared distances to planes and points, as a function of one position (Garland, Heckbert
// 1997).

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace aomd {

/// x^T A x + 2 b^T x + c with A symmetric: ten numbers. In single precision it is to be kept about
/// a place of its own (see about()), where its numbers are small.
template <typename Number>
class QuadricOf {
 public:
  using Vec3 = glm::vec<3, Number>;

  QuadricOf() = default;
  template <typename Other>
  explicit QuadricOf(const QuadricOf<Other>& q)
      : xx_(Number(q.xx_)),
        yy_(Number(q.yy_)),
        zz_(Number(q.zz_)),
        xy_(Number(q.xy_)),
        xz_(Number(q.xz_)),
        yz_(Number(q.yz_)),
        b_(q.b_),
        c_(Number(q.c_)) {}
  /// Several at once, where a number has lanes: of quadric(0), quadric(1) and so on.
  template <typename Each>
  [[nodiscard]] static QuadricOf of_each(const Each& quadric) {
    const auto lanes = [&](auto&& number) {
      return Number::each([&](std::size_t i) { return number(quadric(i)); });
    };
    QuadricOf q;
    q.xx_ = lanes([](const auto& one) { return one.xx_; });
    q.yy_ = lanes([](const auto& one) { return one.yy_; });
    q.zz_ = lanes([](const auto& one) { return one.zz_; });
    q.xy_ = lanes([](const auto& one) { return one.xy_; });
    q.xz_ = lanes([](const auto& one) { return one.xz_; });
    q.yz_ = lanes([](const auto& one) { return one.yz_; });
    q.b_ = {lanes([](const auto& one) { return one.b_.x; }),
            lanes([](const auto& one) { return one.b_.y; }),
            lanes([](const auto& one) { return one.b_.z; })};
    q.c_ = lanes([](const auto& one) { return one.c_; });
    return q;
  }
  /// Adds weight * (n.x + d)^2.
  void add_plane(const Vec3& n, Number d, Number weight) {
    const Vec3 m = weight * n;
    xx_ += m.x * n.x, yy_ += m.y * n.y, zz_ += m.z * n.z;
    xy_ += m.x * n.y, xz_ += m.x * n.z, yz_ += m.y * n.z;
    b_ += d * m;
    c_ += weight * d * d;
  }
  /// Adds weight * |x - p|^2.
  void add_point(const Vec3& p, Number weight) {
    xx_ += weight, yy_ += weight, zz_ += weight;
    b_ -= weight * p;
    c_ += weight * glm::dot(p, p);
  }
  QuadricOf& operator*=(Number factor) {
    for (Number* a : {&xx_, &yy_, &zz_, &xy_, &xz_, &yz_, &c_}) *a *= factor;
    b_ *= factor;
    return *this;
  }
  QuadricOf& operator+=(const QuadricOf& o) {
    xx_ += o.xx_, yy_ += o.yy_, zz_ += o.zz_, xy_ += o.xy_, xz_ += o.xz_, yz_ += o.yz_;
    b_ += o.b_;
    c_ += o.c_;
    return *this;
  }
  [[nodiscard]] Number operator()(const Vec3& p) const {
    return glm::dot(p, times(p) + Number(2) * b_) + c_;
  }
  /// This function in coordinates whose origin is the point `origin`.
  [[nodiscard]] QuadricOf about(const Vec3& origin) const {
    QuadricOf q = *this;
    const Vec3 moved = times(origin);
    q.b_ += moved;
    q.c_ += glm::dot(moved + Number(2) * b_, origin);
    return q;
  }
  /// The function of x that this one is of `unit` times x.
  [[nodiscard]] QuadricOf stretched(Number unit) const {
    QuadricOf q = *this;
    for (Number* a : {&q.xx_, &q.yy_, &q.zz_, &q.xy_, &q.xz_, &q.yz_}) *a *= unit * unit;
    q.b_ *= unit;
    return q;
  }
  [[nodiscard]] Number trace() const { return xx_ + yy_ + zz_; }
  /// A p: how the function bends along p is dot(p, times(p)).
  [[nodiscard]] Vec3 times(const Vec3& p) const {
    return {xx_ * p.x + xy_ * p.y + xz_ * p.z, xy_ * p.x + yy_ * p.y + yz_ * p.z,
            xz_ * p.x + yz_ * p.y + zz_ * p.z};
  }
  /// Half the gradient.
  [[nodiscard]] Vec3 slope(const Vec3& p) const { return times(p) + b_; }
  /// The minimum of the quadric plus `stay` * |x - anchor|^2, which makes it unique; false where
  /// numbers are too small for it, and `x` is of no use.
  [[nodiscard]] auto minimum(const Vec3& anchor, Number stay, Vec3& x) const {
    using std::abs;
    const Number a = xx_ + stay, d = yy_ + stay, f = zz_ + stay;
    const Number c0 = d * f - yz_ * yz_, c1 = xz_ * yz_ - xy_ * f, c2 = xy_ * yz_ - xz_ * d;
    const Number determinant = a * c0 + xy_ * c1 + xz_ * c2;
    const Number d1 = a * f - xz_ * xz_, d2 = xy_ * xz_ - a * yz_, f2 = a * d - xy_ * xy_;
    const Vec3 r = stay * anchor - b_;
    x = Vec3(c0 * r.x + c1 * r.y + c2 * r.z, c1 * r.x + d1 * r.y + d2 * r.z,
             c2 * r.x + d2 * r.y + f2 * r.z) *
        (Number(1) / determinant);
    return abs(determinant) > std::numeric_limits<Number>::min();
  }

 private:
  template <typename Other>
  friend class QuadricOf;

  Number xx_ = 0, yy_ = 0, zz_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;
  Vec3 b_{Number(0)};
  Number c_ = 0;
};

using Quadric = QuadricOf<double>;
using LocalQuadric = QuadricOf<float>;

}  // namespace aomd
