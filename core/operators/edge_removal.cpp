#include "core/operators/edge_removal.h"

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/assertion.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/tet_geometry.h"

namespace aomd {
namespace {

using Corners = std::array<glm::dvec3, 4>;

double shape_of(const Corners& t) { return tet_shape(t[0], t[1], t[2], t[3]); }
double value_of(const RemovalValue& value, const Corners& t) {
  return value.of(t[0], t[1], t[2], t[3]);
}
double dihedral_cosine_of(const Corners& t) {
  return smallest_dihedral_cosine(t[0], t[1], t[2], t[3]);
}

// The best way to cut one side's ring into triangles, by the two tetrahedra on each: best_[i][j] is
// the value of the polygon from i to j (Klincsek's table).
class RingTable {
 public:
  RingTable(const Mesh& mesh, const EdgeRing& ring, const RingSide& side, RemovalGoal goal)
      : value_(goal), a_(mesh.position(ring.a)), b_(mesh.position(ring.b)), count_(side.count) {
    for (std::uint32_t i = 0; i < count_; ++i) at_[i] = mesh.position(side.ring[i]);
  }

  double solve(RingTriangles& triangles) {
    for (std::uint32_t i = 0; i + 1 < count_; ++i) best_[i][i + 1] = value_.none();
    for (std::uint32_t width = 2; width < count_; ++width)
      for (std::uint32_t i = 0; i + width < count_; ++i) fill(i, i + width);
    triangles.count = 0;
    collect(0, count_ - 1, triangles);
    return best_[0][count_ - 1];
  }

  [[nodiscard]] Corners above(const RingTriangle& t) const {
    return {at_[t[0]], at_[t[1]], at_[t[2]], b_};
  }
  [[nodiscard]] Corners below(const RingTriangle& t) const {
    return {at_[t[2]], at_[t[1]], at_[t[0]], a_};
  }

 private:
  void fill(std::uint32_t i, std::uint32_t j) {
    double& best = best_[i][j] = -std::numeric_limits<double>::infinity();
    middle_[i][j] = std::uint8_t(i + 1);
    for (std::uint32_t k = i + 1; k < j; ++k) {
      double now = value_.both(best_[i][k], best_[k][j]);
      if (now <= best) continue;
      const RingTriangle t{std::uint8_t(i), std::uint8_t(k), std::uint8_t(j)};
      now = value_.both(now, value_of(value_, above(t)));
      if (now > best) now = value_.both(now, value_of(value_, below(t)));
      if (now <= best) continue;
      best = now;
      middle_[i][j] = std::uint8_t(k);
    }
  }

  void collect(std::uint32_t i, std::uint32_t j, RingTriangles& triangles) const {
    if (j < i + 2) return;
    const std::uint8_t k = middle_[i][j];
    triangles.items[triangles.count++] = {std::uint8_t(i), k, std::uint8_t(j)};
    collect(i, k, triangles);
    collect(k, j, triangles);
  }

