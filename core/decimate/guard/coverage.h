#pragma once
// The guarantee that a decimated volume stays near each vertex of its original: the other half of
// what DistanceGuard holds.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/decimate/guard/surface_change.h"
#include "core/mesh/column.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Points of model entities of one dimension, each with the cell of the present mesh that stands
/// for it: the nearest one on the same model entity, as far as the cells of an operation tell.
class CoveredPoints {
 public:
  /// A face, or an edge as a triangle (a, b, b).
  struct Cell {
    std::uint32_t id = no_index;
    ModelRef model;
    Triangle corners;
  };

  void add(ModelRef model, const glm::dvec3& at) { points_.push_back({at, model}); }
  /// Each point gets the nearest of these cells. O(n log n).
  void attach(std::span<const Cell> cells);

  /// The distance of a point of the replaced cells that no cell comes within `distance` of, nor as
  /// close as the one that stood for it; 0 where there is none.
  [[nodiscard]] double uncovered(std::span<const std::uint32_t> replaced,
                                 std::span<const Cell> cells, double distance) const;
  /// The points of the replaced cells get the nearest of these.
  void hand_over(std::span<const std::uint32_t> replaced, std::span<const Cell> cells);

 private:
  struct Point {
    glm::dvec3 at{0.0};
    ModelRef model;
    std::uint32_t next = no_index;  ///< of the same cell
    double distance2 = 0;           ///< to its cell
  };
  void put(std::uint32_t point, std::uint32_t cell);

  std::vector<Point> points_;
  std::vector<std::uint32_t> first_;  ///< by cell
};

/// Asked before each operation and told of each that was made, it keeps every vertex of the
/// original within a distance of the same model face, and of the same model edge, in the result.
class Coverage {
 public:
  /// Copies the places of the vertices. T(2,0) must be stored. O(n log n); about 60 bytes for each
  /// vertex and model face that it bounds.
  Coverage(const Mesh& original, double distance);
  /// The mesh was changed from outside.
  void restart(const Mesh& mesh);

  /// Accepts where all that the replaced faces and pieces stand for is near what takes their place,
  /// or what stays around the vertex; what was further off before may stay as far. Else
  /// Reason::Distance with a face, or the vertex of a model edge, and the distance. About 5 us.
  [[nodiscard]] Verdict judge(const Change& change);
  /// The operation was made.
  void applied(const Change& change);

 private:
  void gather(const Change& change);

  double distance_;
  CoveredPoints on_faces_, on_edges_;
  std::vector<CoveredPoints::Cell> faces_, edges_;  ///< that may stand for points after the change
  std::vector<std::uint32_t> old_faces_, old_edges_;
};

}  // namespace aomd
