#include "viewer/drawing/cell_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/measure/volume_statistics.h"
#include "core/mesh/regions_with.h"
#include "core/mesh/side_index.h"
#include "viewer/base/sort_once.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene {
namespace {

constexpr float interior_edge_px = 1.0f;
constexpr double plane_rounding = 1e-3;  // of the distance between plane and section

Color interior_edge_color(Theme theme) {
  const Color opaque = theme == Theme::Light ? plain_line_color() : rgb(0xc3d2e8);
  return (opaque & 0x00ffffffu) | 0x90000000u;
}

using Points = std::vector<CellPoint>;

glm::dvec3 middle(const Points& points) {
  glm::dvec3 sum{0};
  for (const CellPoint& p : points) sum += p.place;
  return sum / static_cast<double>(points.size());
}

void pull(Points& points, const glm::dvec3& center, double part) {
  for (CellPoint& p : points) p.place += part * (center - p.place);
}

/// Its length is twice the area of a plane polygon.
glm::dvec3 normal_of(const Points& polygon) {
  glm::dvec3 normal{0};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    normal +=
        glm::cross(polygon[k].place - polygon[0].place, polygon[k + 1].place - polygon[0].place);
  return normal;
}

double height(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

bool bright(const CellStyle& style, ModelRef model) {
  return style.highlighted_region && *style.highlighted_region == model;
}

/// Where the edges of a region go through the plane, around their middle, as seen from what is cut
/// off. What lies in the plane, but for rounding, counts as cut off: so the side of a region in the
/// plane is drawn for the region that stays, and not for one that only touches the plane.
void cut(const ShapeTemplate& shape, const Points& points, const glm::dvec4& plane, double hair,
         Points& polygon) {
  polygon.clear();
  for (int e = 0; e < shape.edge_count; ++e) {
    const auto& ends = shape.sub(1, e).vertices;
    const CellPoint &a = points[ends[0]], &b = points[ends[1]];
    const double ha = height(plane, a.place), hb = height(plane, b.place);
    if ((ha > hair) == (hb > hair)) continue;
    const double part = std::clamp(ha / (ha - hb), 0.0, 1.0);
    polygon.push_back({a.place + (b.place - a.place) * part,
                       a.value + (b.value - a.value) * static_cast<float>(part)});
  }
  if (polygon.size() < 3) return;
  const glm::dvec3 normal = -glm::normalize(glm::dvec3(plane)), center = middle(polygon);
  const glm::dvec3 aside = std::abs(normal.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
  const auto angle = [&](const CellPoint& p) {
    return std::atan2(glm::dot(p.place - center, v), glm::dot(p.place - center, u));
  };
  std::sort(polygon.begin(), polygon.end(),
            [&](const CellPoint& p, const CellPoint& q) { return angle(p) < angle(q); });
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

CellStyle cell_style(const View& view, const Box& bounds,
                     std::shared_ptr<const ScalarField> field) {
  CellStyle style;
  style.colored = view.coloring == Coloring::Classification;
  style.field_version = field ? field->version : 0;
  style.field = std::move(field);
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
  const float of_region = value_of(region);
  points_.clear();
  for (const std::uint32_t v : mesh_.vertices_of(region, buffer))
    points_.push_back({mesh_.position(Vertex(v)), value_at(Vertex(v), of_region)});
  pull(points_, middle(points_), style_.shrink);
  if (style_.shrink > 0) add_sides(region);
  if (style_.sections()) add_section(region);
}

void CellPainter::add_section(Region region) {
  cut(shape_template(mesh_.shape(region)), points_, *style_.plane, plane_rounding * style_.hair,
      polygon_);
  for (CellPoint& p : polygon_) p.place += glm::dvec3(*style_.plane) * style_.hair;
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
  for (const std::uint32_t v : face.corners())
    polygon_.push_back({mesh_.position(Vertex(v)), value_at(Vertex(v), value_of({}))});
  pull(polygon_, middle(polygon_), style_.shrink);
  add_polygon({}, face.model, false);
}

/// Of a field of regions; NaN where there is none.
float CellPainter::value_of(Region region) const {
  const bool known = region.valid() && style_.field && style_.field->kind == Coloring::Quality;
  return known ? static_cast<float>(measure::smallest_dihedral_deg(mesh_, region))
               : std::numeric_limits<float>::quiet_NaN();
}

float CellPainter::value_at(Vertex corner, float of_region) const {
  const bool by_vertex = style_.field && style_.field->kind == Coloring::Spacing;
  return by_vertex ? style_.field->vertices[corner] : of_region;
}

Color CellPainter::color_at(const CellPoint& point, ModelRef model) const {
  if (style_.field) return style_.field->scale.color(point.value);
  return style_.colored ? color_of(model) : plain_face_color();
}

/// As a fan whose inner lines do not show.
void CellPainter::add_polygon(Region region, ModelRef model, bool bright) {
  if (polygon_.size() < 3) return;
  const glm::dvec3 normal = normal_of(polygon_);
  const double length = glm::length(normal);
  if (!(length > 0)) return;
  const std::uint32_t packed = pack_normal(glm::vec3(normal / length));
  for (std::size_t k = 1; k + 1 < polygon_.size(); ++k) {
    std::uint32_t flags = bright ? highlighted : 0u;
    if (k > 1) flags |= hide_edge_01;
    if (k + 2 < polygon_.size()) flags |= hide_edge_20;
    for (const std::size_t i : {std::size_t{0}, k, k + 1})
      faces_.corners.push_back(
          {glm::vec3(polygon_[i].place - origin_), packed, color_at(polygon_[i], model), flags});
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
