#pragma once
// A skin as a mesh of triangles: what draws surfaces then draws it too.

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "viewer/document/skin.h"

namespace aomd::scene {

/// Which part of a skin is shown.
struct SkinStyle {
  std::set<ModelRef> hidden_regions{};  ///< taken away: what they covered shows
  std::optional<ModelRef> highlighted_region{};
  bool faces = true;  ///< the sides of regions and faces at all; else only model edges and vertices
  bool interfaces = true;  ///< faces between two regions that both are there
  friend bool operator==(const SkinStyle&, const SkinStyle&) = default;
};

/// A polygon of a skin as a style shows it.
struct ShownFace {
  std::array<std::uint32_t, max_face_vertices> vertices{};  ///< as seen from outside
  std::uint8_t count = 0;
  ModelRef model;
  bool bright = false;
  Face face;      ///< invalid where the mesh does not have it
  Region region;  ///< behind it; invalid where there is none
};
/// None where the style hides it.
[[nodiscard]] std::optional<ShownFace> shown_face(const SkinFace& face, const SkinStyle& style);

/// Triangles of the skin's polygons, a quad along its shorter diagonal. Stores T(2,0),
/// T(0,1) and T(0,2), and has the model edges and model vertices of the whole mesh; where it has no
/// model edge at all, borders between faces of different classes become unnamed_border. Faces are
/// classified as their model face, else as the region that they bound.
struct SkinSurface {
  Mesh mesh;
  std::vector<std::uint32_t> flags;  ///< CornerFlag by face: hidden diagonals, highlights
  // What each stands for in the mesh that the skin is of; invalid where that has no such entity.
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
  std::vector<Region> regions;   ///< behind the face
  Column<Vertex, Vertex> drawn;  ///< the other way round; invalid where a vertex is not there
  bool named = false;            ///< the mesh has model edges

  /// Whether an edge of the mesh can be seen.
  [[nodiscard]] bool has_edge(Vertex a, Vertex b) const;
};

/// In the order of the skin's polygons. O(skin + vertices + model edges).
[[nodiscard]] SkinSurface make_skin_surface(const Mesh& mesh, const Skin& skin,
                                            const SkinStyle& style);

/// Where there is no model edge: whether faces of different classes meet in an edge of a surface
/// that stores T(0,2).
[[nodiscard]] bool parts_classes(const Mesh& surface, Vertex a, Vertex b);

}  // namespace aomd::scene
