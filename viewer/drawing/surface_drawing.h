#pragma once
// Fills a Drawable from a mesh and keeps it in step, touching no more than what changed.

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "core/mesh/column.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/corner_normals.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/edge_codes.h"
#include "viewer/drawing/scalar_field.h"
#include "viewer/drawing/surface_texture.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

inline constexpr Color highlight_color = rgb(0xff2f92);

/// Places of an array for entities that come and go: the place of a dead one is given to the next.
template <typename H>
class Slots {
 public:
  static constexpr std::uint32_t none = no_index;
  void clear(std::size_t capacity) {
    slot_.assign(capacity, none);
    free_.clear();
    used_ = 0;
  }
  [[nodiscard]] std::uint32_t find(H h) const { return h.index < slot_.size() ? slot_[h] : none; }
  std::uint32_t take(H h) {
    if (h.index >= slot_.size()) slot_.resize(h.index + 1, none);
    if (slot_[h] == none) slot_[h] = free_.empty() ? used_++ : pop();
    return slot_[h];
  }
  void release(H h) {
    free_.push_back(slot_[h]);
    slot_[h] = none;
  }

 private:
  std::uint32_t pop() {
    const std::uint32_t last = free_.back();
    free_.pop_back();
    return last;
  }
  Column<H, std::uint32_t> slot_;
  std::vector<std::uint32_t> free_;
  std::uint32_t used_ = 0;
};

