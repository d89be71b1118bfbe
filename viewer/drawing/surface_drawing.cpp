#include "viewer/drawing/surface_drawing.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "viewer/drawing/packed_normals.h"

namespace aomd::scene {
namespace {

constexpr std::size_t items_a_piece = 2048;

/// On a part with a dozen corners they may be large; a thousand of them must not hide the surface.
float vertex_radius_px(const Mesh& mesh) {
  const ClassLists* lists = mesh.class_lists();
  const std::size_t count = lists == nullptr ? 0 : lists->model_count(0);
  return count <= 100 ? 4.0f : count <= 600 ? 2.8f : 1.8f;
}

bool same(const Corner& a, const Corner& b) {
  return a.position == b.position && a.normal == b.normal && a.color == b.color &&
         a.flags == b.flags;
}

/// A scale in steps has no colours in between: each face has the one of its mean. None where the
/// scale is even, or each face has a number of its own.
std::optional<Color> stepped_color(const ScalarField* field, const std::array<Vertex, 3>& corners) {
  if (field == nullptr || field->by_face() || field->scale.steps == 0) return {};
  double sum = 0;
  for (const Vertex v : corners) {
    if (v.index >= field->vertices.size()) return {};
    sum += double{field->vertices[v]};
  }
  return field->scale.color(sum / 3);
}

}  // namespace

void SurfaceDrawing::set_bounds(const Box& bounds) {
  drawable_.bounds = bounds;
  drawable_.origin = bounds.center();
}

SurfaceDrawing::Style SurfaceDrawing::style_of(const Mesh& mesh, const View& view,
                                               bool changed) const {
  Style style{.coloring = view.coloring,
              .hidden = view.hidden,
              .highlighted = view.highlighted,
              .field = field_,
              .field_version = field_ ? field_->version : 0,
              .texture = texture_,
              .texture_version = texture_ ? texture_->version : 0,
              .edge_codes = edge_codes_,
              .plane = {},
              .shrink = whole_faces_ ? view.shrink : 0,
              .vertex_px = changed ? vertex_radius_px(mesh) : style_.vertex_px};
  if (view.clip && view.clip->cells) style.plane = view.clip->plane(drawable_.bounds);
  return style;
}

void SurfaceDrawing::update(const Mesh& mesh, const View& view, const SurfaceChanges& changes) {
  const bool changed = !changes.nothing();
  Style style = style_of(mesh, view, changed);
  const bool restyled = style != style_;
  style_ = std::move(style);
  if (changes.everything) {
    rebuild(mesh);
    return;
  }
  patch(mesh, changes);
  if (restyled) recolor(mesh);
}

Color SurfaceDrawing::color(ModelRef ref) const {
  if (style_.coloring == Coloring::Classification) return color_of(ref);
  return ref.dimension() < 2 ? plain_line_color() : plain_face_color();
}

/// All corners, in pieces that write to places of their own.
void SurfaceDrawing::draw_faces(const Mesh& mesh, std::span<Corner> corners) const {
  const std::vector<std::uint32_t> normals = pack_normals(mesh, items_a_piece);
  parallel_for(mesh.capacity(2), thread_count(0), items_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 std::fill(corners.begin() + static_cast<std::ptrdiff_t>(3 * begin),
                           corners.begin() + static_cast<std::ptrdiff_t>(3 * end), Corner());
                 ModelRef known;
                 Color of_known = color(known);
                 each_alive(mesh.ids(2), begin, end, [&](std::uint32_t id) {
                   if (const ModelRef model = mesh.classification(Face(id)); model != known)
                     of_known = color(known = model);
                   const auto drawn = corners_of(mesh, Face(id), of_known);
                   for (std::size_t i = 0, to = 3 * std::size_t{id}; i < 3; ++i, ++to) {
                     corners[to] = drawn[i];
                     corners[to].normal = normals[to];
                   }
                 });
               });
}

void SurfaceDrawing::rebuild(const Mesh& mesh) {
  const std::size_t size = 3 * std::size_t{mesh.capacity(2)};
  drawable_.corners.resize(size);
  draw_faces(mesh, drawable_.corners.edit(0, size));
  draw_places();
  drawable_.model_edges.assign({});
  drawable_.model_vertices.assign({});
  find_rooms(mesh);
  edge_slots_.clear(mesh.capacity(1));
  vertex_slots_.clear(mesh.capacity(0));
  for (const Edge e : mesh.edges())
    if (mesh.classification(e).dimension() == 1) draw_edge(mesh, e);
  for (const Vertex v : mesh.vertices())
    if (mesh.classification(v).dimension() == 0) draw_vertex(mesh, v);
}

/// Where the corners of all faces are in their pictures.
void SurfaceDrawing::draw_places() {
  drawable_.pictures = style_.texture ? style_.texture->pictures : nullptr;
  if (!style_.texture) {
    if (!drawable_.places.empty()) drawable_.places.assign({});
    return;
  }
  drawable_.places.resize(drawable_.corners.size());
  for (std::uint32_t id = 0; id < drawable_.corners.size() / 3; ++id) draw_places(Face(id));
}