  RemovalValue value_;
  glm::dvec3 a_, b_;
  std::uint32_t count_;
  std::array<glm::dvec3, largest_ring> at_;
  std::array<std::array<double, largest_ring>, largest_ring> best_;
  std::array<std::array<std::uint8_t, largest_ring>, largest_ring> middle_;
};

// The model face's two triangles as a surface swap sees them.
Verdict judge_faces(const Mesh& mesh, const EdgeRing& ring, const RemovalRules& rules) {
  const auto [f, g] = ring.faces;
  if (joined_in_volume(mesh, ring.apexes[0], ring.apexes[1]))
    return {Reason::Topology, ring.apexes[0]};
  const glm::dvec3 a = mesh.position(ring.a), b = mesh.position(ring.b),
                   c = mesh.position(ring.apexes[0]), d = mesh.position(ring.apexes[1]);
  const glm::dvec3 new_f = area_normal(d, b, c), new_g = area_normal(c, a, d);
  if (is_flat(d, b, c, new_f)) return {Reason::Flat, f};
  if (is_flat(c, a, d, new_g)) return {Reason::Flat, g};
  for (const glm::dvec3& now : {new_f, new_g})
    for (const glm::dvec3& then : {area_normal(a, b, c), area_normal(b, a, d)})
      if (!rules.max_turn.allows(then, now)) return {Reason::Angle, f, cosine_between(then, now)};
  if (!rules.least_angle.binds()) return {};
  const double now = std::max(smallest_angle_cosine(d, b, c), smallest_angle_cosine(c, a, d));
  const auto before = [&] {
    return std::max(smallest_angle_cosine(a, b, c), smallest_angle_cosine(b, a, d));
  };
  if (!rules.least_angle.allows(now, before)) return {Reason::Shape, f, now};
  return {};
}

// Calls visit(corners) for each tetrahedron around the edge.
template <typename Visit>
void for_present(const Mesh& mesh, const EdgeRing& ring, Visit&& visit) {
  for (std::uint32_t s = 0; s < ring.side_count; ++s) {
    const RingSide& side = ring.sides[s];
    for (std::uint32_t i = 0; i < side.region_count(); ++i)
      visit(Corners{mesh.position(ring.a), mesh.position(ring.b), mesh.position(side.ring[i]),
                    mesh.position(side.after(i))});
  }
}

// Calls visit(corners) for each tetrahedron that would be.
template <typename Visit>
void for_new(const Mesh& mesh, const EdgeRemoval& plan, Visit&& visit) {
  for (std::uint32_t s = 0; s < plan.ring.side_count; ++s) {
    const RingTable table(mesh, plan.ring, plan.ring.sides[s], RemovalGoal::Worst);
    for (std::uint32_t t = 0; t < plan.triangles[s].count; ++t) {
      visit(table.above(plan.triangles[s].items[t]));
      visit(table.below(plan.triangles[s].items[t]));
    }
  }
}

// Of the new tetrahedron with the poorest shape.
double worst_new_cosine(const Mesh& mesh, const EdgeRemoval& plan) {
  Corners worst{};
  double least = 2;
  for_new(mesh, plan, [&](const Corners& c) {
    if (const double shape = shape_of(c); shape < least) least = shape, worst = c;
  });
  return dihedral_cosine_of(worst);
}

Verdict judge_shape(const Mesh& mesh, RemovalGoal goal, EdgeRemoval& plan) {
  const RemovalValue value(goal);
  plan.before = plan.after = value.none();
  for_present(mesh, plan.ring,
              [&](const Corners& c) { plan.before = value.both(plan.before, value_of(value, c)); });
  for (std::uint32_t s = 0; s < plan.ring.side_count; ++s) {
    RingTable table(mesh, plan.ring, plan.ring.sides[s], goal);
    plan.after = value.both(plan.after, table.solve(plan.triangles[s]));
  }
  if (value.is_better(plan.before, plan.after)) return {};
  return {Reason::Quality, plan.ring.sides[0].regions[0], worst_new_cosine(mesh, plan)};
}

double worst_new_dihedral_cosine(const Mesh& mesh, const EdgeRemoval& plan) {
  double worst = -1;
  for_new(mesh, plan, [&](const Corners& c) { worst = std::max(worst, dihedral_cosine_of(c)); });
  return worst;
}

double worst_dihedral_cosine(const Mesh& mesh, const EdgeRing& ring) {
  double worst = -1;
  for_present(mesh, ring,
              [&](const Corners& c) { worst = std::max(worst, dihedral_cosine_of(c)); });
  return worst;
}

Verdict judge_dihedrals(const Mesh& mesh, const EdgeRemoval& plan, const LeastAngle& least) {
  if (!least.binds()) return {};
  const double now = worst_new_dihedral_cosine(mesh, plan);
  const auto before = [&] { return worst_dihedral_cosine(mesh, plan.ring); };
  if (!least.allows(now, before)) return {Reason::Shape, plan.ring.sides[0].regions[0], now};
  return {};
}

std::array<Vertex, 3> corners_of(const RingSide& side, const RingTriangle& t) {
  return {side.ring[t[0]], side.ring[t[1]], side.ring[t[2]]};
}

// Whether a triangle's longest side, from its first to its last position, is new inside the ring.
bool is_diagonal(const RingSide& side, const RingTriangle& t) {
  return t[0] != 0 || t[2] + 1u != side.count;
}

Verdict judge_inside(const Mesh& mesh, const EdgeRemoval& plan) {
  for (std::uint32_t s = 0; s < plan.ring.side_count; ++s) {
    const RingSide& side = plan.ring.sides[s];
    if (side.count == 3 && joined_in_volume(mesh, side.ring[0], side.ring[1], side.ring[2]))
      return {Reason::Topology, side.ring[0]};
    for (std::uint32_t i = 0; i < plan.triangles[s].count; ++i) {
      const RingTriangle& t = plan.triangles[s].items[i];
      if (is_diagonal(side, t) && joined_in_volume(mesh, side.ring[t[0]], side.ring[t[2]]))
        return {Reason::Topology, side.ring[t[0]]};
    }
  }
  return {};
}

Verdict judge_plan(const Mesh& mesh, Vertex a, Vertex b, const RemovalRules& rules,
                   EdgeRemoval& plan) {
  if (const Verdict v = find_ring(mesh, a, b, plan.ring); !v.accepted()) return v;
  if (plan.ring.on_model_face())
    if (const Verdict v = judge_faces(mesh, plan.ring, rules); !v.accepted()) return v;
  if (const Verdict v = judge_shape(mesh, rules.goal, plan); !v.accepted()) return v;
  if (const Verdict v = judge_dihedrals(mesh, plan, rules.least_dihedral); !v.accepted()) return v;
  return judge_inside(mesh, plan);
}

// Applying
// ------------------------------------------------------------------------------------------------

// What complete levels need inside one side before regions lean on it.
void create_inside(Mesh& mesh, const EdgeRing& ring, const RingSide& side,
                   const RingTriangles& triangles) {
  const ModelRef model = mesh.classification(side.regions[0]);
  for (std::uint32_t i = 0; i < triangles.count; ++i) {
    const auto [p, q, r] = corners_of(side, triangles.items[i]);
    if (is_diagonal(side, triangles.items[i]))
      create_spoke(mesh, p, r, std::array{ring.a, ring.b}, model);
  }
  for (std::uint32_t i = 0; i < triangles.count && mesh.complete(2); ++i)
    mesh.create_face(corners_of(side, triangles.items[i]), model);
}

// Which of a triangle's two tetrahedra a region of the ring has become.
struct Given {
  bool above = false, below = false;
};

// Each region stands on a side of the ring and so of one triangle: it becomes that one's
// tetrahedron with b, a second region the one with a. A third one goes.
class RemovalEdit {
 public:
  RemovalEdit(const Mesh& mesh, const EdgeRemoval& plan) : plan_(plan) {
    const EdgeRing& ring = plan.ring;
    if (ring.on_model_face()) {
      rebind(ring.faces[0], mesh.triangle(ring.faces[0]), ring.a, ring.apexes[1]);
      rebind(ring.faces[1], mesh.triangle(ring.faces[1]), ring.b, ring.apexes[0]);
    }
    for (std::uint32_t s = 0; s < ring.side_count; ++s) distribute(mesh, s);
  }

