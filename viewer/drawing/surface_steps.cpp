// What a step has touched, and what is marked, as lines and dots over the surface.

#include <algorithm>
#include <map>
#include <utility>

#include "viewer/drawing/step_before.h"
#include "viewer/drawing/surface_drawing.h"

namespace aomd::scene {
namespace {

constexpr float step_line_px = 2.6f;
constexpr float step_disc_px = 5.0f;
constexpr float marked_line_px = 2.0f;
constexpr float marked_disc_px = 3.0f;
constexpr Color before_color = rgb(0x1f4fd8);

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
