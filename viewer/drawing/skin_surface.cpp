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
      : mesh_(mesh), style_(style), new_index_(mesh.capacity(0), no_index) {}

  void add(const SkinFace& face) {
    const bool inside = face.has_inside && !style_.hidden_regions.contains(face.inside);
    const bool outside = face.has_outside && !style_.hidden_regions.contains(face.outside);
    const bool loose = !face.has_inside && !face.has_outside;
    if (!loose && !inside && !outside) return;
    if (inside && outside && !style_.interfaces) return;
    polygon_.assign(face.corners().begin(), face.corners().end());
    if (outside && !inside) std::reverse(polygon_.begin(), polygon_.end());
    const bool bright = (inside && style_.highlighted_region == face.inside) ||
                        (outside && style_.highlighted_region == face.outside);
    const ModelRef region = inside ? face.inside : face.outside;
    add_polygon(face.model.dimension() == 2 || loose ? face.model : region, bright);
    faces_.resize(flags_.size(), face.face);
    regions_.resize(flags_.size(), inside ? face.inside_region : face.outside_region);
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
    SkinSurface surface{Mesh(data_), std::move(flags_), std::move(vertices_), std::move(faces_),
                        std::move(regions_)};
    Mesh& mesh = surface.mesh;
    mesh.set(0, 1);
    mesh.set(0, 2);
    if (!named) mark_borders(mesh);
    mesh.keep_class_lists(true);
    return surface;
  }

 private:
  std::uint32_t vertex(std::uint32_t old) {
    std::uint32_t& index = new_index_[old];
    if (index != no_index) return index;
    index = static_cast<std::uint32_t>(data_.positions.size());
    data_.positions.push_back(mesh_.position(Vertex(old)));
    vertices_.emplace_back(old);
    data_.vertex_classes.push_back(mesh_.classification(Vertex(old)));
    return index;
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
    const Request faces_around = mesh.request(1, 2, "drawing");
    for (const Edge e : mesh.edges()) {
      const Row<2> faces = mesh.row<2>(e);
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (mesh.classification(faces[i]) != mesh.classification(faces[0]))
          mesh.set_classification(e, unnamed_border);
    }
  }

  const Mesh& mesh_;
  const SkinStyle& style_;
  std::vector<std::uint32_t> new_index_;
  std::vector<std::uint32_t> polygon_;
  MeshData data_;
  std::vector<std::uint32_t> flags_;
  std::vector<Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<Region> regions_;
};

}  // namespace

SkinSurface make_skin_surface(const Mesh& mesh, const Skin& skin, const SkinStyle& style) {
  SurfaceBuilder builder(mesh, style);
  if (style.faces)
    for (const SkinFace& face : skin.faces()) builder.add(face);
  builder.add_model_edges_and_vertices();
  return builder.finish();
}

}  // namespace aomd::scene
