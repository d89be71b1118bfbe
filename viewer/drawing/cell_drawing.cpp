#include "viewer/drawing/cell_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/mesh/regions_with.h"
#include "core/mesh/side_index.h"
#include "viewer/base/sort_once.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene {
namespace {

constexpr float interior_edge_px = 1.0f;

Color interior_edge_color(Theme theme) {
  const Color opaque = theme == Theme::Light ? plain_line_color() : rgb(0xc3d2e8);
  return (opaque & 0x00ffffffu) | 0x90000000u;
}

using Points = std::vector<glm::dvec3>;

glm::dvec3 middle(const Points& points) {
  glm::dvec3 sum{0};
  for (const glm::dvec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Its length is twice the area of a plane polygon.
glm::dvec3 normal_of(const Points& polygon) {
  glm::dvec3 normal{0};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    normal += glm::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return normal;
}

double height(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

Color region_color(const CellStyle& style, ModelRef model) {
  return style.colored ? color_of(model) : plain_face_color();
}

bool bright(const CellStyle& style, ModelRef model) {
  return style.highlighted_region && *style.highlighted_region == model;
}

/// Where the edges of a region go through the plane, around their middle, as seen from what is cut
/// off.
void cut(const ShapeTemplate& shape, const Points& points, const glm::dvec4& plane,
         Points& polygon) {
  polygon.clear();
  for (int e = 0; e < shape.edge_count; ++e) {
    const auto& ends = shape.sub(1, e).vertices;
    const glm::dvec3 &a = points[ends[0]], &b = points[ends[1]];
    const double ha = height(plane, a), hb = height(plane, b);
    if ((ha >= 0) == (hb >= 0)) continue;
    polygon.push_back(a + (b - a) * (ha / (ha - hb)));
  }
  if (polygon.size() < 3) return;
  const glm::dvec3 normal = -glm::normalize(glm::dvec3(plane)), center = middle(polygon);
  const glm::dvec3 aside = std::abs(normal.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
  const auto angle = [&](const glm::dvec3& p) {
    return std::atan2(glm::dot(p - center, v), glm::dot(p - center, u));
  };
  std::sort(polygon.begin(), polygon.end(),
            [&](const glm::dvec3& p, const glm::dvec3& q) { return angle(p) < angle(q); });
}

EdgeEnds in_order(std::uint32_t a, std::uint32_t b) {
  return {Vertex(std::min(a, b)), Vertex(std::max(a, b))};
}

bool is_behind(const Mesh& mesh, EntityRef e, const CellStyle& style) {
  return style.plane && style.whole && !is_before(mesh, e, *style.plane);
}

bool contains(std::span<const std::uint32_t> vertices, Vertex v) {
  return std::find(vertices.begin(), vertices.end(), v.index) != vertices.end();
}

/// The sides that have only one kept region, of those at an edge.
class OuterSides {
 public:
  /// A side of a kept region.
  void add(std::span<const std::uint32_t> side, const EdgeEnds& ends) {
    if (!contains(side, ends[0]) || !contains(side, ends[1])) return;
    Key key;
    key.fill(no_index);
    std::copy(side.begin(), side.end(), key.begin());
    std::sort(key.begin(), key.end());
    const auto other = std::find(single_.begin(), single_.end(), key);
    if (other == single_.end())
      single_.push_back(key);
    else
      single_.erase(other);
  }
  [[nodiscard]] bool any() const { return !single_.empty(); }

 private:
  using Key = std::array<std::uint32_t, max_face_vertices>;
  std::vector<Key> single_;
};

/// Faces that no region has are part of the outer surface too.
bool on_loose_face(const Mesh& mesh, const EdgeEnds& ends, const CellStyle& style) {
  VertexBuffer buffer;
  for (const Face f : mesh.row<2>(ends[0])) {
    const auto face = mesh.vertices_of(f, buffer);
    if (contains(face, ends[1]) && count_regions_with(mesh, face, 1) == 0 &&
        !is_behind(mesh, f, style))
      return true;
  }
  return false;
}

}  // namespace

CellStyle cell_style(const View& view, const Box& bounds) {
  CellStyle style;
  style.colored = view.coloring == Coloring::Classification;
  for (const ModelRef ref : view.hidden)
    if (ref.dimension() == 3) style.hidden_regions.insert(ref);
  if (view.highlighted && view.highlighted->dimension() == 3)
    style.highlighted_region = view.highlighted;
  if (view.clip) {
    style.plane = view.clip->plane(bounds);
    style.whole = view.clip->cells;
    style.hair = 2 * clip_hair * bounds.diagonal();
  }
  style.shrink = view.shrink;
  style.interior_edges = view.interior_edges;
  style.theme = view.theme;
  return style;
}

bool is_shown(const Mesh& mesh, Region region, const CellStyle& style) {
  return !style.hidden_regions.contains(mesh.classification(region)) &&
         !is_behind(mesh, region, style);
}

void CellPainter::clear() {
  faces_.corners.clear();
  faces_.regions.clear();
}

void CellPainter::add(Region region) {
  if ((style_.shrink <= 0 && !style_.sections()) || !is_shown(mesh_, region, style_)) return;
  VertexBuffer buffer;
  points_.clear();
  for (const std::uint32_t v : mesh_.vertices_of(region, buffer))
    points_.push_back(mesh_.position(Vertex(v)));
  const glm::dvec3 center = middle(points_);
  for (glm::dvec3& p : points_) p += style_.shrink * (center - p);
  if (style_.shrink > 0) add_sides(region);
  if (style_.sections()) add_section(region);
}

void CellPainter::add_section(Region region) {
  cut(shape_template(mesh_.shape(region)), points_, *style_.plane, polygon_);
  for (glm::dvec3& p : polygon_) p += glm::dvec3(*style_.plane) * style_.hair;
  const ModelRef model = mesh_.classification(region);
  add_polygon(region, model, bright(style_, model));
}

/// Files bring regions that are numbered inside out.
void CellPainter::add_sides(Region region) {
  const ShapeTemplate& shape = shape_template(mesh_.shape(region));
  const ModelRef model = mesh_.classification(region);
  const glm::dvec3 center = middle(points_);
  for (int k = 0; k < shape.face_count; ++k) {
    polygon_.clear();
    const SubEntity& side = shape.sub(2, k);
    const auto corners = static_cast<std::size_t>(shape_template(side.shape).vertex_count);
    for (std::size_t i = 0; i < corners; ++i) polygon_.push_back(points_[side.vertices[i]]);
    if (glm::dot(normal_of(polygon_), middle(polygon_) - center) < 0)
      std::reverse(polygon_.begin(), polygon_.end());
    add_polygon(region, model, bright(style_, model));
  }
}

void CellPainter::add_loose(const SkinFace& face) {
  polygon_.clear();
  for (const std::uint32_t v : face.corners()) polygon_.push_back(mesh_.position(Vertex(v)));
  const glm::dvec3 center = middle(polygon_);
  for (glm::dvec3& p : polygon_) p += style_.shrink * (center - p);
  add_polygon({}, face.model, false);
}

/// As a fan whose inner lines do not show.
void CellPainter::add_polygon(Region region, ModelRef model, bool bright) {
  if (polygon_.size() < 3) return;
  const glm::dvec3 normal = normal_of(polygon_);
  const double length = glm::length(normal);
  if (!(length > 0)) return;
  const std::uint32_t packed = pack_normal(glm::vec3(normal / length));
  const Color color = region_color(style_, model);
  for (std::size_t k = 1; k + 1 < polygon_.size(); ++k) {
    std::uint32_t flags = bright ? highlighted : 0u;
    if (k > 1) flags |= hide_edge_01;
    if (k + 2 < polygon_.size()) flags |= hide_edge_20;
    for (const std::size_t i : {std::size_t{0}, k, k + 1})
      faces_.corners.push_back({glm::vec3(polygon_[i] - origin_), packed, color, flags});
    faces_.regions.push_back(region);
  }
}

CellFaces paint_cells(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                      const glm::dvec3& origin) {
  CellPainter painter(mesh, style, origin);
  for (const Region r : mesh.regions()) painter.add(r);
  for (const SkinFace& face : skin.faces())
    if (style.shrink > 0 && !face.has_inside && !face.has_outside) painter.add_loose(face);
  return painter.take();
}

std::vector<EdgeEnds> find_inner_edges(const Mesh& mesh, const Skin& skin, const CellStyle& style) {
  std::vector<EdgeEnds> edges, outer, inner;
  VertexBuffer buffer;
  for (const Region r : mesh.regions()) {
    if (!is_shown(mesh, r, style)) continue;
    const auto vertices = mesh.vertices_of(r, buffer);
    const ShapeTemplate& shape = shape_template(mesh.shape(r));
    for (int e = 0; e < shape.edge_count; ++e) {
      const auto& ends = shape.sub(1, e).vertices;
      edges.push_back(in_order(vertices[ends[0]], vertices[ends[1]]));
    }
  }
  for (const SkinFace& face : skin.faces())
    for (std::size_t k = 0; face.outer() && k < face.count; ++k)
      outer.push_back(in_order(face.vertices[k], face.vertices[(k + 1) % face.count]));
  sort_once(edges);
  sort_once(outer);
  std::set_difference(edges.begin(), edges.end(), outer.begin(), outer.end(),
                      std::back_inserter(inner));
  return inner;
}

bool is_inner_edge(const Mesh& mesh, const EdgeEnds& ends, const CellStyle& style) {
  if (!mesh.alive(ends[0]) || !mesh.alive(ends[1])) return false;
  bool shown = false;
  OuterSides sides;
  VertexBuffer buffer;
  for (const Region r : mesh.row<3>(ends[0])) {
    const auto vertices = mesh.vertices_of(r, buffer);
    const ShapeTemplate& shape = shape_template(mesh.shape(r));
    for (int e = 0; e < shape.edge_count && !shown; ++e) {
      const auto& at = shape.sub(1, e).vertices;
      shown = in_order(vertices[at[0]], vertices[at[1]]) == ends && is_shown(mesh, r, style);
    }
    for (int k = 0; k < shape.face_count && !is_behind(mesh, r, style); ++k)
      sides.add(SideVertices(shape.sub(2, k), vertices.data()).span(), ends);
  }
  return shown && !sides.any() && !on_loose_face(mesh, ends, style);
}

Segment draw_inner_edge(const Mesh& mesh, const EdgeEnds& ends, const CellStyle& style,
                        const glm::dvec3& origin) {
  const auto place = [&](Vertex v) { return glm::vec3(mesh.position(v) - origin); };
  return {place(ends[0]), place(ends[1]), interior_edge_color(style.theme), interior_edge_px};
}

}  // namespace aomd::scene
