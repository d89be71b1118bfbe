#include "core/operators/face_removal.h"

#include <algorithm>

#include "core/base/assertion.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/ball.h"
#include "core/operators/edge_ring.h"

namespace aomd {
namespace {

// The tetrahedron on the other side of a face, and its vertex that is not on it.
bool find_other(const Mesh& mesh, FaceRemoval& plan) {
  const auto [x, y, z] = plan.corners;
  const bool uniform = mesh.uniform_shape(3) != nullptr;
  for (const Region r : fewer_regions(mesh, x, y)) {
    if (r == plan.regions[0] || (!uniform && mesh.shape(r) != Shape::Tetrahedron)) continue;
    std::uint32_t on_face = 0;
    Vertex apex;
    for (const Vertex v : mesh.tetrahedron(r)) {
      const bool corner = (v == x) | (v == y) | (v == z);
      on_face += corner;
      if (!corner) apex = v;
    }
    if (on_face != 3) continue;
    plan.regions[1] = r;
    plan.apexes[1] = apex;
    return apex.valid() && apex != plan.apexes[0];
  }
  return false;
}

Verdict judge_class(const Mesh& mesh, const FaceRemoval& plan) {
  const Face face = mesh.find_face(plan.corners);
  if (face.valid() && mesh.classification(face).dimension() <= 2)
    return {Reason::Classification, face};
  if (mesh.classification(plan.regions[0]) != mesh.classification(plan.regions[1]))
    return {Reason::Classification, plan.regions[1]};
  return {};
}

Verdict judge_shape(const Mesh& mesh, RemovalGoal goal, FaceRemoval& plan) {
  const RemovalValue value(goal);
  const glm::dvec3 p = mesh.position(plan.apexes[0]), q = mesh.position(plan.apexes[1]);
  const std::array at{mesh.position(plan.corners[0]), mesh.position(plan.corners[1]),
                      mesh.position(plan.corners[2])};
  plan.before = value.both(value.of(p, at[0], at[1], at[2]), value.of(q, at[2], at[1], at[0]));
  plan.after = value.none();
  double least = 2;
  std::size_t worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = value.of(p, at[k], at[(k + 1) % 3], q);
    plan.after = value.both(plan.after, one);
    if (one >= least) continue;
    least = one;
    worst = k;
  }
  if (value.is_better(plan.before, plan.after)) return {};
  return {Reason::Quality, plan.regions[0],
          smallest_dihedral_cosine(p, at[worst], at[(worst + 1) % 3], q)};
}

Verdict judge_dihedrals(const Mesh& mesh, const FaceRemoval& plan, const LeastAngle& least) {
  if (!least.binds()) return {};
  const glm::dvec3 p = mesh.position(plan.apexes[0]), q = mesh.position(plan.apexes[1]),
                   x = mesh.position(plan.corners[0]), y = mesh.position(plan.corners[1]),
                   z = mesh.position(plan.corners[2]);
  const double now =
      std::max({smallest_dihedral_cosine(p, x, y, q), smallest_dihedral_cosine(p, y, z, q),
                smallest_dihedral_cosine(p, z, x, q)});
  const auto before = [&] {
    return std::max(smallest_dihedral_cosine(p, x, y, z), smallest_dihedral_cosine(q, z, y, x));
  };
  if (!least.allows(now, before)) return {Reason::Shape, plan.regions[0], now};
  return {};
}

Verdict judge_plan(const Mesh& mesh, const RemovalRules& rules, FaceRemoval& plan) {
  if (!find_other(mesh, plan)) return {Reason::Topology, plan.regions[0]};
  if (const Verdict v = judge_class(mesh, plan); !v.accepted()) return v;
  if (const Verdict v = judge_shape(mesh, rules.goal, plan); !v.accepted()) return v;
  if (const Verdict v = judge_dihedrals(mesh, plan, rules.least_dihedral); !v.accepted()) return v;
  if (joined_in_volume(mesh, plan.apexes[0], plan.apexes[1]))
    return {Reason::Topology, plan.apexes[0]};
  return {};
}

}  // namespace

Verdict judge(const Mesh& mesh, Region region, std::uint32_t slot, const RemovalRules& rules,
              FaceRemoval& plan) {
  const auto t = mesh.tetrahedron(region);
  const auto& from = seen_from[slot];
  plan.regions = {region, Region()};
  plan.apexes = {t[slot], Vertex()};
  plan.corners = {t[from[0]], t[from[1]], t[from[2]]};
  plan.revision = mesh.revision();
  return plan.verdict = judge_plan(mesh, rules, plan);
}

// (p, x, y, z) becomes (p, x, y, q), and (q, z, y, x) becomes (q, z, y, p).
void apply(Mesh& mesh, const FaceRemoval& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const auto [p, q] = plan.apexes;
  const auto [x, y, z] = plan.corners;
  const auto [first, second] = plan.regions;
  const ModelRef model = mesh.classification(first);
  const JournalScope step(mesh, StepKind::Swap, first);
  create_spoke(mesh, p, q, plan.corners, model);
  const std::array<Rebinding, 2> items{{{first, slot_in(mesh.tetrahedron(first), z), z, q},
                                        {second, slot_in(mesh.tetrahedron(second), x), x, p}}};
  mesh.rebind(items);
  const std::array third{p, z, x, q};
  mesh.create_region(Shape::Tetrahedron, third, model);
  if (const Face face = mesh.find_face(plan.corners); face.valid()) mesh.destroy_unused(face);
}

}  // namespace aomd