  [[nodiscard]] std::span<const Rebinding> rebindings() const {
    return std::span(rebindings_).first(count_);
  }
  [[nodiscard]] Region left_over() const { return left_over_; }

  void create_others(Mesh& mesh, std::uint32_t s) const {
    const EdgeRing& ring = plan_.ring;
    const ModelRef model = mesh.classification(ring.sides[s].regions[0]);
    for (std::uint32_t i = 0; i < plan_.triangles[s].count; ++i) {
      const auto [p, q, r] = corners_of(ring.sides[s], plan_.triangles[s].items[i]);
      const std::array above{p, q, r, ring.b}, below{r, q, p, ring.a};
      if (!given_[s][i].above) mesh.create_region(Shape::Tetrahedron, above, model);
      if (!given_[s][i].below) mesh.create_region(Shape::Tetrahedron, below, model);
    }
  }

 private:
  void distribute(const Mesh& mesh, std::uint32_t s) {
    const RingSide& side = plan_.ring.sides[s];
    const RingTriangles& triangles = plan_.triangles[s];
    struct Behind {
      std::uint32_t triangle = 0, apex = 0;
    };
    std::array<Behind, largest_ring> behind;
    for (std::uint32_t i = 0; i < triangles.count; ++i) {
      const RingTriangle& t = triangles.items[i];
      if (t[1] == t[0] + 1) behind[t[0]] = {i, t[2]};
      if (t[2] == t[1] + 1) behind[t[1]] = {i, t[0]};
      if (side.closed && !is_diagonal(side, t)) behind[t[2]] = {i, t[1]};
    }
    for (std::uint32_t i = 0; i < side.region_count(); ++i)
      give(mesh, side.regions[i], given_[s][behind[i].triangle], side.ring[behind[i].apex]);
  }

