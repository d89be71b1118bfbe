#include "viewer/drawing/skin_surface.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "viewer/drawing/drawable.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene {
namespace {

/// Collects triangles, and the vertices that they and the model edges use.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const Mesh& mesh, const SkinStyle& style)
      : mesh_(mesh), style_(style), drawn_(mesh.capacity(0)) {}

  void add(const SkinFace& face) {
    const auto shown = shown_face(face, style_);
    if (!shown) return;
    polygon_.assign(shown->vertices.begin(), shown->vertices.begin() + shown->count);
    add_polygon(shown->model, shown->bright);
    faces_.resize(flags_.size(), shown->face);
    regions_.resize(flags_.size(), shown->region);
  }

  void add_model_edges_and_vertices() {
    for (const Edge e : mesh_.edges()) {
      const ModelRef model = mesh_.classification(e);
      if (model.dimension() != 1) continue;
      VertexBuffer buffer;
      const auto ends = mesh_.vertices_of(e, buffer);
      data_.edges.add(Shape::Line, {vertex(ends[0]), vertex(ends[1])}, model);
    }
    for (const Vertex v : mesh_.vertices())
      if (mesh_.classification(v).dimension() == 0) static_cast<void>(vertex(v.index));
  }

  [[nodiscard]] SkinSurface finish() {
    const bool named = !data_.edges.empty();
    SkinSurface surface{Mesh(data_),
                        std::move(flags_),
                        std::move(vertices_),
                        std::move(faces_),
                        std::move(regions_),
                        std::move(drawn_),
                        named};
    Mesh& mesh = surface.mesh;
    mesh.set(0, 1);
    mesh.set(0, 2);
    if (!named) mark_borders(mesh);
    mesh.keep_class_lists(true);
    return surface;
  }

 private:
  std::uint32_t vertex(std::uint32_t old) {
    Vertex& drawn = drawn_[Vertex(old)];
    if (drawn.valid()) return drawn.index;
    drawn = Vertex(static_cast<std::uint32_t>(data_.positions.size()));
    data_.positions.push_back(mesh_.position(Vertex(old)));
    vertices_.emplace_back(old);
    data_.vertex_classes.push_back(mesh_.classification(Vertex(old)));
    return drawn.index;
  }

  double distance(std::size_t a, std::size_t b) const {
    return glm::length(mesh_.position(Vertex(polygon_[a])) - mesh_.position(Vertex(polygon_[b])));
  }

  /// A fan whose inner lines are not drawn.
  void add_polygon(ModelRef model, bool bright) {
    if (polygon_.size() == 4 && distance(1, 3) < distance(0, 2))
      std::rotate(polygon_.begin(), polygon_.begin() + 1, polygon_.end());
    const std::size_t last = polygon_.size() - 1;
    for (std::size_t k = 1; k < last; ++k) {
      data_.faces.vertices.insert(
          data_.faces.vertices.end(),
          {vertex(polygon_[0]), vertex(polygon_[k]), vertex(polygon_[k + 1])});
      data_.faces.shapes.push_back(Shape::Triangle);
      data_.faces.classes.push_back(model);
      std::uint32_t flags = bright ? highlighted : 0u;
      if (k > 1) flags |= hide_edge_01;
      if (k + 1 < last) flags |= hide_edge_20;
      flags_.push_back(flags);
    }
  }

  static void mark_borders(Mesh& mesh) {
    for (const Edge e : mesh.edges()) {
      const auto [a, b] = mesh.edge_vertices(e);
      if (parts_classes(mesh, a, b)) mesh.set_classification(e, unnamed_border);
    }
  }

  const Mesh& mesh_;
  const SkinStyle& style_;
  Column<Vertex, Vertex> drawn_;
  std::vector<std::uint32_t> polygon_;
  MeshData data_;
  std::vector<std::uint32_t> flags_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Region> regions_;
};

}  // namespace

std::optional<ShownFace> shown_face(const SkinFace& face, const SkinStyle& style) {
  const bool inside = face.has_inside && !style.hidden_regions.contains(face.inside);
  const bool outside = face.has_outside && !style.hidden_regions.contains(face.outside);
  const bool loose = !face.has_inside && !face.has_outside;
  if (!loose && !inside && !outside) return {};
  if (inside && outside && !style.interfaces) return {};
  ShownFace shown{face.vertices, face.count, {}, false, face.face, {}};
  if (outside && !inside)
    std::reverse(shown.vertices.begin(), shown.vertices.begin() + shown.count);
  shown.bright = (inside && style.highlighted_region == face.inside) ||
                 (outside && style.highlighted_region == face.outside);
  shown.region = inside ? face.inside_region : face.outside_region;
  const ModelRef region = inside ? face.inside : face.outside;
  shown.model = face.model.dimension() == 2 || loose ? face.model : region;
  return shown;
}

bool SkinSurface::has_edge(Vertex a, Vertex b) const {
  if (std::max(a, b).index >= drawn.size() || !drawn[a].valid() || !drawn[b].valid()) return false;
  return mesh.find_edge(drawn[a], drawn[b]).valid();
}

bool parts_classes(const Mesh& surface, Vertex a, Vertex b) {
  std::optional<ModelRef> first;
  for (const Face f : surface.row<2>(a)) {
    const auto t = surface.triangle(f);
    if (std::find(t.begin(), t.end(), b) == t.end()) continue;
    if (first && *first != surface.classification(f)) return true;
    first = surface.classification(f);
  }
  return false;
}

SkinSurface make_skin_surface(const Mesh& mesh, const Skin& skin, const SkinStyle& style) {
  SurfaceBuilder builder(mesh, style);
  if (style.faces)
    for (const SkinFace& face : skin.faces()) builder.add(face);
  builder.add_model_edges_and_vertices();
  return builder.finish();
}

}  // namespace aomd::scene
