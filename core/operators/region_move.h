#pragma once
// Moves of the vertices of tetrahedra (paper, section 3; there V_smooth_ of a volume).

#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/operators/ball.h"
#include "core/operators/verdict.h"

#pragma GCC visibility push(default)

namespace aomd {

/// What a move has to respect.
struct MoveRules {
  TurnLimit max_turn{10.0};   ///< how far the normals of model faces may turn
  LeastAngle least_angle{0};  ///< of a face on a model face, unless it had a smaller one
  LeastAngle least_dihedral{
      0};  ///< of a tetrahedron around it, unless one of them had a smaller one
  const Model* model = nullptr;  ///< new positions on it are snapped to it
  double poor = 0.3;             ///< a worst tet_shape below this is worth an optimisation
};

/// A move that was judged. Belongs to who asks, and is reused: then it allocates nothing.
struct RegionMove {
  Verdict verdict;
  Vertex vertex;
  glm::dvec3 target{0.0};
  Ball ball;                     ///< around the vertex
  Star star;                     ///< the model faces around it
  double before = 0, after = 0;  ///< the worst tet_shape of the ball
  std::uint64_t revision = 0;    ///< of the mesh that was judged
};

/// Judges moves of vertices to where the worst tetrahedron around them is better: to the average of
/// their neighbours (smart Laplacian), where all of them together get no worse or the worst was
/// poor; where the worst stays poor, uphill from there (Freitag, Ollivier-Gooch 1997). Inside a
/// region any way; on a model face so that the volumes on both its sides stay, which is one linear
/// condition; on a model edge along it, where it and the model faces around are straight; on a
/// model vertex not at all.
class RegionMover {
 public:
  explicit RegionMover(const Mesh& mesh) : mark_(mesh.capacity(0), 0) {}

  /// Refusals in this order: Kept (a region around the vertex is no tetrahedron), Classification (a
  /// model vertex, an end of model edges, nothing around it, or the faces around it do not form a
  /// disc), Flat, Angle (a model edge or the faces around it are not straight, or a normal would
  /// turn by more than `max_turn`), Shape (a face would get a smaller angle than `least_angle`
  /// allows, or a tetrahedron than `least_dihedral`), Quality (the shapes would not get better;
  /// number: the smallest dihedral angle of the worst tetrahedron now). T(0,3), T(3,0), T(0,2),
  /// T(2,0) and T(0,1) must be stored, levels 1 and 2 complete or with what lies on model edges and
  /// faces (Mesh::request_listed). Throws as Model::closest.
  Verdict judge(const Mesh& mesh, Vertex v, const MoveRules& rules, RegionMove& plan);

  /// Moves the vertex. The mesh must not have changed since. One journal step.
  static void apply(Mesh& mesh, const RegionMove& plan);

 private:
  /// Which ways a vertex may go: any, across an axis of length 1, or along it.
  struct Freedom {
    int dimension = 3;
    glm::dvec3 axis{0.0};
    [[nodiscard]] glm::dvec3 part_of(const glm::dvec3& way) const;
  };
  /// A tetrahedron of the ball, as a function of where the vertex is.
  struct Cell {
    glm::dvec3 a, b, c;
    [[nodiscard]] double shape(const glm::dvec3& at) const;
    [[nodiscard]] double dihedral_cosine(const glm::dvec3& at) const;
    [[nodiscard]] glm::dvec3 slope(const glm::dvec3& at) const;
  };
  struct Shapes {
    double worst = 1, sum = 0;
  };

  Verdict judge_plan(const Mesh& mesh, const MoveRules& rules, RegionMove& plan);
  Verdict find_freedom(const Mesh& mesh, const MoveRules& rules, const RegionMove& plan);
  Verdict find_way_along(const Mesh& mesh, const MoveRules& rules, const RegionMove& plan);
  Verdict find_way_across(const Mesh& mesh, const RegionMove& plan);
  void average_inside(const Mesh& mesh, const Ball& ball);
  void find_cells(const Mesh& mesh, const Ball& ball);
  [[nodiscard]] Verdict judge_cells(const RegionMove& plan, const glm::dvec3& from,
                                    const glm::dvec3& to, const LeastAngle& least) const;
  [[nodiscard]] Shapes shapes(const glm::dvec3& at) const;
  [[nodiscard]] glm::dvec3 uphill(const glm::dvec3& at, double worst, double nearly);
  [[nodiscard]] double longest_step(const glm::dvec3& at) const;
  /// Goes there where the worst shape grows and the model faces allow it.
  bool go(const Mesh& mesh, const MoveRules& rules, RegionMove& plan, glm::dvec3 to);
  void climb(const Mesh& mesh, const MoveRules& rules, RegionMove& plan);

  Freedom freedom_;
  glm::dvec3 average_{0.0};
  std::vector<Cell> cells_;
  double sum_before_ = 0;           ///< of the shapes around the vertex where it is
  std::vector<glm::dvec3> slopes_;  ///< of the worst cells
  Verdict refusal_;                 ///< of the last place that was better and not allowed
  Column<Vertex, std::uint32_t> mark_;
  std::uint32_t stamp_ = 0;
};

}  // namespace aomd

#pragma GCC visibility pop
