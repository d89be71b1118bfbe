// Model edges and model vertices of a surface, as lines and dots on it.

#include <algorithm>

#include "viewer/drawing/crowding.h"
#include "viewer/drawing/surface_drawing.h"

namespace aomd::scene {
namespace {

constexpr float model_edge_px = 2.4f;
constexpr float highlighted_edge_px = 4.6f;
constexpr float highlighted_vertex_px = 6.5f;

template <typename T>
void set_at(Patched<T>& array, std::size_t i, const T& value) {
  if (i >= array.size()) array.resize(i + 1);
  array.set(i, value);
}

}  // namespace

/// As they are now: of vertices that come later nothing is known, and none of them fades.
void SurfaceDrawing::find_rooms(const Mesh& mesh) {
  constexpr float limit = 0.03f;  // of the diagonal
  std::vector<Vertex> vertices;
  std::vector<glm::vec3> places;
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 0) {
      vertices.push_back(v);
      places.push_back(place(mesh, v));
    }
  const std::vector<float> found =
      rooms(places, limit * static_cast<float>(drawable_.bounds.diagonal()));
  rooms_.assign(vertices.empty() ? 0 : mesh.capacity(0), 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) rooms_[vertices[i].index] = found[i];
}

/// Where a plane takes whole faces away: whether it took all faces of an edge, or of a vertex.
/// Where no faces are drawn, whether it takes the middle.
bool SurfaceDrawing::in_the_air(const Mesh& mesh, std::span<const Vertex> vertices) const {
  if (!style_.plane) return false;
  bool any = !whole_faces_ && mesh.count(2) > 0;
  for (const Face f : mesh.row<2>(vertices[0])) {
    const auto t = mesh.triangle(f);
    const bool has_all = std::all_of(vertices.begin(), vertices.end(), [&](Vertex v) {
      return std::find(t.begin(), t.end(), v) != t.end();
    });
    if (has_all && !(whole_faces_ && clipped(center_of(mesh, f)))) return false;
    any = any || has_all;
  }
  if (any) return true;
  glm::dvec3 sum(0);
  for (const Vertex v : vertices) sum += mesh.position(v);
  return clipped(sum / static_cast<double>(vertices.size()));
}

void SurfaceDrawing::draw_edge(const Mesh& mesh, Edge edge) {
  const ModelRef model = mesh.alive(edge) ? mesh.classification(edge) : ModelRef();
  if (model.dimension() != 1 || hidden(model) || in_the_air(mesh, mesh.edge_vertices(edge))) {
    const std::uint32_t slot = edge_slots_.find(edge);
    if (slot == Slots<Edge>::none) return;
    drawable_.model_edges.set(slot, {});
    edge_slots_.release(edge);
    return;
  }
  const auto [a, b] = mesh.edge_vertices(edge);
  const bool bright = highlighted(model);
  set_at(drawable_.model_edges, edge_slots_.take(edge),
         Segment{place(mesh, a), place(mesh, b), bright ? highlight_color : color(model),
                 bright ? highlighted_edge_px : model_edge_px});
}

/// Whether model edges and vertices are in the air depends on their faces.
void SurfaceDrawing::draw_sides(const Mesh& mesh, Face face) {
  if (!style_.plane || !mesh.alive(face)) return;
  const auto t = mesh.triangle(face);
  for (std::size_t i = 0; i < 3; ++i) {
    if (const Edge e = mesh.find_edge(t[i], t[(i + 1) % 3]); e.valid()) draw_edge(mesh, e);
    draw_vertex(mesh, t[i]);
  }
}

void SurfaceDrawing::draw_vertex(const Mesh& mesh, Vertex vertex) {
  const ModelRef model = mesh.alive(vertex) ? mesh.classification(vertex) : ModelRef();
  if (model.dimension() != 0 || hidden(model) || in_the_air(mesh, std::span(&vertex, 1))) {
    const std::uint32_t slot = vertex_slots_.find(vertex);
    if (slot == Slots<Vertex>::none) return;
    drawable_.model_vertices.set(slot, {});
    vertex_slots_.release(vertex);
    return;
  }
  const bool bright = highlighted(model);
  const float room = vertex.index < rooms_.size() && !bright ? rooms_[vertex.index] : 0;
  set_at(drawable_.model_vertices, vertex_slots_.take(vertex),
         Disc{place(mesh, vertex), bright ? highlight_color : color(model),
              bright ? highlighted_vertex_px : style_.vertex_px, room});
}

}  // namespace aomd::scene
