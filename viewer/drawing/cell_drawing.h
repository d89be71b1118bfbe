#pragma once
// What is drawn of the inside of a volume: sections, shrunken regions, inner edges.

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/mesh/mesh.h"
#include "core/operators/collapse_rules.h"
#include "viewer/document/skin.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/scalar_field.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// Which regions are there, and how they look.
struct CellStyle {
  bool colored = true;  ///< by classification
  /// Numbers that give colours instead, by the vertices of the mesh or measured of its regions;
  /// null: none.
  std::shared_ptr<const ScalarField> field{};
  std::uint64_t field_version = 0;
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
[[nodiscard]] CellStyle cell_style(const View& view, const Box& bounds,
                                   std::shared_ptr<const ScalarField> field);

/// Whether a region is not hidden, and not taken away as a whole by the plane.
[[nodiscard]] bool is_shown(const Mesh& mesh, Region region, const CellStyle& style);

/// Triangles of regions, as corners of them.
struct CellFaces {
  std::vector<Corner> corners;  ///< three a triangle
  std::vector<Region> regions;  ///< one a triangle; invalid: a face that no region has
};

/// A corner of a region, of a side of it, or of the cut through it.
struct CellPoint {
  glm::dvec3 place{0};
  float value = 0;  ///< of the field, where there is one
};

/// Draws regions one after the other: the cut through each as a polygon (a region is expected to be
/// convex), a hair inside of what is kept so that the plane does not clip it, or all sides of it,
/// pulled towards its middle. Positions are relative to `origin`.
class CellPainter {
 public:
  CellPainter(const Mesh& mesh, const CellStyle& style, const glm::dvec3& origin)
      : mesh_(mesh), style_(style), origin_(origin) {}
  /// Nothing where it is not shown, or the style draws no cells.
  void add(Region region);
  /// A face that no region has, shrunken likewise.
  void add_loose(const SkinFace& face);
  [[nodiscard]] const CellFaces& faces() const { return faces_; }
  void clear();
  [[nodiscard]] CellFaces take() { return std::move(faces_); }

 private:
  void add_section(Region region);
  void add_sides(Region region);
  void add_polygon(Region region, ModelRef model, bool bright);
  [[nodiscard]] float value_of(Region region) const;
  [[nodiscard]] float value_at(Vertex corner, float of_region) const;
  [[nodiscard]] Color color_at(const CellPoint& point, ModelRef model) const;

  const Mesh& mesh_;
  const CellStyle& style_;
  glm::dvec3 origin_;
  std::vector<CellPoint> points_, polygon_;  ///< scratch
  CellFaces faces_;
};

/// All of them, and the faces of `skin` that no region has. O(regions + skin).
[[nodiscard]] CellFaces paint_cells(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                                    const glm::dvec3& origin);

/// The edges of regions that are on no side of the skin's outer surface, each once, the smaller end
/// first. O(n log n).
[[nodiscard]] std::vector<EdgeEnds> find_inner_edges(const Mesh& mesh, const Skin& skin,
                                                     const CellStyle& style);
/// Whether an edge is one of those, by T(0,2) and T(0,3), which must be stored. O(what is around
/// it).
[[nodiscard]] bool is_inner_edge(const Mesh& mesh, const EdgeEnds& ends, const CellStyle& style);
[[nodiscard]] Segment draw_inner_edge(const Mesh& mesh, const EdgeEnds& ends,
                                      const CellStyle& style, const glm::dvec3& origin);

}  // namespace aomd::scene
