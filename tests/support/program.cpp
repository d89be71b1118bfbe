#include "tests/support/program.h"

#include <algorithm>

#include "core/operators/collapse.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"

namespace aomd::oracle {

Program::Program(Twin& twin, std::uint64_t seed, Liberties may)
    : twin_(twin), random_(seed), may_(may) {
  for (int dim = 0; dim <= 3; ++dim) usual_count_[dim] = twin.plain().count(dim);
}

void Program::operation() {
  const std::size_t dice = random(100);
  if (may_.relations && dice < 8)
    change_relations();
  else if (may_.history && dice < 16)
    travel();
  else if (may_.compaction && dice == 16)
    twin_.compact();
  else
    edit();
  twin_.check_touched(random_);
}

void Program::edit() {
  const std::size_t dice = random(100);
  if (dice < 34) return create();
  if (dice < 58) return destroy();
  if (dice < 70) return collapse();
  if (dice < 80) return use_operator();
  const EntityRef e = any(static_cast<int>(random(4)));
  if (!e.valid()) return;
  if (dice < 86) return twin_.set_value(e, static_cast<double>(random(1000)));
  if (dice < 93) return (void)twin_.classify(e, any_class(e.dimension));
  if (e.dimension == 0) twin_.move(Vertex(e.index), {random(9), random(9), random(9)});
}

EntityRef Program::any(int dim) {
  const auto& level = twin_.plain().level(dim);
  if (level.empty()) return {};
  auto at = level.lower_bound(static_cast<Index>(random(twin_.plain().capacity(dim))));
  return EntityRef(dim, at == level.end() ? level.begin()->first : at->first);
}

// Mostly one that the rule M^I on G^J only if J >= I allows.
ModelRef Program::any_class(int dim) {
  if (random(4) == 0) return {};
  const int lowest = random(8) == 0 ? 0 : dim;
  const int model = lowest + static_cast<int>(random(static_cast<std::size_t>(4 - lowest)));
  return ModelRef(model, static_cast<std::int32_t>(random(3)));
}

// Four vertices can form three different quads: a mesh in which two of them meet is no mesh.
bool Program::conflicts(const Entity& whole) const {
  std::vector<Ids> quads;
  const auto note = [&](const Entity& e, auto&& visit) {
    if (e.shape == Shape::Quad) visit(e.vertices);
    for (int i = 0; i < shape_template(e.shape).face_count; ++i)
      if (Ids s = side(e, 2, i); s.size() == 4) visit(s);
  };
  note(whole, [&](const Ids& q) { quads.push_back(q); });
  bool found = false;
  for (int dim = 2; dim <= 3 && !quads.empty(); ++dim)
    for (const auto& [id, e] : twin_.plain().level(dim))
      note(e, [&](const Ids& other) {
        for (const Ids& q : quads)
          found = found || (sorted(q) == sorted(other) && !same_cycle(q, other));
      });
  return found;
}

void Program::create() {
  if (random(5) == 0) {
    const ModelRef model = any_class(0);
    if (twin_.plain().count(0) < usual_count_[0] + 8)
      (void)twin_.create_vertex({random(9), random(9), random(9)}, model);
    return;
  }
  if (!buried_.empty() && random(3) != 0) {
    const auto [shape, vertices] = buried_[random(buried_.size())];
    return create_shape(shape, vertices);
  }
  constexpr Shape shapes[] = {Shape::Line, Shape::Triangle, Shape::Triangle, Shape::Tetrahedron,
                              Shape::Quad, Shape::Pyramid,  Shape::Prism,    Shape::Hexahedron};
  const Shape shape = shapes[random(random(4) == 0 ? 8 : 4)];
  Ids vertices;
  for (int k = 0; k < shape_template(shape).vertex_count; ++k) vertices.push_back(any(0).index);
  create_shape(shape, vertices);
}

void Program::create_shape(Shape shape, const Ids& vertices) {
  const Plain& plain = twin_.plain();
  const int dim = shape_template(shape).dimension;
  const Entity whole{shape, vertices, any_class(dim)};
  if (dim == 3 && !may_.regions) return;
  if (plain.count(dim) > usual_count_[dim] + 12) return;
  const bool repeated = dim == 2 && plain.find(2, vertices) != no_index;
  if (repeated && may_.regions && plain.count(3) == 0) return;
  if (dim == 3 && plain.find(3, vertices) != no_index) return;  // verify() would object
  if (conflicts(whole)) return;
  Twin::From from = Twin::From::Vertices;
  const int k = static_cast<int>(random(3));
  if (k > 0 && k < dim && plain.missing_sides(whole, k).empty() &&
      std::all_of(vertices.begin(), vertices.end(),
                  [&](Index v) { return plain.alive(Vertex(v)); }))
    from = k == 1 ? Twin::From::Edges : Twin::From::Faces;
  (void)twin_.create(shape, vertices, whole.model, from);
}

void Program::remember(EntityRef e) {
  if (e.dimension == 0) return;
  buried_.emplace_back(twin_.plain()[e].shape, twin_.plain()[e].vertices);
  if (buried_.size() > 40) buried_.pop_front();
}

void Program::destroy() {
  const std::size_t dice = random(10);
  const EntityRef e = any(dice < 5 ? 3 : static_cast<int>(dice % 4));
  if (!e.valid()) return;
  if (dice != 9 || twin_.plain().count(e.dimension) < usual_count_[e.dimension]) {
    remember(e);
    (void)twin_.destroy(e);
    return;
  }
  for (const EntityRef user : twin_.plain().users(e)) remember(user);
  remember(e);
  twin_.destroy_with_users(e);
}

void Program::collapse() {
  const EntityRef e = any(1 + static_cast<int>(random(3)));
  if (!e.valid()) return;
  const Entity& whole = twin_.plain()[e];
  Ids ends = whole.vertices;
  if (e.dimension > 1)
    ends = side(
        whole, 1,
        static_cast<int>(random(static_cast<std::size_t>(shape_template(whole.shape).edge_count))));
  const std::size_t k = random(2);
  (void)twin_.collapse(Vertex(ends[k]), Vertex(ends[1 - k]));
}

bool Program::triangles_only() const {
  const auto& faces = twin_.plain().level(2);
  return twin_.plain().count(3) == 0 && !faces.empty() &&
         std::all_of(faces.begin(), faces.end(),
                     [](const auto& f) { return f.second.shape == Shape::Triangle; });
}

// The operators need T(0,1), T(0,2), T(2,0): requested for the one edit.
void Program::use_operator() {
  if (may_.regions || !triangles_only()) return;  // the paper's rule may double a face
  const std::size_t before = twin_.requests();
  twin_.request(0, 1);
  twin_.request(0, 2);
  twin_.request(2, 0);
  // Their rows must have room for triangles only, which one quad, deleted or not, changes.
  const bool granted =
      twin_.requests() == before + 3 && twin_.mesh().representation().down(2, 0).stride() == 3;
  const EntityRef e = any(1);
  if (granted && e.valid()) {
    const std::size_t dice = random(3);
    const TurnLimit limit(175);
    Mesh& mesh = twin_.mesh();
    EdgePair pair;
    glm::dvec3 target;
    const Vertex v(twin_.plain()[e].vertices[0]);
    if (dice == 0) collapse_by_operator(Edge(e.index));
    if (dice == 1 && judge_swap(mesh, Edge(e.index), limit, pair).accepted())
      apply_swap(mesh, Edge(e.index), pair);
    if (dice == 2 && judge_smooth(mesh, v, limit, target).accepted()) apply_smooth(mesh, v, target);
    twin_.adopt();
  }
  while (twin_.requests() > before) twin_.release(twin_.requests() - 1);
}

void Program::collapse_by_operator(Edge e) {
  const std::size_t k = random(2);
  const Vertex gone(twin_.plain()[e].vertices[k]);
  for (const Index wire : twin_.plain().adjacent(gone, 1))  // the operator knows surfaces only
    if (twin_.plain().adjacent(Edge(wire), 2).empty()) return;
  Collapser collapser(twin_.mesh());
  const CollapseRules rules{TurnLimit(175), random(2) ? TopologyRule::Safe : TopologyRule::Paper};
  CollapsePlan plan;
  if (collapser.judge(twin_.mesh(), e, gone, rules, plan).accepted())
    collapser.apply(twin_.mesh(), plan);
}

void Program::change_relations() {
  const int i = static_cast<int>(random(4)), j = (i + 1 + static_cast<int>(random(3))) % 4;
  switch (random(8)) {
    case 0:
    case 1:
      return twin_.set(i, j);
    case 2:
      if (twin_.requests() < 4) twin_.request(i, j);
      return;
    case 3:
    case 4:
      if (twin_.requests() > 0) twin_.release(random(twin_.requests()));
      return;
    default:
      return twin_.unset(i, j);
  }
}

void Program::travel() {
  if (!twin_.attached()) {
    if (random(30) == 0) twin_.attach();
    return;
  }
  const std::size_t size = twin_.journal().size();
  switch (random(size > 60 ? 4 : 8)) {
    case 0:
      return twin_.seek(random(size + 1));
    case 1:
      if (size < 60) return;
      twin_.seek(random(2) ? 0 : size);
      return twin_.detach();
    case 2:
    case 3:
      return twin_.redo();
    default:
      return twin_.undo();
  }
}

}  // namespace aomd::oracle
