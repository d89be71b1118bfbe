#include "core/operators/swap.h"

#include <algorithm>

#include "core/base/lanes.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/shared_edits.h"
#include "core/operators/star.h"

namespace aomd {
namespace {

// Gain below this (in the cosine of the smallest angle) is noise and could swap back and forth.
constexpr double smallest_gain = 1e-6;

std::uint32_t slot_of(const std::array<Vertex, 3>& t, Vertex v) {
  return t[0] == v ? 0 : t[1] == v ? 1 : t[2] == v ? 2 : 3;
}

// Fills the pair from faces at one of its ends; false unless exactly two of them use the edge, in
// opposite directions.
bool find_faces(const Mesh& mesh, const Row<2>& faces, EdgePair& pair) {
  for (const Face face : faces) {
    const auto t = mesh.triangle(face);
    const std::uint32_t i = slot_of(t, pair.b);
    if (i == 3 || slot_of(t, pair.a) == 3) continue;
    const bool forward = t[(i + 2) % 3] == pair.a;  // a before b
    Face& place = forward ? pair.f : pair.g;
    if (place.valid()) return false;
    place = face;
    (forward ? pair.c : pair.d) = forward ? t[(i + 1) % 3] : t[(i + 2) % 3];
  }
  return pair.f.valid() && pair.g.valid() && pair.c != pair.d;
}

std::array<Rebinding, 2> face_rebindings(const Mesh& mesh, const EdgePair& pair) {
  return {{{pair.f, slot_of(mesh.triangle(pair.f), pair.a), pair.a, pair.d},
           {pair.g, slot_of(mesh.triangle(pair.g), pair.b), pair.b, pair.c}}};
}

bool on_model_edge(const Mesh& mesh, Vertex a, Vertex b) {
  if (!may_end_model_edge(mesh, a) || !may_end_model_edge(mesh, b)) return false;
  return aomd::on_model_edge(mesh, mesh.find_edge(a, b));
}

double largest(const DoubleLanes& lanes) { return std::max(lanes[0], lanes[1]); }

Verdict judge_shape(const Mesh& mesh, const EdgePair& e, const TurnLimit& limit) {
  const glm::dvec3 a = mesh.position(e.a), b = mesh.position(e.b), c = mesh.position(e.c),
                   d = mesh.position(e.d);
  const TwoPoints ba = two_points(b, a), cd = two_points(c, d), dc = two_points(d, c);
  const double before = largest(smallest_angle_cosine(two_points(a, b), ba, cd));
  const double after = largest(smallest_angle_cosine(dc, ba, cd));
  if (after > before - smallest_gain) return {Reason::Quality, e.f, after};
  const glm::dvec3 old_f = area_normal(a, b, c), old_g = area_normal(b, a, d);
  const glm::dvec3 new_f = area_normal(d, b, c), new_g = area_normal(c, a, d);
  if (is_flat(d, b, c, new_f)) return {Reason::Flat, e.f};
  if (is_flat(c, a, d, new_g)) return {Reason::Flat, e.g};
  for (const glm::dvec3& now : {new_f, new_g})
    for (const glm::dvec3& then : {old_f, old_g})
      if (!limit.allows(then, now)) return {Reason::Angle, e.f, cosine_between(then, now)};
  return {};
}

}  // namespace

Verdict find_pair(const Mesh& mesh, Vertex a, Vertex b, EdgePair& pair) {
  pair = {{}, {}, a, b, {}, {}};
  if (!find_faces(mesh, fewer_faces(mesh, a, b), pair)) {
    pair = {{}, {}, a, b, {}, {}};
    return {Reason::Topology, a};
  }
  if (mesh.classification(pair.f) != mesh.classification(pair.g))
    return {Reason::Classification, pair.f};
  if (!may_end_model_edge(mesh, a) || !may_end_model_edge(mesh, b)) return {};
  const Edge edge = mesh.find_edge(a, b);
  if (edge.valid() && mesh.classification(edge).dimension() == 1)
    return {Reason::Classification, edge};
  return {};
}

bool joined(const Mesh& mesh, Vertex a, Vertex b) {
  if (crowded(mesh, a) && crowded(mesh, b)) return true;
  for (const Face f : fewer_faces(mesh, a, b)) {
    const auto t = mesh.triangle(f);
    if (slot_of(t, a) != 3 && slot_of(t, b) != 3) return true;
  }
  if (!mesh.stored(0, 1) && !(may_end_model_edge(mesh, a) && may_end_model_edge(mesh, b)))
    return false;
  return mesh.find_edge(a, b).valid();
}

Verdict judge_swap(const Mesh& mesh, Edge edge, const TurnLimit& max_turn, EdgePair& pair) {
  if (mesh.classification(edge).dimension() == 1) return {Reason::Classification, edge};
  const auto [a, b] = mesh.edge_vertices(edge);
  pair = {{}, {}, a, b, {}, {}};
  const Row<2> faces = mesh.stored(0, 2) ? fewer_faces(mesh, a, b) : mesh.row<2>(edge);
  if (!find_faces(mesh, faces, pair)) return {Reason::Topology, edge};
  if (mesh.classification(pair.f) != mesh.classification(pair.g))
    return {Reason::Classification, edge};
  if (const Verdict v = judge_shape(mesh, pair, max_turn); !v.accepted()) return v;
  if (crowded(mesh, pair.c) && crowded(mesh, pair.d)) return {Reason::Topology, pair.c};
  if (const Edge other = mesh.find_edge(pair.c, pair.d); other.valid())
    return {Reason::Topology, other};
  return {};
}

Verdict judge_swap(const Mesh& mesh, Vertex a, Vertex b, const TurnLimit& max_turn,
                   EdgePair& pair) {
  const Verdict found = find_pair(mesh, a, b, pair);
  if (found.reason == Reason::Topology && on_model_edge(mesh, a, b))
    return {Reason::Classification, a};
  if (!found.accepted()) return found;
  if (const Verdict v = judge_shape(mesh, pair, max_turn); !v.accepted()) return v;
  if (joined(mesh, pair.c, pair.d)) return {Reason::Topology, pair.c};
  return {};
}

void apply_swap(Mesh& mesh, Edge edge, const EdgePair& pair) {
  const JournalScope step(mesh, StepKind::Swap, edge.valid() ? EntityRef(edge) : EntityRef(pair.f));
  const auto [f, g] = face_rebindings(mesh, pair);
  const std::array<Rebinding, 4> items{
      {{edge, 0, pair.a, pair.c}, {edge, 1, pair.b, pair.d}, f, g}};
  mesh.rebind(std::span(items).subspan(edge.valid() ? 0 : 2));
}

void apply_swap(Mesh& mesh, const EdgePair& pair) {
  Edge edge;
  if (mesh.stored(0, 1)) edge = mesh.find_edge(pair.a, pair.b);
  // The ends are named as the edge runs.
  const bool along = !edge.valid() || mesh.edge_vertices(edge)[0] == pair.a;
  apply_swap(mesh, edge, along ? pair : EdgePair{pair.g, pair.f, pair.b, pair.a, pair.d, pair.c});
}

void apply_swap(SharedEdits& edits, const Mesh& mesh, const EdgePair& pair) {
  edits.rebind(face_rebindings(mesh, pair));
}

}  // namespace aomd
