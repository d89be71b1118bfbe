#pragma once
// Where values on the corners of faces jump from one face to the next.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/fields/cells.h"

namespace aomd::fields {

/// Faces on both sides of each edge, as far as an array on corners goes on across it. The faces
/// must outlive it.
class Charts {
 public:
  /// The array must have values for every corner of the faces. O(n log n).
  Charts(const Cells& faces, const Attribute& corners);

  /// The face beyond the side from a corner to the next one, or no_index: at a seam, or where other
  /// than two faces meet.
  [[nodiscard]] std::uint32_t beyond(std::size_t corner) const { return beyond_[corner]; }
  /// Edges between two faces where the values jump, smaller vertex first.
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 2>>& seams() const { return seams_; }
  /// A number for each face, the same for all that hang together without a seam between them.
  [[nodiscard]] std::vector<std::uint32_t> numbers() const;

 private:
  struct Side {
    std::array<std::uint32_t, 2> ends{};
    std::uint32_t face = 0;
    std::size_t from = 0, to = 0;  ///< its corners, at the smaller vertex and at the other one
  };
  [[nodiscard]] std::vector<Side> sorted_sides() const;
  [[nodiscard]] static bool jumps(const Attribute& corners, const Side& a, const Side& b);

  const Cells& faces_;
  std::vector<std::uint32_t> beyond_;
  std::vector<std::array<std::uint32_t, 2>> seams_;
};

/// What each corner of the faces stands for: its share of their area.
[[nodiscard]] std::vector<double> corner_measures(const MeshData& mesh);

/// The edges across which an array jumps.
struct NamedSeams {
  std::string array;
  std::vector<std::array<std::uint32_t, 2>> edges;
};
/// Those of each array on corners but normals: those of facets are everywhere.
[[nodiscard]] std::vector<NamedSeams> named_seams(const MeshData& mesh);

/// All of them, sorted.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> all_edges(
    const std::vector<NamedSeams>& seams);
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> seams_of(const MeshData& mesh);

}  // namespace aomd::fields
