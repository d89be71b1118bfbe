#include "viewer/explain/entity_verdict.h"

#include <algorithm>

#include "core/decimate/guard/surface_change.h"
#include "core/mesh/names.h"
#include "core/operators/ball.h"
#include "viewer/base/sort_once.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene {
namespace {

constexpr Color ghost = ghost_color();
constexpr Color vanishing = vanishing_color();
constexpr Color rim = rgb(0x1b2430);
constexpr float tint = 0.30f;

std::size_t passed(const CollapseWay& way) {
  return static_cast<std::size_t>(
      std::count_if(way.checks.begin(), way.checks.end(),
                    [](const CheckResult& c) { return c.state == CheckResult::State::Passed; }));
}

/// Collects what an overlay gets.
struct Sketch {
  glm::dvec3 origin;
  std::vector<Corner> faces;
  std::vector<Segment> rims, lines;  ///< dark ones below, so that they read on every colour
  std::vector<Disc> discs;

  [[nodiscard]] glm::vec3 place(const glm::dvec3& p) const { return glm::vec3(p - origin); }
  void triangle(const Triangle& t, Color color, float line_px) {
    const Color area = (color & 0x00ffffffu) | static_cast<Color>(255 * tint) << 24;
    for (std::size_t i = 0; i < 3; ++i) {
      faces.push_back({place(t[i]), 0, area, 0});
      rims.push_back({place(t[i]), place(t[(i + 1) % 3]), rim, line_px + 1.8f});
      lines.push_back({place(t[i]), place(t[(i + 1) % 3]), color, line_px});
    }
  }
  void line(const glm::dvec3& from, const glm::dvec3& to) {
    rims.push_back({place(from), place(to), rim, 4.2f});
    lines.push_back({place(from), place(to), ghost, 2.4f});
  }
  void thin_line(const glm::dvec3& from, const glm::dvec3& to, Color color) {
    rims.push_back({place(from), place(to), rim, 2.8f});
    lines.push_back({place(from), place(to), color, 1.4f});
  }
  void move(const glm::dvec3& from, const glm::dvec3& to) {
    line(from, to);
    discs.push_back({place(to), ghost, 5.5f});
  }
  void finish(Overlay& overlay) {
    overlay.faces.assign(std::move(faces));
    rims.insert(rims.end(), lines.begin(), lines.end());
    overlay.lines.assign(std::move(rims));
    overlay.discs.assign(std::move(discs));
  }
};

void draw_change(const Change& change, EntityRef decided, Sketch& sketch) {
  const auto decides = [&](const NewFace& f) { return decided == EntityRef(f.face); };
  for (const NewFace& f : change.created)
    if (!decides(f)) sketch.triangle(f.corners, ghost, 1.6f);
  for (const NewFace& f : change.created)
    if (decides(f)) sketch.triangle(f.corners, deciding_style().color, 2.6f);
}

/// All tetrahedra around a vertex; none on surfaces and beside other shapes, which stay.
Ball ball_around(const Mesh& mesh, Vertex v) {
  Ball ball;
  if (mesh.count(3) > 0 && mesh.stored(0, 3) && !first_other_shape(mesh, v).valid())
    gather(mesh, v, ball);
  return ball;
}

/// A tetrahedron whose vertex stands where it would be.
void draw_stretched(const Mesh& mesh, const BallRegion& r, const glm::dvec3& apex, Color color,
                    Sketch& sketch) {
  const std::array p{mesh.position(r.others[0]), mesh.position(r.others[1]),
                     mesh.position(r.others[2])};
  for (std::size_t i = 0; i < 3; ++i) sketch.triangle({apex, p[i], p[(i + 1) % 3]}, color, 2.2f);
  sketch.triangle({p[0], p[2], p[1]}, color, 2.2f);
}

/// Edges from where a vertex would be to those around it.
void draw_spokes(const Mesh& mesh, const Ball& ball, Vertex except, const glm::dvec3& apex,
                 Sketch& sketch) {
  std::vector<Vertex> far;
  for_corners(ball, [&](Vertex v) { far.push_back(v); });
  sort_once(far);
  for (const Vertex v : far)
    if (v != except) sketch.thin_line(apex, mesh.position(v), ghost);
}

/// Among tetrahedra those around the edge vanish, and the others at an end that goes or moves
/// stretch; the one that decides is drawn as it would be.
void draw_balls(const Mesh& mesh, const CollapseWay& way, Sketch& sketch) {
  const Contraction& c = way.outlook.contraction;
  const EntityRef decided = way.outlook.verdict.entity;
  const bool moves = c.position != mesh.position(c.kept);
  for (const Vertex end : {c.deleted, c.kept}) {
    const Vertex other = end == c.deleted ? c.kept : c.deleted;
    const Ball ball = ball_around(mesh, end);
    if (end == c.deleted || moves) draw_spokes(mesh, ball, other, c.position, sketch);
    for (const BallRegion& r : ball) {
      if (r.uses(other) && end == c.deleted)
        draw_stretched(mesh, r, mesh.position(end), vanishing, sketch);
      if (!r.uses(other) && decided == EntityRef(r.region))
        draw_stretched(mesh, r, c.position, deciding_style().color, sketch);
    }
  }
}

}  // namespace

