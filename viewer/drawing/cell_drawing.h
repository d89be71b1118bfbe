#pragma once
// What is drawn of the inside of a volume: sections, shrunken regions, inner edges.

#include <optional>
#include <set>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/mesh/mesh.h"
#include "viewer/document/skin.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// Which regions are there, and how they look.
struct CellStyle {
  bool colored = true;  ///< by classification
  std::set<ModelRef> hidden_regions{};
  std::optional<ModelRef> highlighted_region{};
  std::optional<glm::dvec4> plane{};  ///< keeps dot(xyz, p) + w >= 0
  bool whole = false;                 ///< by the middles of regions; else they are cut
  double hair = 0;                    ///< how far inside of the plane a section lies
  double shrink = 0;
  bool interior_edges = false;
  Theme theme = Theme::Light;  ///< what inner edges are seen against

  /// Behind which whole regions are gone.
  [[nodiscard]] std::optional<glm::dvec4> whole_plane() const {
    return whole ? plane : std::optional<glm::dvec4>();
  }
  [[nodiscard]] bool sections() const { return plane && !whole; }
  friend bool operator==(const CellStyle&, const CellStyle&) = default;
};
[[nodiscard]] CellStyle cell_style(const View& view, const Box& bounds);

/// Triangles of regions, as corners of them.
struct CellFaces {
  std::vector<Corner> corners;  ///< three a triangle
  std::vector<Region> regions;  ///< one a triangle; invalid: a face that no region has
  void append(const CellFaces& other);
};

/// The cut through every region, as a polygon of it (which is expected to be convex), a hair inside
/// of what is kept so that the plane does not clip it. Positions are relative to `origin`.
/// O(regions).
[[nodiscard]] CellFaces draw_sections(const Mesh& mesh, const CellStyle& style,
                                      const glm::dvec3& origin);

/// All sides of all regions, and the faces of `skin` that no region has, each pulled towards the
/// middle of its region or face. O(regions + skin).
[[nodiscard]] CellFaces draw_shrunken(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                                      const glm::dvec3& origin);

/// The edges of regions that are on no side of the skin's outer surface, each once. O(n log n).
[[nodiscard]] std::vector<Segment> draw_interior_edges(const Mesh& mesh, const Skin& skin,
                                                       const CellStyle& style,
                                                       const glm::dvec3& origin);

}  // namespace aomd::scene
