#pragma once
// The model edges that a decimation started from, as points, and the pieces of the present ones
// that they lie on.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/decimate/quadric.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// A vertex inside a curve, present or to be, between the vertices to either side; where it is the
/// end of the curve only one of these is there. The pieces of the curve around it have the points.
struct CurvePlace {
  std::array<std::uint32_t, 3> pieces{no_index, no_index, no_index};
  std::array<Vertex, 2> far;  ///< invalid where the curve ends at the vertex itself
};

/// How far the points of an original curve are from the present one: the sum of their squared
/// distances by the lengths that they stand for, and the sum of these.
struct CurveError {
  double squares = 0, length = 0;
};

/// The original's model edges: a point at each of its vertices and in the middle of each of its
/// edges, by Simpson's weights, so that straight parts are measured exactly. A curve stays a chain:
/// a collapse joins two pieces of it, and its points stay between the same neighbours. Empty where
/// the mesh has no model edges.
class OriginalCurves {
 public:
  /// O(edges). T(1,0) must be stored. Where a collapse leaves a piece with more than `most_points`,
  /// points close to each other become one, so that none costs more than that: enough to say how
  /// far a curve turns.
  explicit OriginalCurves(const Mesh& mesh, std::uint32_t most_points = no_index);

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  /// A vertex between two pieces of one curve, and of this alone: it may move along it and go.
  [[nodiscard]] bool inside(Vertex v) const;
  /// Whether a piece of a curve joins two vertices. If so, what is around the one that both become,
  /// where an end that is not inside a curve stays.
  [[nodiscard]] bool between(Vertex v, Vertex w, CurvePlace& place) const;
  /// What is around a vertex inside a curve.
  [[nodiscard]] CurvePlace around(Vertex v) const;
  /// The other ends of the pieces at a vertex inside a curve.
  [[nodiscard]] std::array<Vertex, 2> neighbours(Vertex v) const;

  /// What the points around a place stand for: CurveError::length, wherever its vertex is.
  [[nodiscard]] double length(const CurvePlace& place) const;
  /// The error around a place whose vertex is at `x`.
  [[nodiscard]] CurveError error(const Mesh& mesh, const CurvePlace& place,
                                 const glm::dvec3& x) const;
  /// The same, nearly, as a function of where the vertex goes from `x`: distances across the pieces
  /// count, those along them do not.
  [[nodiscard]] Quadric quadric(const Mesh& mesh, const CurvePlace& place,
                                const glm::dvec3& x) const;

  /// The cosine of what the curve turns around a place whose vertex is at `x`: the most by which
  /// the arc over a piece, from its ends through a point of the original, turns at these.
  [[nodiscard]] double turn_cosine(const Mesh& mesh, const CurvePlace& place,
                                   const glm::dvec3& x) const;

  /// A collapse of a piece was made.
  void merged(const Mesh& mesh, Vertex deleted, Vertex kept);
  /// Gives each point to the nearer one of the two pieces beside it. O(points).
  void locate(const Mesh& mesh);
  /// The mesh is another one: finds all pieces anew, and the nearest one of its curve for every
  /// point. O(points log pieces).
  void locate_anywhere(const Mesh& mesh);

 private:
  struct Point {
    glm::dvec3 position;
    double length;  ///< that it stands for
    ModelRef curve;
    std::uint32_t next = no_index;  ///< the next point of its piece
  };
  struct Piece {
    std::array<Vertex, 2> ends;
    ModelRef curve;
    std::uint32_t first = no_index;  ///< its first point
  };
  struct Node {
    std::array<std::uint32_t, 2> pieces{no_index, no_index};
    bool inside = false;
  };

  void find_pieces(const Mesh& mesh);
  void add_piece(const Mesh& mesh, Vertex v, std::uint32_t piece);
  void add_points(const Mesh& mesh);
  void add_point(std::uint32_t piece, std::uint32_t point);
  void share_out(const Mesh& mesh, const CurvePlace& place, Vertex v);
  void join_points(std::uint32_t piece);
  [[nodiscard]] std::uint32_t piece_between(Vertex v, Vertex w) const;
  [[nodiscard]] std::uint32_t other_piece(Vertex v, std::uint32_t piece) const;
  [[nodiscard]] Vertex far_end(std::uint32_t piece, Vertex v) const;
  template <typename Visit>
  void for_points(const CurvePlace& place, Visit&& visit) const;

  std::uint32_t most_points_;
  std::vector<Point> points_;
  std::vector<Piece> pieces_;
  std::vector<Node> nodes_;
  Column<Vertex, std::uint32_t> node_of_;  ///< no_index: on no curve
};

}  // namespace aomd
