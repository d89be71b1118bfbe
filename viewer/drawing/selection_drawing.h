#pragma once
// What is selected, hovered or pointed at, as overlays of the picture.

#include <array>
#include <span>

#include "core/mesh/mesh.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// How entities of one role are drawn.
struct OverlayStyle {
  Color color = 0;
  float line_px = 3;
  float disc_px = 5.5f;
  float face_alpha = 0.42f;
  bool hollow = false;  ///< dashed lines and rings: what is not there as such
};
[[nodiscard]] OverlayStyle selected_style();
[[nodiscard]] OverlayStyle hovered_style();
/// What a bar of a histogram counts, of volumes and quads.
[[nodiscard]] OverlayStyle marked_style();
/// What decided against an operation.
[[nodiscard]] OverlayStyle deciding_style();

/// Adds live entities to an overlay: vertices as discs, edges as lines on a dark rim, faces and the
/// sides of regions as tinted areas with their outline. Beyond `most` the rest is left out.
/// O(entities).
void draw_entities(const Mesh& mesh, std::span<const EntityRef> entities, const OverlayStyle& style,
                   const glm::dvec3& origin, Overlay& overlay);
inline constexpr std::size_t most_drawn = 60000;

/// Adds a line of the selection's colour between two vertices.
void draw_ruler(const Mesh& mesh, const std::array<Vertex, 2>& ends, const glm::dvec3& origin,
                Overlay& overlay);

/// Tints the cells of a drawable (sections and shrunken regions, `regions` gives the one of each
/// triangle) that belong to entities. O(cells log(entities)); `entities` are sorted.
void draw_cells(const Drawable& drawable, std::span<const Region> regions,
                std::span<const EntityRef> entities, const OverlayStyle& style, Overlay& overlay);

/// The box around the vertices of entities.
[[nodiscard]] Box box_of(const Mesh& mesh, std::span<const EntityRef> entities);
/// The middle of an entity's vertices.
[[nodiscard]] glm::dvec3 middle_of(const Mesh& mesh, EntityRef e);

}  // namespace aomd::scene
