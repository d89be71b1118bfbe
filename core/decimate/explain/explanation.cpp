#include "core/decimate/explain/explanation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/decimate/explain/verdict_words.h"
#include "core/decimate/explain/volume_words.h"
#include "core/operators/star.h"

namespace aomd {
namespace {

using namespace words;

// The corners of a face as it is, and as a contraction would leave it.
struct BeforeAfter {
  std::array<glm::dvec3, 3> before, after;
};

BeforeAfter corners_of(const Mesh& mesh, Face face, const Contraction& c) {
  BeforeAfter result;
  const auto t = mesh.triangle(face);
  for (std::size_t i = 0; i < 3; ++i) {
    result.before[i] = mesh.position(t[i]);
    result.after[i] = t[i] == c.deleted || t[i] == c.kept ? c.position : result.before[i];
  }
  return result;
}

// Against what it was, or against the original: a verdict has one number for both.
std::string angle_words(const Mesh& mesh, const CollapseOutlook& o) {
  const EntityRef who = o.verdict.entity;
  if (who.dimension == 0) return curve_words(who, o.verdict.number(), o.limits.curve_sum_deg);
  if (who.dimension == 1) {
    const Held held = held_degrees(o.verdict.number(), o.limits.curve_deg);
    return sentence("the model edge would turn by " + held.value + " degrees at " + name_of(who) +
                    "; the limit is " + held.limit);
  }
  const auto [before, after] = corners_of(mesh, Face(who.index), o.contraction);
  const bool turns = !TurnLimit(o.limits.turn_deg)
                          .allows(area_normal(before[0], before[1], before[2]),
                                  area_normal(after[0], after[1], after[2]));
  return turns || o.limits.away_deg == 0 ? turn_words(who, o.verdict.number(), o.limits.turn_deg)
                                         : away_words(who, o.verdict.number(), o.limits.away_deg);
}

std::string length_words(const CollapseOutlook& o) {
  const Held held = held_length(o.length, o.longest);
  return "Its length is " + held.value + ", and an edge goes only where it is shorter than " +
         held.limit + ", half the spacing of " + number_text(2 * o.longest, 3) + ".";
}

// Paper, section 3: a vertex goes only along what it lies on.
std::string model_words(const Mesh& mesh, const Contraction& c) {
  const ModelRef gone = mesh.classification(c.deleted), kept = mesh.classification(c.kept);
  Star around;
  gather(mesh, c.deleted, around);
  const ModelRef between = class_between(mesh, c.deleted, c.kept, around);
  const auto differ = [&](const ModelRef& a, const ModelRef& b) {
    return a != b && a.dimension() < 3;
  };
  if (gone.dimension() == 0 && kept.dimension() == 0)
    return "Both ends are model vertices, and these stay.";
  if (gone.dimension() == 0)
    return sentence(name_of(c.deleted) + " is a model vertex, and these stay");
  if (differ(gone, between))
    return sentence(name_of(c.deleted) + " lies on " + name(gone) + " and the edge on " +
                    name(between) + ": a vertex goes only along what it lies on");
  return sentence(name_of(c.kept) + " lies on " + name(kept) + ", which it would have to leave");
}

bool is_apex(const Mesh& mesh, Vertex v, const Contraction& c) {
  const auto faces = mesh.row<2>(c.deleted);
  return std::any_of(faces.begin(), faces.end(), [&](Face f) {
    const auto t = mesh.triangle(f);
    return std::count_if(t.begin(), t.end(), [&](Vertex u) { return u == c.kept || u == v; }) == 2;
  });
}

std::ptrdiff_t faces_at_edge(const Mesh& mesh, const Contraction& c) {
  Star star;
  gather(mesh, c.deleted, star);
  return std::count_if(star.begin(), star.end(), [&](const StarFace& f) { return f.uses(c.kept); });
}

bool at_border(const Mesh& mesh, Vertex v) {
  Star star;
  gather(mesh, v, star);
  return is_open(star);
}

// The link condition, by what broke it.
std::string topology_words(const Mesh& mesh, const CollapseOutlook& o) {
  const EntityRef who = o.verdict.entity;
  const Contraction& c = o.contraction;
  if (who.dimension == 2) return sentence("a face would fall onto " + name_of(who));
  for (const Vertex v : {c.deleted, c.kept})
    if (crowded(mesh, v))
      return sentence(name_of(v) + " has " + counted(mesh.row<2>(v).size(), "face") +
                      ", and waits until it has no more than " + std::to_string(largest_star));
  const bool third =
      who.dimension == 0 && who.index != c.deleted.index && who.index != c.kept.index;
  if (third && is_apex(mesh, Vertex(who.index), c))
    return sentence("the edge to " + name_of(who) + " would be left without a face");
  if (third)
    return sentence("both ends are joined to " + name_of(who) +
                    ", which no face of this edge has: the surface would be pinched there");
  const auto faces = faces_at_edge(mesh, c);
  if (faces == 2 && at_border(mesh, c.deleted) && at_border(mesh, c.kept))
    return "Both ends lie on the border and the edge does not: the surface would be pinched.";
  if (faces == 0) return "The edge has no face, and two surfaces would meet in one vertex.";
  if (faces > 2)
    return "Surfaces that only this edge connects would meet in one vertex, or a pocket vanish.";
  return "Its faces enclose a pocket that would vanish.";
}

std::string accepted_words(const Mesh& mesh, const CollapseOutlook& o,
                           const DecimationOptions& options) {
  const bool volume = mesh.count(3) > 0;
  if (options.target_faces > 0 && mesh.count(volume ? 3 : 2) <= options.target_faces)
    return "Nothing is against it, but the mesh has come down to the " +
           std::to_string(options.target_faces) +
           (volume ? " tetrahedra that were asked for." : " faces that were asked for.");
  const Contraction& c = o.contraction;
  std::string text =
      "Nothing is against it: " + name_of(c.deleted) + " would go into " + name_of(c.kept);
  const double moved = glm::length(c.position - mesh.position(c.kept));
  if (moved > 0) text += ", which would move by " + number_text(moved, 3);
  return text + ".";
}

double least_angle(const Mesh& mesh, const EdgePair& p) {
  const glm::dvec3 a = mesh.position(p.a), b = mesh.position(p.b);
  return std::min(smallest_angle_deg(a, b, mesh.position(p.c)),
                  smallest_angle_deg(b, a, mesh.position(p.d)));
}

}  // namespace

ReasonWords reason_words(Reason reason) {
  constexpr std::array<ReasonWords, reason_count> words = {{
      {"Could go", "Nothing is against it."},
      {"Spacing",
       "The edge is not shorter than half the spacing: a larger factor would let it go."},
      {"Classification",
       "Its vertex lies on a model vertex, or on a model edge that this edge leaves: collapsing it "
       "would cut "
       "a corner off."},
      {"Topology", "The mesh would be pinched, doubled or torn (link condition)."},
      {"Flat face", "A face would lose its area."},
      {"Angle", "A face would turn by more than the angle limit."},
      {"Quality", "The triangles would not get a better shape."},
      {"Kept", "Its vertices are to stay where they are."},
      {"Small angle",
       "A face would get a smaller angle than is allowed: the least angle, and for quality 8 to 12 "
       "degrees unless one as small was there."},
      {"Distance", "The surface would leave the original by more than the limit."},
      {"Intersection", "The surface would cut itself where it did not."},
      {"Inverted", "A tetrahedron would lose its volume, or turn inside out."},
      {"Overshoot", "An edge would become too long for the size there."},
      {"Volume", "A model region would gain or lose more of its volume than the limit."},
  }};
  return words[static_cast<std::size_t>(reason)];
}

std::string explain_collapse(const Mesh& mesh, const CollapseOutlook& o,
                             const DecimationOptions& options) {
  const bool volume = mesh.count(3) > 0;
  if (std::string text = region_words(mesh, o.verdict, o.limits); !text.empty()) return text;
  switch (o.verdict.reason) {
    case Reason::None:
      return accepted_words(mesh, o, options);
    case Reason::Spacing:
      return length_words(o);
    case Reason::Classification:
      return volume ? volume_model_words(mesh, o.contraction) : model_words(mesh, o.contraction);
    case Reason::Topology:
      return volume ? volume_topology_words(mesh, o) : topology_words(mesh, o);
    case Reason::Angle:
      return angle_words(mesh, o);
    default:
      return general_words(o.verdict, o.limits);
  }
}

std::string explain_swap(const Mesh& mesh, Edge edge, const SwapOutlook& o) {
  if (mesh.count(3) > 0) return removal_words(mesh, edge, o);
  const EdgePair& p = o.pair;
  switch (o.verdict.reason) {
    case Reason::None:
      return sentence("it would join " + name_of(p.c) + " and " + name_of(p.d));
    case Reason::Classification:
      if (mesh.classification(edge).dimension() == 1)
        return sentence("the edge lies on " + name(mesh.classification(edge)));
      return "Its two faces lie on different model faces.";
    case Reason::Topology:
      if (!p.f.valid() || !p.g.valid()) return "Not exactly two faces of one orientation share it.";
      return sentence(name_of(p.c) + " and " + name_of(p.d) + " are joined already");
    case Reason::Quality:
      return "It would not pay: the smallest angle of its two faces would be " +
             degrees(o.verdict.number()) + " degrees; it is " + degrees(least_angle(mesh, p)) + ".";
    default:
      return general_words(o.verdict, o.limits);
  }
}

std::string explain_move(const Mesh& mesh, const MoveOutlook& o) {
  const ModelRef on = mesh.classification(o.vertex);
  if (std::string text = region_words(mesh, o.verdict, o.limits); !text.empty()) return text;
  switch (o.verdict.reason) {
    case Reason::None: {
      const double moved = glm::length(o.target - mesh.position(o.vertex));
      return moved > 0 ? sentence("it would move by " + number_text(moved, 3))
                       : "It would stay in place.";
    }
    case Reason::Classification:
      if (on.dimension() <= 1)
        return sentence("it lies on " + name(on) + ", and is not moved off it");
      return "It has no neighbours to be moved between.";
    case Reason::Quality:
      if (o.verdict.entity.dimension == 0)
        return "No place near is better for the tetrahedra around it.";
      return sentence(name_of(o.verdict.entity) + " would become still poorer");
    default:
      return general_words(o.verdict, o.limits);
  }
}

std::vector<CheckResult> collapse_checks(const CollapseOutlook& o,
                                         const DecimationOptions& options) {
  struct Check {
    const char* name;
    bool asked;
    bool failed;
  };
  const Reason r = o.verdict.reason;
  const bool curve = r == Reason::Angle && o.verdict.entity.dimension == 1;
  const bool shape = r == Reason::Shape && o.verdict.entity.dimension == 3;
  const std::array<Check, 10> checks = {{
      {"Length", true, r == Reason::Spacing},
      {"Kept", options.keep != nullptr, r == Reason::Kept},
      {"Model", true, r == Reason::Classification},
      {"Topology", options.topology == TopologyRule::Safe, r == Reason::Topology},
      {"Faces", true,
       r == Reason::Flat || (r == Reason::Shape && !shape) || (r == Reason::Angle && !curve)},
      {"Model edge", o.limits.curve_deg > 0, curve},
      {"Tetrahedra", o.limits.regions, r == Reason::Inverted || r == Reason::Overshoot || shape},
      {"Volumes", o.limits.volume_pct > 0, r == Reason::Volume},
      {"Distance", options.max_distance > 0, r == Reason::Distance},
      {"Intersections", options.no_intersections, r == Reason::Intersection},
  }};
  std::vector<CheckResult> results;
  auto state = CheckResult::State::Passed;
  for (const Check& check : checks) {
    if (!check.asked) continue;
    results.push_back({check.name, check.failed ? CheckResult::State::Failed : state});
    if (check.failed) state = CheckResult::State::NotReached;
  }
  return results;
}

}  // namespace aomd