[[nodiscard]] inline glm::dvec3 center_of(const Mesh& mesh, Face f) {
  const auto [a, b, c] = mesh.triangle(f);
  return (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.0;
}

/// Face f is drawn in slot f. The mesh must store T(0,1), T(0,2) and T(2,0).
class SurfaceDrawing {
 public:
  /// The box of the mesh as it was loaded: it gives the origin, and a camera that does not move.
  void set_bounds(const Box& bounds);
  /// CornerFlag by face, for all faces or none: lines that are not drawn, faces that are bright.
  void set_face_flags(std::vector<std::uint32_t> flags) { face_flags_ = std::move(flags); }
  void set_face_flags(Face face, std::uint32_t flags) {
    if (face.index >= face_flags_.size()) face_flags_.resize(face.index + std::size_t{1}, 0);
    face_flags_[face.index] = flags;
  }
  /// What is said about each edge, for the flags of its faces; null: nothing. Drawn from the next
  /// update on.
  void set_edge_codes(std::shared_ptr<const EdgeCodes> codes) { edge_codes_ = std::move(codes); }
  /// These codes have changed in place. O(edges).
  void recode(const Mesh& mesh, const std::vector<Edge>& edges);
  /// Numbers that give colours instead of model faces; null: none. Drawn from the next update on.
  void set_field(std::shared_ptr<const ScalarField> field) { field_ = std::move(field); }
  /// Pictures on faces instead of these colours; null: none. Drawn from the next update on.
  void set_texture(std::shared_ptr<const SurfaceTexture> texture) { texture_ = std::move(texture); }
  /// How open the surface lies at each vertex, by id: see openness.h; empty: fully. O(size).
  void set_openness(const Mesh& mesh, std::vector<std::uint8_t> openness);
  [[nodiscard]] bool has_openness() const { return !openness_.empty(); }
  /// Whether faces are whole: those of a skin are parts of regions, which somebody else clips and
  /// shrinks.
  void set_whole_faces(bool whole) { whole_faces_ = whole; }
  /// Brightens faces, edges and vertices; those of the last call are as before. O(entities), and
  /// drawn from the next highlight_step() on where they are edges or vertices.
  void set_marked(const Mesh& mesh, std::vector<EntityRef> marked);
  /// O(changes); O(size) when everything changed, or when colours, hidden or highlighted entities
  /// did.
  void update(const Mesh& mesh, const View& view, const SurfaceChanges& changes);
  /// Highlights what the last applied step has left of what it touched, with lines around its faces
  /// and a dot on its vertex, and what stood there before it, in another colour. O(its records).
  void highlight_step(const Mesh& mesh, const Journal& journal, std::optional<std::size_t> step,
                      StepSides sides = {});

  [[nodiscard]] const Drawable& drawable() const { return drawable_; }
  /// For the one who uploads, to make it clean.
  [[nodiscard]] Drawable& drawable() { return drawable_; }

 private:
  /// What colours depend on besides the mesh.
  struct Style {
    Coloring coloring = Coloring::Classification;
    std::set<ModelRef> hidden;
    std::optional<ModelRef> highlighted;
    std::shared_ptr<const ScalarField> field;
    std::uint64_t field_version = 0;
    std::shared_ptr<const SurfaceTexture> texture;
    std::uint64_t texture_version = 0;
    std::shared_ptr<const EdgeCodes> edge_codes;
    std::optional<glm::dvec4> plane;  ///< behind it faces are hidden as a whole
    double shrink = 0;
    float vertex_px = 0;  ///< radius of model vertices: smaller where there are very many
    friend bool operator==(const Style&, const Style&) = default;
  };
  void rebuild(const Mesh& mesh);
  void recolor(const Mesh& mesh);
  [[nodiscard]] Style style_of(const Mesh& mesh, const View& view, bool changed) const;
  void patch(const Mesh& mesh, const SurfaceChanges& changes);
  [[nodiscard]] std::array<Corner, 3> corners_of(const Mesh& mesh, Face face, Color of_model) const;
  void draw_faces(const Mesh& mesh, std::span<Corner> corners) const;
  void draw_face(const Mesh& mesh, Face face);
  void draw_places();
  void draw_places(Face face);
  void draw_edge(const Mesh& mesh, Edge edge);
  void draw_sides(const Mesh& mesh, Face face);
  void draw_vertex(const Mesh& mesh, Vertex vertex);
  [[nodiscard]] std::uint32_t code_flags(const Mesh& mesh, Face face) const;
  void draw_before(const Mesh& mesh, const Journal& journal, std::size_t step, bool alone);
  void draw_marked(const Mesh& mesh, std::vector<Segment>& lines, std::vector<Disc>& discs) const;
  void draw_normals(const Mesh& mesh, Vertex vertex);
  [[nodiscard]] bool hidden(ModelRef ref) const { return style_.hidden.contains(ref); }
  [[nodiscard]] bool highlighted(ModelRef ref) const {
    return style_.highlighted == ref && ref.valid();
  }
  [[nodiscard]] Color color(ModelRef ref) const;
  void find_rooms(const Mesh& mesh);
  [[nodiscard]] Color dimmed(Color color, Vertex v) const {
    if (v.index >= openness_.size()) return color;
    return (color & 0x00ffffffu) | std::uint32_t{openness_[v.index]} << 24;
  }
  [[nodiscard]] bool marked(Face face) const {
    return face.index < marked_faces_.size() && marked_faces_[face.index];
  }
  /// Behind the plane as a whole: a face by its middle.
  [[nodiscard]] bool clipped(const glm::dvec3& center) const {
    return style_.plane && glm::dot(glm::dvec3(*style_.plane), center) + style_.plane->w < 0;
  }
  [[nodiscard]] bool in_the_air(const Mesh& mesh, std::span<const Vertex> vertices) const;
  [[nodiscard]] glm::vec3 place(const Mesh& mesh, Vertex v) const {
    return glm::vec3(mesh.position(v) - drawable_.origin);
  }

  std::vector<std::uint32_t> face_flags_;
  std::shared_ptr<const EdgeCodes> edge_codes_;
  std::shared_ptr<const ScalarField> field_;
  std::shared_ptr<const SurfaceTexture> texture_;
  bool whole_faces_ = true;
  std::vector<EntityRef> marked_;
  std::vector<bool> marked_faces_;      ///< by id; empty: none
  std::vector<std::uint8_t> openness_;  ///< by vertex id; empty: 255
  std::vector<float> rooms_;            ///< of model vertices, by vertex id: Disc::room
  Drawable drawable_;
  Style style_;
  CornerNormals normals_;
  Slots<Edge> edge_slots_;
  Slots<Vertex> vertex_slots_;
};

}  // namespace aomd::scene