std::optional<EntityVerdict> judge(Decimation& decimation, const Mesh& mesh, EntityRef e) {
  constexpr const char* later = "This strategy judges it once its collapses are done.";
  EntityVerdict j;
  j.entity = e;
  if (e.dimension == 1) {
    for (const CollapseOutlook& o : decimation.outlook(Edge(e.index)))
      j.ways.push_back({o, explain_collapse(mesh, o, decimation.options()),
                        collapse_checks(o, decimation.options())});
    const auto furthest =
        std::max_element(j.ways.begin(), j.ways.end(),
                         [](const auto& a, const auto& b) { return passed(a) < passed(b); });
    j.best = static_cast<std::size_t>(furthest - j.ways.begin());
    j.swap = decimation.swap_outlook(Edge(e.index));
    j.swap_words = j.swap ? explain_swap(mesh, Edge(e.index), *j.swap) : later;
    return j;
  }
  if (e.dimension != 0) return {};
  j.move = decimation.move_outlook(Vertex(e.index));
  j.move_words = j.move ? explain_move(mesh, *j.move) : later;
  return j;
}

std::string short_words(const EntityVerdict& judgement) {
  return judgement.ways.empty() ? std::string() : judgement.ways[judgement.best].words;
}

std::string way_title(const CollapseWay& way) {
  return capitalized(name_of(way.outlook.contraction.deleted)) + " into " +
         std::to_string(way.outlook.contraction.kept.index);
}

void draw_preview(const Mesh& mesh, const CollapseWay& way, const glm::dvec3& origin,
                  Overlay& overlay) {
  const Contraction& c = way.outlook.contraction;
  Star deleted, kept;
  gather(mesh, c.deleted, deleted);
  gather(mesh, c.kept, kept);
  Change change;
  describe(mesh, c, deleted, kept, change);
  Sketch sketch{origin, {}, {}, {}, {}};
  draw_balls(mesh, way, sketch);
  draw_change(change, way.outlook.verdict.entity, sketch);
  sketch.move(mesh.position(c.deleted), c.position);
  sketch.finish(overlay);
  const EntityRef decided = way.outlook.verdict.entity;
  const bool own =
      decided.dimension == 1 && !way.outlook.verdict.accepted() &&
      way.outlook.verdict.reason == Reason::Spacing;  // the edge itself is selected already
  const bool stretched = decided.dimension == 3 && !ball_around(mesh, c.deleted).empty();
  if (decided.valid() && !own && !stretched)
    draw_entities(mesh, std::span(&decided, 1), deciding_style(), origin, overlay);
}

void draw_preview(const Mesh& mesh, const SwapOutlook& swap, const glm::dvec3& origin,
                  Overlay& overlay) {
  const EdgePair& pair = swap.pair;
  Sketch sketch{origin, {}, {}, {}, {}};
  if (pair.f.valid() && pair.g.valid()) {
    Change change;
    describe(mesh, pair, change);
    draw_change(change, swap.verdict.entity, sketch);
    sketch.line(mesh.position(pair.c), mesh.position(pair.d));
  }
  sketch.finish(overlay);
}

void draw_preview(const Mesh& mesh, const MoveOutlook& move, const glm::dvec3& origin,
                  Overlay& overlay) {
  Star star;
  gather(mesh, move.vertex, star);
  Change change;
  describe(mesh, move.vertex, star, move.target, change);
  Sketch sketch{origin, {}, {}, {}, {}};
  if (move.target != mesh.position(move.vertex)) {
    draw_spokes(mesh, ball_around(mesh, move.vertex), {}, move.target, sketch);
    draw_change(change, move.verdict.entity, sketch);
    sketch.move(mesh.position(move.vertex), move.target);
  }
  sketch.finish(overlay);
}

}  // namespace aomd::scene
