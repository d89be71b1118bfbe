#pragma once
// The vertices of a surface or a volume in parts of about equal size that lie together, so that
// threads work on several of them at once.

#include <cstddef>
#include <cstdint>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd {

/// How many parts a surface is worth: one below 200,000 faces, else one for 50,000 faces. It
/// follows from the mesh alone.
[[nodiscard]] std::size_t part_count(const Mesh& mesh);

/// Which part each vertex belongs to, and which vertices lie on the seam: next to a vertex of
/// another part, in a volume through a region. A part may edit what lies around vertices that do
/// not (SharedEdits); edits between these never make a new neighbour for one of another part, so
/// that they stay off the seam.
class Partition {
 public:
  /// One part, without a seam.
  Partition() = default;
  static constexpr std::size_t most_parts = 256;

  /// The vertices in the order of a Hilbert curve through the box of the mesh, cut into so many
  /// pieces (`most_parts` at most) of about equal numbers; some may be empty. Cuts of different
  /// numbers run through different places. T(2,0) must be stored, of a volume T(3,0). O(vertices +
  /// faces); the result does not depend on the number of threads.
  Partition(const Mesh& mesh, std::size_t parts, int cut = 0, int threads = 1);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t part_of(Vertex v) const { return count_ == 1 ? 0 : place_[v] >> 1; }
  [[nodiscard]] bool on_seam(Vertex v) const { return count_ > 1 && (place_[v] & 1u) != 0; }
  /// One vertex has taken in another: who has neighbours in two parts now lies on the seam too.
  /// T(0,2) must be stored, of a volume T(0,3). O(faces around the vertex).
  void joined(const Mesh& mesh, Vertex kept);

 private:
  void share_out(const Mesh& mesh, int cut, int threads);
  template <typename Corners>
  [[nodiscard]] bool is_across(const Corners& corners) const;
  template <typename H, typename CornersOf>
  void mark_seams(const Mesh& mesh, const CornersOf& corners_of, int threads);
  template <typename Corners>
  void mark_seam(const Corners& corners);

  std::size_t count_ = 1;
  Column<Vertex, std::uint16_t> place_;  ///< twice the part, plus one on the seam
};

}  // namespace aomd
