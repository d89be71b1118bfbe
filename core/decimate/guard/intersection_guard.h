#pragma once
// The guarantee that a decimation lets the surface cut itself nowhere.

#include <cstdint>
#include <span>
#include <vector>

#include "core/decimate/guard/face_tree.h"
#include "core/decimate/guard/surface_change.h"
#include "core/operators/verdict.h"

namespace aomd {

/// Asked before each operation, and told of each that was made, it keeps the number of intersecting
/// pairs of faces (measure::self_intersections) from growing: none where the surface starts with
/// none. Where it cuts itself from the start, an operation may keep or take away what is there, and
/// trade one cut for another, but adds none.
class IntersectionGuard {
 public:
  /// Starts from the mesh as it is; T(2,0) is stored. O(n log n); about 170 bytes a face.
  explicit IntersectionGuard(const Mesh& mesh) : tree_(mesh), stamps_(mesh.capacity(2), 0) {}

  /// Accepts where the created faces cut the other faces and each other in no more pairs than those
  /// that they replace do. Else Reason::Intersection with a face that would be cut. Exact. About 8
  /// us.
  [[nodiscard]] Verdict judge(const Change& change);

  /// The operation was made. O(faces of the change * log n).
  void applied(const Change& change);

 private:
  struct Piece {
    Triangle corners;
    Box box;
    Face face;
  };
  struct Other {
    const FaceTree::Item* item;
    const Box* box;
  };
  void take(Face face, const Triangle& corners);
  void mark(std::span<const Face> faces);
  void find_others(const Change& change);
  [[nodiscard]] std::size_t cuts(std::size_t limit, Face& cut) const;
  [[nodiscard]] std::size_t cuts_now(const Change& change);

  FaceTree tree_;
  Column<Face, std::uint32_t> stamps_;  ///< == stamp_ for the faces that are replaced
  std::uint32_t stamp_ = 0;
  std::vector<Piece> pieces_;  ///< faces of the change that have area
  std::vector<Other> others_;  ///< faces near them that stay
};

}  // namespace aomd
