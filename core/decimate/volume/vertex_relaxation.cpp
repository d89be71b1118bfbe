#include "core/decimate/volume/vertex_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void VertexRelaxation::begin(const Mesh& mesh, Vertex v, const Ball& ball) {
  const glm::dvec3 at = mesh.position(v);
  cells_.clear();
  closed_.clear();
  weight_ = 0;
  for (const BallRegion& r : ball)
    cells_.push_back({mesh.position(r.others[0]) - at, mesh.position(r.others[1]) - at,
                      mesh.position(r.others[2]) - at});
}

void VertexRelaxation::add_surface(const Quadric& quadric, double weight) {
  quadric_ = quadric;
  weight_ = weight;
}

// With m the mean of the squared edges and V six volumes, q^-2 = m^3 / (2 V^2).
VertexRelaxation::Slope VertexRelaxation::slope(const glm::dvec3& x) const {
  Slope sum;
  for (const Cell& c : cells_) {
    const double m = squared_edges(x, c.a, c.b, c.c) / 6, v = six_volumes(x, c.a, c.b, c.c);
    const glm::dvec3 of_m = x - (c.a + c.b + c.c) / 3.0;
    const glm::dvec3 of_v = -glm::cross(c.b - c.a, c.c - c.a);
    const double energy = m * m * m / (2 * v * v);
    const glm::dvec3 first = 3 / m * of_m - 2 / v * of_v;  // of the logarithm
    sum.energy += energy;
    sum.first += energy * first;
    sum.second += energy * (glm::outerProduct(first, first) + 3 / m * glm::dmat3(1.0) -
                            3 / (m * m) * glm::outerProduct(of_m, of_m) +
                            2 / (v * v) * glm::outerProduct(of_v, of_v));
  }
  if (weight_ > 0) {
    sum.energy += weight_ * quadric_(x);
    sum.first += 2 * weight_ * quadric_.slope(x);
    for (int k = 0; k < 3; ++k) {
      glm::dvec3 axis(0.0);
      axis[k] = 1;
      sum.second[k] += 2 * weight_ * quadric_.times(axis);
    }
  }
  return sum;
}

double VertexRelaxation::energy(const glm::dvec3& x, double floor) const {
  double sum = weight_ > 0 ? weight_ * quadric_(x) : 0;
  for (const Cell& c : cells_) {
    const double q = tet_shape(x, c.a, c.b, c.c);
    if (!(q > floor)) return infinite;
    sum += 1 / (q * q);
  }
  return sum;
}

double VertexRelaxation::worst_shape(const glm::dvec3& x) const {
  double worst = 1;
  for (const Cell& c : cells_) worst = std::min(worst, tet_shape(x, c.a, c.b, c.c));
  return worst;
}

double VertexRelaxation::worst_dihedral_cosine(const glm::dvec3& x) const {
  double worst = -1;
  for (const Cell& c : cells_) worst = std::max(worst, smallest_dihedral_cosine(x, c.a, c.b, c.c));
  return worst;
}

bool VertexRelaxation::keeps_dihedrals(const glm::dvec3& x) const {
  return !least_dihedral_.binds() || least_dihedral_.allows(worst_dihedral_cosine(x), [&] {
    return worst_dihedral_cosine(glm::dvec3(0.0));
  });
}

// In the directions that are open: the closed ones are made so stiff that nothing moves there, and
// what is left of it is taken away.
glm::dvec3 VertexRelaxation::newton(const Slope& slope) const {
  glm::dmat3 second = slope.second;
  glm::dvec3 first = slope.first;
  const double stiff = 1e3 * (second[0][0] + second[1][1] + second[2][2]);
  for (const glm::dvec3& axis : closed_) {
    first -= glm::dot(axis, first) * axis;
    second += stiff * glm::outerProduct(axis, axis);
  }
  glm::dvec3 step = -(glm::inverse(second) * first);
  for (const glm::dvec3& axis : closed_) step -= glm::dot(axis, step) * axis;
  return glm::dot(step, first) < 0 ? step : glm::dvec3(0.0);
}

bool VertexRelaxation::step(double floor, const glm::dvec3& shift, glm::dvec3& x) const {
  constexpr double least_gain = 1e-3, most_given = 1e-2;  // of the energy
  const Slope here = slope(glm::dvec3(0.0));
  const glm::dvec3 full = newton(here);
  const bool shifts = shift != glm::dvec3(0.0);
  if (full == glm::dvec3(0.0) && !shifts) return false;
  const double least = std::max(0.0, std::min(floor, worst_shape(glm::dvec3(0.0)))),
               most = (shifts ? 1 + most_given : 1 - least_gain) * here.energy;
  for (double share = 1; share > 0.2; share /= 2) {
    x = shift + share * full;
    if (energy(x, least) < most && keeps_dihedrals(x)) return true;
  }
  return false;
}

}  // namespace aomd
