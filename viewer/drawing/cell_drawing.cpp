#include "viewer/drawing/cell_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

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

/// Draws polygons as fans whose inner lines do not show.
class PolygonDrawing {
 public:
  explicit PolygonDrawing(const glm::dvec3& origin) : origin_(origin) {}

  void add(const Points& polygon, Region region, Color color, bool bright) {
    if (polygon.size() < 3) return;
    const glm::dvec3 normal = normal_of(polygon);
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    const std::uint32_t packed = pack_normal(glm::vec3(normal / length));
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      std::uint32_t flags = bright ? highlighted : 0u;
      if (k > 1) flags |= hide_edge_01;
      if (k + 2 < polygon.size()) flags |= hide_edge_20;
      for (const std::size_t i : {std::size_t{0}, k, k + 1})
        faces_.corners.push_back({glm::vec3(polygon[i] - origin_), packed, color, flags});
      faces_.regions.push_back(region);
    }
  }
  [[nodiscard]] CellFaces take() { return std::move(faces_); }

 private:
  glm::dvec3 origin_;
  CellFaces faces_;
};

/// Visits the regions that are there, with their vertices where shrinking has put them.
template <typename Visit>
void each_region(const Mesh& mesh, const CellStyle& style, Visit&& visit) {
  VertexBuffer buffer;
  Points points;
  for (const Region r : mesh.regions()) {
    if (style.hidden_regions.contains(mesh.classification(r))) continue;
    const auto vertices = mesh.vertices_of(r, buffer);
    points.clear();
    for (const std::uint32_t v : vertices) points.push_back(mesh.position(Vertex(v)));
    const glm::dvec3 center = middle(points);
    if (style.plane && style.whole && height(*style.plane, center) < 0) continue;
    for (glm::dvec3& p : points) p += style.shrink * (center - p);
    visit(r, vertices, points);
  }
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

using Ends = std::pair<std::uint32_t, std::uint32_t>;

void make_unique(std::vector<Ends>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
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

void CellFaces::append(const CellFaces& other) {
  corners.insert(corners.end(), other.corners.begin(), other.corners.end());
  regions.insert(regions.end(), other.regions.begin(), other.regions.end());
}

CellFaces draw_sections(const Mesh& mesh, const CellStyle& style, const glm::dvec3& origin) {
  PolygonDrawing drawing(origin);
  const glm::dvec3 inward = glm::dvec3(*style.plane) * style.hair;
  Points polygon;
  each_region(mesh, style, [&](Region r, std::span<const std::uint32_t>, const Points& points) {
    cut(shape_template(mesh.shape(r)), points, *style.plane, polygon);
    if (polygon.size() < 3) return;
    for (glm::dvec3& p : polygon) p += inward;
    const ModelRef model = mesh.classification(r);
    drawing.add(polygon, r, region_color(style, model), bright(style, model));
  });
  return drawing.take();
}

CellFaces draw_shrunken(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                        const glm::dvec3& origin) {
  PolygonDrawing drawing(origin);
  Points polygon;
  each_region(mesh, style, [&](Region r, std::span<const std::uint32_t>, const Points& points) {
    const ShapeTemplate& shape = shape_template(mesh.shape(r));
    const ModelRef model = mesh.classification(r);
    const glm::dvec3 center = middle(points);
    for (int k = 0; k < shape.face_count; ++k) {
      polygon.clear();
      const SubEntity& side = shape.sub(2, k);
      const auto corners = static_cast<std::size_t>(shape_template(side.shape).vertex_count);
      for (std::size_t i = 0; i < corners; ++i) polygon.push_back(points[side.vertices[i]]);
      // Files bring regions that are numbered inside out.
      if (glm::dot(normal_of(polygon), middle(polygon) - center) < 0)
        std::reverse(polygon.begin(), polygon.end());
      drawing.add(polygon, r, region_color(style, model), bright(style, model));
    }
  });
  for (const SkinFace& face : skin.faces()) {
    if (face.has_inside || face.has_outside) continue;
    polygon.clear();
    for (const std::uint32_t v : face.corners()) polygon.push_back(mesh.position(Vertex(v)));
    const glm::dvec3 center = middle(polygon);
    for (glm::dvec3& p : polygon) p += style.shrink * (center - p);
    drawing.add(polygon, Region(), region_color(style, face.model), false);
  }
  return drawing.take();
}

std::vector<Segment> draw_interior_edges(const Mesh& mesh, const Skin& skin, const CellStyle& style,
                                         const glm::dvec3& origin) {
  std::vector<Ends> edges, outer, inner;
  each_region(mesh, style, [&](Region r, std::span<const std::uint32_t> vertices, const Points&) {
    const ShapeTemplate& shape = shape_template(mesh.shape(r));
    for (int e = 0; e < shape.edge_count; ++e) {
      const auto& ends = shape.sub(1, e).vertices;
      edges.push_back(std::minmax({vertices[ends[0]], vertices[ends[1]]}));
    }
  });
  for (const SkinFace& face : skin.faces())
    for (std::size_t k = 0; face.outer() && k < face.count; ++k)
      outer.push_back(std::minmax({face.vertices[k], face.vertices[(k + 1) % face.count]}));
  make_unique(edges);
  make_unique(outer);
  std::set_difference(edges.begin(), edges.end(), outer.begin(), outer.end(),
                      std::back_inserter(inner));
  std::vector<Segment> lines;
  lines.reserve(inner.size());
  const auto place = [&](std::uint32_t v) { return glm::vec3(mesh.position(Vertex(v)) - origin); };
  const Color color = interior_edge_color(style.theme);
  for (const auto& [a, b] : inner) lines.push_back({place(a), place(b), color, interior_edge_px});
  return lines;
}

}  // namespace aomd::scene
