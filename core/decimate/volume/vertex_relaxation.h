#pragma once
// Where a vertex of a volume is best: the shape of the tetrahedra around it and the distance of
// model faces from the planes that it stands for, as one energy.

#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/decimate/quadric.h"
#include "core/decimate/volume/region_balance.h"
#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/ball.h"

namespace aomd {

/// The energy of a place for one vertex: for each tetrahedron around it tet_shape to the power -2,
/// plus a quadric. It is convex where all stand upright, since each summand is (Munson 2007), so
/// that Newton's step leads down. Reused, it allocates nothing.
class VertexRelaxation {
 public:
  /// The vertex with the ball around it; positions count from where it is now.
  void begin(const Mesh& mesh, Vertex v, const Ball& ball);
  /// Adds the distance from planes; the quadric is about the vertex.
  void add_surface(const Quadric& quadric, double weight);
  /// Ways that are closed: across each of them, at right angles to each other and of length 1.
  void close(const glm::dvec3& axis) { closed_.push_back(axis); }

  /// Beside the floor: no tetrahedron gets a smaller dihedral angle unless one here has it now.
  /// Stays from one vertex to the next.
  void limit_dihedrals(const LeastAngle& least) { least_dihedral_ = least; }
  [[nodiscard]] bool keeps_dihedrals(const glm::dvec3& x) const;

  /// Fills `x` with a place of less energy, at which no tetrahedron is poorer than `floor` unless
  /// the worst is so now; false where a step down does not lead to one. It is off the open ways by
  /// `shift`, for which a little energy may be given.
  [[nodiscard]] bool step(double floor, const glm::dvec3& shift, glm::dvec3& x) const;
  /// The worst tet_shape at a place.
  [[nodiscard]] double worst_shape(const glm::dvec3& x) const;

 private:
  struct Cell {
    glm::dvec3 a, b, c;
  };
  struct Slope {
    double energy = 0;
    glm::dvec3 first{0.0};
    glm::dmat3 second{0.0};
  };
  [[nodiscard]] Slope slope(const glm::dvec3& x) const;
  [[nodiscard]] double energy(const glm::dvec3& x, double floor) const;
  [[nodiscard]] double worst_dihedral_cosine(const glm::dvec3& x) const;
  [[nodiscard]] glm::dvec3 newton(const Slope& slope) const;

  std::vector<Cell> cells_;
  std::vector<glm::dvec3> closed_;
  Quadric quadric_;
  double weight_ = 0;
  LeastAngle least_dihedral_{0};
};

}  // namespace aomd
