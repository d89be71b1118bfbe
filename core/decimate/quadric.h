#pragma once
// Sums of squared distances to planes and points, as a function of one position (Garland, Heckbert 1997).

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace aomd {

/// x^T A x + 2 b^T x + c with A symmetric: ten numbers.
class Quadric {
 public:
  /// Adds weight * (n.x + d)^2.
  void add_plane(const glm::dvec3& n, double d, double weight) {
    const glm::dvec3 m = weight * n;
    xx_ += m.x * n.x, yy_ += m.y * n.y, zz_ += m.z * n.z;
    xy_ += m.x * n.y, xz_ += m.x * n.z, yz_ += m.y * n.z;
    b_ += d * m;
    c_ += weight * d * d;
  }
  /// Adds weight * |x - p|^2.
  void add_point(const glm::dvec3& p, double weight) {
    xx_ += weight, yy_ += weight, zz_ += weight;
    b_ -= weight * p;
    c_ += weight * glm::dot(p, p);
  }
  Quadric& operator+=(const Quadric& o) {
    xx_ += o.xx_, yy_ += o.yy_, zz_ += o.zz_, xy_ += o.xy_, xz_ += o.xz_, yz_ += o.yz_;
    b_ += o.b_;
    c_ += o.c_;
    return *this;
  }
  [[nodiscard]] double operator()(const glm::dvec3& p) const {
    const double square = xx_ * p.x * p.x + yy_ * p.y * p.y + zz_ * p.z * p.z;
    const double mixed = xy_ * p.x * p.y + xz_ * p.x * p.z + yz_ * p.y * p.z;
    return square + 2 * (mixed + glm::dot(b_, p)) + c_;
  }
  [[nodiscard]] double trace() const { return xx_ + yy_ + zz_; }
  /// The minimum of the quadric plus `stay` * |x - anchor|^2, which makes it unique; false where numbers are
  /// too small for it.
  [[nodiscard]] bool minimum(const glm::dvec3& anchor, double stay, glm::dvec3& x) const {
    const double a = xx_ + stay, d = yy_ + stay, f = zz_ + stay;
    const double c0 = d * f - yz_ * yz_, c1 = xz_ * yz_ - xy_ * f, c2 = xy_ * yz_ - xz_ * d;
    const double determinant = a * c0 + xy_ * c1 + xz_ * c2;
    if (!(std::abs(determinant) > 1e-290)) return false;
    const double d1 = a * f - xz_ * xz_, d2 = xy_ * xz_ - a * yz_, f2 = a * d - xy_ * xy_;
    const glm::dvec3 r = stay * anchor - b_;
    x = glm::dvec3(c0 * r.x + c1 * r.y + c2 * r.z, c1 * r.x + d1 * r.y + d2 * r.z,
                   c2 * r.x + d2 * r.y + f2 * r.z) /
        determinant;
    return true;
  }

 private:
  double xx_ = 0, yy_ = 0, zz_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;
  glm::dvec3 b_{0.0};
  double c_ = 0;
};

}  // namespace aomd