  void give(const Mesh& mesh, Region region, Given& given, Vertex apex) {
    if (given.below) {
      left_over_ = region;
      return;
    }
    const Vertex from = given.above ? plan_.ring.b : plan_.ring.a;
    rebind(region, mesh.tetrahedron(region), from, apex);
    (given.above ? given.below : given.above) = true;
  }

  template <std::size_t N>
  void rebind(EntityRef e, const std::array<Vertex, N>& vertices, Vertex from, Vertex to) {
    rebindings_[count_++] = {e, slot_in(vertices, from), from, to};
  }

  const EdgeRemoval& plan_;
  std::array<Rebinding, 2 + 2 * largest_ring> rebindings_;
  std::size_t count_ = 0;
  std::array<std::array<Given, largest_ring - 2>, 2> given_;
  Region left_over_;
};

void destroy_inside(Mesh& mesh, const EdgeRing& ring) {
  for (std::uint32_t s = 0; s < ring.side_count; ++s) {
    const RingSide& side = ring.sides[s];
    for (std::uint32_t i = 0; i < side.count; ++i) {
      if (!side.closed && (i == 0 || i + 1 == side.count)) continue;
      const std::array corners{ring.a, ring.b, side.ring[i]};
      if (const Face f = mesh.find_face(corners); f.valid()) mesh.destroy_unused(f);
    }
  }
  if (const Edge e = mesh.find_edge(ring.a, ring.b); e.valid()) mesh.destroy_unused(e);
}

EntityRef named_by(const EdgeRing& ring) {
  if (ring.on_model_face()) return ring.faces[0];
  return ring.sides[0].regions[0];
}

}  // namespace

Verdict judge(const Mesh& mesh, Vertex a, Vertex b, const RemovalRules& rules, EdgeRemoval& plan) {
  plan.revision = mesh.revision();
  return plan.verdict = judge_plan(mesh, a, b, rules, plan);
}

void apply(Mesh& mesh, const EdgeRemoval& plan) {
  AOMD_CHECK(plan.verdict.accepted() && plan.revision == mesh.revision());
  const EdgeRing& ring = plan.ring;
  const JournalScope step(mesh, StepKind::Swap, named_by(ring));
  if (ring.on_model_face() && mesh.complete(1))
    mesh.create_edge(ring.apexes[0], ring.apexes[1], mesh.classification(ring.faces[0]));
  for (std::uint32_t s = 0; s < ring.side_count; ++s)
    create_inside(mesh, ring, ring.sides[s], plan.triangles[s]);
  const RemovalEdit edit(mesh, plan);
  mesh.rebind(edit.rebindings());
  for (std::uint32_t s = 0; s < ring.side_count; ++s) edit.create_others(mesh, s);
  if (edit.left_over().valid()) mesh.destroy_unused(edit.left_over());
  destroy_inside(mesh, ring);
}

}  // namespace aomd
