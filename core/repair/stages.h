#pragma once
// The stages of a repair (core/repair/repair.h), each on the surface as the one before left it.

#include <vector>

#include "core/repair/connectivity.h"
#include "core/repair/repair.h"
#include "core/repair/surface.h"

namespace aomd::repair_detail {

/// Faces that name a vertex twice.
struct RepeatedVertices {
  Tally removed, shrunk, left;
};
[[nodiscard]] RepeatedVertices mend_repeated_vertices(Surface& surface);

/// Faces on the same vertices.
struct Coincident {
  Tally repeated;  ///< removed, one like them stays
  Tally opposite;  ///< removed in pairs
  Tally sheets;    ///< back sides removed from pieces that are listed from both sides
};
[[nodiscard]] Coincident mend_coincident(Surface& surface, bool repeated, bool opposite);

/// Directions of faces.
struct Oriented {
  Tally turned;   ///< faces
  Tally twisted;  ///< the first face of each piece that cannot be oriented
};
[[nodiscard]] Oriented mend_orientation(Surface& surface);

/// The vertices at sides of one face, ascending.
[[nodiscard]] std::vector<std::uint32_t> border_vertices(const Surface& surface);

/// Vertices at the same position, or near each other, taken for one, for the time of a repair.
/// Afterwards each fan of faces gets back a vertex that one of its corners had (mend_fans).
class Weld {
 public:
  /// Does nothing.
  Weld() = default;
  /// Gives all corners the first vertex at their position. Then, in ascending order, a border
  /// vertex goes to the nearest before it within the tolerance that stands for itself, unless a
  /// face has both.
  explicit Weld(Surface& surface, double tolerance);
  [[nodiscard]] bool on() const { return !merged_.empty(); }
  /// The vertex that stands for v.
  [[nodiscard]] std::uint32_t base(std::uint32_t v) const { return on() ? merged_[v] : v; }
  /// True where vertices that become one may move.
  [[nodiscard]] bool moves() const { return moves_; }
  /// Vertices that stay apart since a face would lose a corner.
  [[nodiscard]] const Tally& refused() const { return refused_; }
  /// The vertex that the corner's face had there.
  [[nodiscard]] std::uint32_t given_at(const Surface& surface, std::uint32_t corner) const;

 private:
  // Below this share of the diagonal rounding tells points apart.
  static constexpr double least_tolerance = 1e-15;

  void rename_corners(Surface& surface) const;

  std::vector<std::uint32_t> merged_;
  std::vector<std::uint32_t> given_;  ///< by corner, as the faces lay at first
  Tally refused_;
  bool moves_ = false;
};

/// A tolerance within which most gaps between borders close; 0 where there are none. See survey.h.
[[nodiscard]] double gap_tolerance(const Surface& surface);

/// Fans of faces that become vertices of their own.
struct Split {
  Tally vertices;    ///< that were doubled
  Tally edges;       ///< of three or more faces that are now several; by their first face
  Tally welded;      ///< vertices that others at the same position replace
  Tally kept_edges;  ///< of three or more faces still; by their first face
  std::size_t copies = 0;
  std::size_t cut = 0;  ///< of `edges`, those that were cut open
};
/// `split`: whether fans come apart at all.
[[nodiscard]] Split mend_fans(Surface& surface, const Weld& weld, bool split);

/// Listed edges follow the faces at them, whose corners had the vertices `before`. An edge whose
/// faces have come apart is listed once for each part.
void follow_faces(Surface& surface, const std::vector<std::uint32_t>& before, const Weld& weld);

/// Triangles of exactly zero area.
struct ZeroArea {
  Tally collapsed, swapped, removed, left;
};
[[nodiscard]] ZeroArea mend_zero_area(Surface& surface);

/// True when three points lie on a line, or coincide. Exact.
[[nodiscard]] bool collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Removes pieces with a smaller diagonal than this share of the whole one; tells the first face of
/// each.
[[nodiscard]] Tally remove_small_pieces(Surface& surface, double percent);

/// By vertex: not 0 where a face or a listed edge uses it.
[[nodiscard]] std::vector<std::uint8_t> used_vertices(const MeshData& data);

/// Drops vertices that no face and no listed edge uses and numbers the others anew. After finish().
[[nodiscard]] Tally drop_unused_vertices(MeshData& data);

}  // namespace aomd::repair_detail
