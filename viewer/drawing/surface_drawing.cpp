#include "viewer/drawing/surface_drawing.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "viewer/drawing/crowding.h"
#include "viewer/drawing/step_before.h"

namespace aomd::scene {
namespace {

constexpr float model_edge_px = 2.4f;
constexpr float highlighted_edge_px = 4.6f;
constexpr float highlighted_vertex_px = 6.5f;
constexpr float step_line_px = 2.6f;
constexpr float step_disc_px = 5.0f;
constexpr float marked_line_px = 2.0f;
constexpr float marked_disc_px = 3.0f;
constexpr std::size_t items_a_piece = 2048;
constexpr Color highlight_color = rgb(0xff2f92);
constexpr Color before_color = rgb(0x1f4fd8);

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

template <typename T>
void set_at(Patched<T>& array, std::size_t i, const T& value) {
  if (i >= array.size()) array.resize(i + 1);
  array.set(i, value);
}

glm::dvec3 center_of(const Mesh& mesh, Face f) {
  const auto [a, b, c] = mesh.triangle(f);
  return (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.0;
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

using Side = std::pair<Vertex, Vertex>;

/// The live faces, vertices and sides of faces that a step touched.
struct Touched {
  std::vector<Face> faces;
  std::vector<Vertex> vertices;
  std::map<Side, int> sides;      ///< how many of the faces use each
  std::map<Vertex, int> corners;  ///< likewise
};

Touched touched_by(const Mesh& mesh, const Journal& journal, std::size_t step) {
  Touched result;
  journal.touched(step, step + 1, [&](EntityRef e) {
    if (!mesh.alive(e)) return;
    if (e.dimension == 2) result.faces.emplace_back(e.index);
    if (e.dimension == 0) result.vertices.emplace_back(e.index);
  });
  // A moved vertex takes its faces with it.
  for (const Vertex v : result.vertices)
    for (const Face f : mesh.row<2>(v)) result.faces.push_back(f);
  std::sort(result.faces.begin(), result.faces.end());
  result.faces.erase(std::unique(result.faces.begin(), result.faces.end()), result.faces.end());
  for (const Face f : result.faces) {
    const auto t = mesh.triangle(f);
    for (std::size_t i = 0; i < 3; ++i) {
      ++result.sides[std::minmax(t[i], t[(i + 1) % 3])];
      ++result.corners[t[i]];
    }
  }
  return result;
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

/// Of all corners, face by face. In pieces that write to places of their own.
std::vector<std::uint32_t> SurfaceDrawing::pack_normals(const Mesh& mesh) {
  Column<Face, FaceNormal> faces(mesh.capacity(2));
  parallel_for(
      mesh.capacity(2), thread_count(0), items_a_piece, [&](std::size_t begin, std::size_t end) {
        each_alive(mesh.ids(2), begin, end,
                   [&](std::uint32_t id) { faces[Face(id)] = face_normal(mesh, Face(id)); });
      });
  std::vector<std::uint32_t> packed(3 * std::size_t{mesh.capacity(2)});
  parallel_for(mesh.capacity(0), thread_count(0), items_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 CornerNormals normals(faces);
                 each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
                   for (const CornerNormals::Corner& c : normals.at(mesh, Vertex(id)))
                     packed[3 * std::size_t{c.face.index} + c.slot] = pack_normal(c.normal);
                 });
               });
  return packed;
}

/// All corners, likewise.
void SurfaceDrawing::draw_faces(const Mesh& mesh, std::span<Corner> corners) const {
  const std::vector<std::uint32_t> normals = pack_normals(mesh);
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

void SurfaceDrawing::highlight_step(const Mesh& mesh, const Journal& journal,
                                    std::optional<std::size_t> step, StepSides sides) {
  std::vector<Segment> lines;
  std::vector<Disc> discs;
  drawable_.before.clear();
  const bool shown = step && journal.step(*step).kind != StepKind::Classify;
  if (shown && sides.before) draw_before(mesh, journal, *step, !sides.after);
  if (shown && sides.after) {
    const Touched touched = touched_by(mesh, journal, *step);
    for (const auto& [side, uses] : touched.sides)
      lines.push_back({place(mesh, side.first), place(mesh, side.second), highlight_color,
                       uses > 1 ? 0.6f * step_line_px : step_line_px});
    // The vertex that all the faces share: a collapse's kept end, a smoothing's moved vertex.
    for (const auto& [vertex, uses] : touched.corners)
      if (journal.step(*step).kind != StepKind::Swap &&
          uses == static_cast<int>(touched.faces.size()) && uses > 1)
        discs.push_back({place(mesh, vertex), highlight_color, step_disc_px});
  }
  draw_marked(mesh, lines, discs);
  if (!lines.empty() || !drawable_.highlight_lines.empty())
    drawable_.highlight_lines.assign(std::move(lines));
  if (!discs.empty() || !drawable_.highlight_discs.empty())
    drawable_.highlight_discs.assign(std::move(discs));
}

/// Beside what stands there now only what has gone; alone everything.
void SurfaceDrawing::draw_before(const Mesh& mesh, const Journal& journal, std::size_t step,
                                 bool alone) {
  const StepBefore before = step_before(mesh, journal, step);
  std::vector<Segment> lines;
  std::vector<Disc> discs;
  const auto at = [&](Vertex v) { return glm::vec3(before.position(mesh, v) - drawable_.origin); };
  std::map<Side, int> sides;
  for (const auto& t : before.faces)
    for (std::size_t i = 0; i < 3; ++i) ++sides[std::minmax(t[i], t[(i + 1) % 3])];
  const std::map<Side, int> now =
      alone ? std::map<Side, int>() : touched_by(mesh, journal, step).sides;
  for (const auto& [side, uses] : sides) {
    const bool moved = before.moved.contains(side.first) || before.moved.contains(side.second);
    if (moved || !now.contains(side))
      lines.push_back({at(side.first), at(side.second), before_color,
                       alone && uses == 1 ? step_line_px : 0.7f * step_line_px});
  }
  for (const auto& [vertex, position] : before.moved)
    discs.push_back({glm::vec3(position - drawable_.origin), before_color, 0.8f * step_disc_px});
  drawable_.before.lines.assign(std::move(lines));
  drawable_.before.discs.assign(std::move(discs));
}

void SurfaceDrawing::set_marked(const Mesh& mesh, std::vector<EntityRef> marked) {
  marked_.swap(marked);
  marked_faces_.assign(mesh.capacity(2), false);
  for (const EntityRef e : marked_)
    if (e.dimension == 2) marked_faces_[e.index] = true;
  for (const auto* each : {&marked, &marked_})
    for (const EntityRef e : *each)
      if (e.dimension == 2) draw_face(mesh, Face(e.index));
}

void SurfaceDrawing::draw_marked(const Mesh& mesh, std::vector<Segment>& lines,
                                 std::vector<Disc>& discs) const {
  for (const EntityRef e : marked_) {
    if (!mesh.alive(e)) continue;
    if (e.dimension == 0)
      discs.push_back({place(mesh, Vertex(e.index)), highlight_color, marked_disc_px});
    if (e.dimension != 1) continue;
    const auto [a, b] = mesh.edge_vertices(Edge(e.index));
    lines.push_back({place(mesh, a), place(mesh, b), highlight_color, marked_line_px});
  }
}

}  // namespace aomd::scene