void SurfaceDrawing::draw_places(Face face) {
  const std::size_t first = 3 * std::size_t{face.index};
  if (!style_.texture || first >= drawable_.places.size()) return;
  const PaintedFace painted = style_.texture->of(face.index);
  for (std::size_t i = 0; i < 3; ++i)
    if (drawable_.places[first + i] != painted.at[i])
      drawable_.places.set(first + i, painted.at[i]);
}

void SurfaceDrawing::set_openness(const Mesh& mesh, std::vector<std::uint8_t> openness) {
  openness_ = std::move(openness);
  for (const Face f : mesh.faces()) draw_face(mesh, f);
}

void SurfaceDrawing::recolor(const Mesh& mesh) {
  draw_places();
  for (const Face f : mesh.faces()) draw_face(mesh, f);
  for (const Edge e : mesh.edges()) draw_edge(mesh, e);
  for (const Vertex v : mesh.vertices()) draw_vertex(mesh, v);
}

void SurfaceDrawing::patch(const Mesh& mesh, const SurfaceChanges& changes) {
  if (drawable_.corners.size() < 3 * std::size_t{mesh.capacity(2)})
    drawable_.corners.resize(3 * std::size_t{mesh.capacity(2)});
  if (style_.texture && drawable_.places.size() != drawable_.corners.size()) draw_places();
  for (const Face f : changes.faces) draw_face(mesh, f), draw_places(f);
  for (const Edge e : changes.edges) draw_edge(mesh, e);
  for (const Face f : changes.faces) draw_sides(mesh, f);
  for (const Vertex v : changes.vertices) {
    draw_vertex(mesh, v);
    if (mesh.alive(v)) draw_normals(mesh, v);
  }
}

/// Of a face that is alive, but for the normals, which depend on its neighbours.
std::array<Corner, 3> SurfaceDrawing::corners_of(const Mesh& mesh, Face face,
                                                 Color of_model) const {
  std::array<Corner, 3> corners;
  const ModelRef model = mesh.classification(face);
  const glm::dvec3 center = center_of(mesh, face);
  if (hidden(model) || (whole_faces_ && clipped(center))) return corners;
  const auto pull = static_cast<float>(style_.shrink);
  std::uint32_t flags = face_flags_.empty() ? 0u : face_flags_[face.index];
  if (highlighted(model) || marked(face)) flags |= CornerFlag::highlighted;
  if (style_.edge_codes) flags |= code_flags(mesh, face);
  const PaintedFace painted = style_.texture ? style_.texture->of(face.index) : PaintedFace();
  if (style_.texture && painted.picture <= most_pictures)
    flags |= std::uint32_t{painted.picture} << picture_shift;
  const Color of_face = style_.texture ? painted.color : of_model;
  const auto vertices = mesh.triangle(face);
  const auto stepped = stepped_color(style_.field.get(), vertices);
  for (std::size_t i = 0; i < 3; ++i) {
    glm::vec3 position = place(mesh, vertices[i]);
    if (pull > 0) position = glm::mix(position, glm::vec3(center - drawable_.origin), pull);
    const Color color = stepped        ? *stepped
                        : style_.field ? style_.field->color(face, vertices[i])
                                       : of_face;
    corners[i] = {position, 0, dimmed(color, vertices[i]), flags};
  }
  return corners;
}

void SurfaceDrawing::draw_face(const Mesh& mesh, Face face) {
  const std::size_t first = 3 * std::size_t{face.index};
  if (first >= drawable_.corners.size()) return;  // came and went between two looks
  const bool alive = mesh.alive(face);
  const auto corners =
      alive ? corners_of(mesh, face, color(mesh.classification(face))) : std::array<Corner, 3>();
  for (std::size_t i = 0; i < 3; ++i) {
    Corner corner = corners[i];
    if (alive) corner.normal = drawable_.corners[first + i].normal;
    if (!same(corner, drawable_.corners[first + i])) drawable_.corners.set(first + i, corner);
  }
}

std::uint32_t SurfaceDrawing::code_flags(const Mesh& mesh, Face face) const {
  const auto t = mesh.triangle(face);
  std::uint32_t flags = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Edge e = mesh.find_edge(t[i], t[(i + 1) % 3]);
    const bool known = e.valid() && e.index < style_.edge_codes->size();
    const std::uint32_t code = known ? (*style_.edge_codes)[e] & 15u : unjudged;
    flags |= code << (edge_code_shift + 4 * i);
  }
  return flags;
}

void SurfaceDrawing::recode(const Mesh& mesh, const std::vector<Edge>& edges) {
  for (const Edge e : edges) {
    const auto [a, b] = mesh.edge_vertices(e);
    for (const Face f : mesh.row<2>(a)) {
      const auto t = mesh.triangle(f);
      if (t[0] == b || t[1] == b || t[2] == b) draw_face(mesh, f);
    }
  }
}

void SurfaceDrawing::draw_normals(const Mesh& mesh, Vertex vertex) {
  for (const CornerNormals::Corner& c : normals_.at(mesh, vertex)) {
    const std::size_t i = 3 * std::size_t{c.face.index} + c.slot;
    const std::uint32_t packed = pack_normal(c.normal);
    if (drawable_.corners[i].normal == packed) continue;
    Corner corner = drawable_.corners[i];
    corner.normal = packed;
    drawable_.corners.set(i, corner);
  }
}

}  // namespace aomd::scene
