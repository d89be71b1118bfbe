#include "viewer/drawing/selection_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/side_index.h"

namespace aomd::scene {
namespace {

constexpr Color accent = rgb(0xff9f0a);
constexpr Color rim = rgb(0x1b2430);
constexpr float rim_px = 2.2f;  // how much wider the dark line below is
constexpr Color hole = rgb(0xffffff);
// Dashes and gaps as parts of a line, the same from both ends, so that the sides of two faces fall
// together.
constexpr int dashes = 4;
constexpr float gap = 0.12f;
constexpr float dash = (1 - (dashes - 1) * gap) / dashes;

Color with_alpha(Color color, float alpha) {
  return (color & 0x00ffffffu) | static_cast<Color>(std::lround(255.0f * alpha)) << 24;
}

/// Puts one entity into an overlay.
class EntityPainter {
 public:
  EntityPainter(const Mesh& mesh, const OverlayStyle& style, const glm::dvec3& origin,
                Overlay& overlay)
      : mesh_(mesh), style_(style), origin_(origin), overlay_(overlay) {}

  void add(EntityRef e) {
    if (e.dimension == 0) {
      discs_.push_back({place(e.index), style_.color, style_.disc_px});
      if (style_.hollow) discs_.push_back({place(e.index), hole, 0.5f * style_.disc_px});
      return;
    }
    VertexBuffer buffer;
    const auto vertices = mesh_.vertices_of(e, buffer);
    const ShapeTemplate& shape = shape_template(mesh_.shape(e));
    if (e.dimension == 1) add_line(vertices[0], vertices[1]);
    if (e.dimension == 2) add_polygon(vertices);
    for (int k = 0; e.dimension == 3 && k < shape.face_count; ++k)
      add_polygon(SideVertices(shape.sub(2, k), vertices.data()).span());
  }

  void add_line(std::uint32_t a, std::uint32_t b) {
    if (!style_.hollow) {
      lines_.push_back({place(a), place(b), style_.color, style_.line_px});
      return;
    }
    const glm::vec3 from = place(a), along = place(b) - from;
    for (int k = 0; k < dashes; ++k) {
      const float start = static_cast<float>(k) * (dash + gap);
      lines_.push_back(
          {from + start * along, from + (start + dash) * along, style_.color, style_.line_px});
    }
  }

  /// Dark rims below, so that a line reads on every colour.
  void finish() {
    std::vector<Segment> lines;
    for (Segment s : lines_) {
      s.color = rim;
      s.width_px += rim_px;
      lines.push_back(s);
    }
    lines.insert(lines.end(), lines_.begin(), lines_.end());
    append(overlay_.lines, lines);
    append(overlay_.discs, discs_);
    append(overlay_.faces, corners_);
  }

 private:
  template <typename T>
  static void append(Patched<T>& array, const std::vector<T>& items) {
    if (items.empty()) return;
    std::vector<T> all(array.values().begin(), array.values().end());
    all.insert(all.end(), items.begin(), items.end());
    array.assign(std::move(all));
  }
  [[nodiscard]] glm::vec3 place(std::uint32_t v) const {
    return glm::vec3(mesh_.position(Vertex(v)) - origin_);
  }
  void add_polygon(std::span<const std::uint32_t> v) {
    for (std::size_t k = 0; k < v.size(); ++k) add_line(v[k], v[(k + 1) % v.size()]);
    for (std::size_t k = 2; k < v.size(); ++k)
      for (const std::uint32_t corner : {v[0], v[k - 1], v[k]})
        corners_.push_back({place(corner), 0, with_alpha(style_.color, style_.face_alpha), 0});
  }
  const Mesh& mesh_;
  const OverlayStyle& style_;
  glm::dvec3 origin_;
  Overlay& overlay_;
  std::vector<Segment> lines_;
  std::vector<Disc> discs_;
  std::vector<Corner> corners_;
};

}  // namespace

OverlayStyle selected_style() { return {accent, 3.2f, 6.0f, 0.55f}; }
OverlayStyle hovered_style() { return {accent, 2.0f, 4.8f, 0.28f}; }
OverlayStyle marked_style() { return {rgb(0xfff3b0), 1.8f, 4.8f, 0.6f}; }
OverlayStyle deciding_style() { return {rgb(0xe0245e), 2.6f, 6.0f, 0.5f}; }

void draw_entities(const Mesh& mesh, std::span<const EntityRef> entities, const OverlayStyle& style,
                   const glm::dvec3& origin, Overlay& overlay) {
  EntityPainter painter(mesh, style, origin, overlay);
  for (const EntityRef e : entities.first(std::min(entities.size(), most_drawn)))
    if (mesh.alive(e)) painter.add(e);
  painter.finish();
}

void draw_ruler(const Mesh& mesh, const std::array<Vertex, 2>& ends, const glm::dvec3& origin,
                Overlay& overlay) {
  const OverlayStyle style = selected_style();
  EntityPainter painter(mesh, style, origin, overlay);
  painter.add_line(ends[0].index, ends[1].index);
  painter.finish();
}

void draw_cells(const Drawable& drawable, std::span<const Region> regions,
                std::span<const EntityRef> entities, const OverlayStyle& style, Overlay& overlay) {
  if (regions.empty() || entities.empty() || entities.back().dimension != 3) return;
  std::vector<Corner> corners(overlay.faces.values().begin(), overlay.faces.values().end());
  for (std::size_t n = 0; n < regions.size(); ++n) {
    if (!regions[n].valid() ||
        !std::binary_search(entities.begin(), entities.end(), EntityRef(regions[n])))
      continue;
    for (std::size_t i = 3 * n; i < 3 * n + 3; ++i)
      corners.push_back(
          {drawable.cells[i].position, 0, with_alpha(style.color, style.face_alpha), 0});
  }
  overlay.faces.assign(std::move(corners));
}

Box box_of(const Mesh& mesh, std::span<const EntityRef> entities) {
  Box box;
  VertexBuffer buffer;
  for (const EntityRef e : entities) {
    if (e.dimension == 0) box.add(mesh.position(Vertex(e.index)));
    if (e.dimension > 0)
      for (const std::uint32_t v : mesh.vertices_of(e, buffer)) box.add(mesh.position(Vertex(v)));
  }
  return box;
}

glm::dvec3 middle_of(const Mesh& mesh, EntityRef e) {
  if (e.dimension == 0) return mesh.position(Vertex(e.index));
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  glm::dvec3 sum(0.0);
  for (const std::uint32_t v : vertices) sum += mesh.position(Vertex(v));
  return sum / static_cast<double>(vertices.size());
}

}  // namespace aomd::scene
