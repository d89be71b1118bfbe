#include "tests/support/twin.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "core/mesh/names.h"
#include "core/mesh/verify.h"

namespace aomd::oracle {
namespace {

constexpr double initial_value = -1;

template <typename H>
std::vector<H> handles(const Ids& ids) {
  std::vector<H> result;
  for (const Index id : ids) result.emplace_back(id);
  return result;
}

template <typename H>
Attached<H, double>& values_of(Mesh& mesh) {
  return mesh.attached<H, double>("value", initial_value);
}

int dimension_of(Shape shape) { return shape_template(shape).dimension; }

}  // namespace

Twin::Twin(const MeshData& data, const std::function<void(Mesh&)>& prepare)
    : mesh_(data), plain_(data) {
  if (prepare) {
    std::array<std::map<Ids, ModelRef>, 4> missing;
    for (int dim : {1, 2}) missing[static_cast<std::size_t>(dim)] = plain_.missing(dim);
    prepare(mesh_);
    for (int dim : {2, 1})
      if (mesh_.complete(dim)) take_missing(dim, missing[static_cast<std::size_t>(dim)]);
  }
  mesh_.keep_class_lists(true);
  values_of<Vertex>(mesh_);
  values_of<Edge>(mesh_);
  values_of<Face>(mesh_);
  values_of<Region>(mesh_);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i != j)
        user_[i][j] = mesh_.representation().demand(static_cast<int>(i), static_cast<int>(j)).user;
}

// Creation

Index Twin::create_vertex(const glm::dvec3& position, ModelRef model) {
  const Index id = mesh_.create_vertex(position, model).index;
  expect(plain_.create(0, {Shape::Point, {}, model, position}) == id,
         "vertex got id " + std::to_string(id));
  touch(Vertex(id));
  edited();
  return id;
}

// Why the mesh must refuse, by the documentation.
std::string Twin::reason_against(Shape shape, const Ids& vertices, ModelRef model) const {
  const int dim = dimension_of(shape);
  if (!model.may_classify(dim)) return "class";
  for (const Index v : vertices)
    if (!plain_.alive(Vertex(v))) return "dead vertex";
  if (std::set<Index>(vertices.begin(), vertices.end()).size() != vertices.size())
    return "repeated vertex";
  const bool unique = dim == 1 || (dim == 2 && plain_.count(3) > 0);
  return unique && plain_.find(dim, vertices) != no_index ? "exists" : "";
}

void Twin::call_create(Shape shape, const Ids& vertices, ModelRef model, From from) {
  const int dim = dimension_of(shape);
  Ids sides;
  const int k = from == From::Edges ? 1 : from == From::Faces ? 2 : 0;
  for (int i = 0; k > 0 && i < shape_template(shape).count(k); ++i)
    sides.push_back(plain_.find(k, side({shape, vertices, model}, k, i)));
  if (dim == 1) (void)mesh_.create_edge(Vertex(vertices[0]), Vertex(vertices[1]), model);
  if (dim == 2 && k == 0) (void)mesh_.create_face(handles<Vertex>(vertices), model);
  if (dim == 2 && k == 1) (void)mesh_.create_face(handles<Edge>(sides), model);
  if (dim == 3 && k == 0) (void)mesh_.create_region(shape, handles<Vertex>(vertices), model);
  if (dim == 3 && k == 1) (void)mesh_.create_region(shape, handles<Edge>(sides), model);
  if (dim == 3 && k == 2) (void)mesh_.create_region(shape, handles<Face>(sides), model);
}

bool Twin::create(Shape shape, const Ids& vertices, ModelRef model, From from) {
  const std::string reason = reason_against(shape, vertices, model);
  try {
    call_create(shape, vertices, model, from);
  } catch (const std::invalid_argument& error) {
    expect(!reason.empty(), std::string("creation refused: ") + error.what());
    return false;
  }
  expect(reason.empty(), "creation should be refused: " + reason);
  const int dim = dimension_of(shape);
  const Entity whole{shape, vertices, model};
  for (int k = 1; k < dim; ++k)
    if (mesh_.complete(k)) take_sides(k, whole);
  touch(EntityRef(dim, plain_.create(dim, whole)));
  edited();
  return true;
}

// The sides that creating an entity brought along: just those that were missing, with its class;
// which of them got which id, and which vertex comes first, is the mesh's business.
void Twin::take_sides(int dim, const Entity& whole) {
  std::vector<Ids> missing = plain_.missing_sides(whole, dim);
  for (std::size_t n = missing.size(); n > 0; --n) {
    Entity made{dim == 1 ? Shape::Line : Shape::Triangle, {}, whole.model};
    const EntityRef e(dim, plain_.create(dim, made));
    expect(mesh_.alive(e), name_of(e) + " should have been created as a side");
    VertexBuffer buffer;
    const auto v = mesh_.vertices_of(e, buffer);
    plain_[e].vertices.assign(v.begin(), v.end());
    plain_[e].shape = mesh_.shape(e);
    const auto at = std::find_if(missing.begin(), missing.end(),
                                 [&](const Ids& s) { return same_cycle(s, plain_[e].vertices); });
    expect(at != missing.end(), name_of(e) + " is no side that was missing");
    missing.erase(at);
    touch(e);
  }
}

// Deletion and other edits

bool Twin::destroy(EntityRef e) {
  const std::vector<EntityRef> users = plain_.users(e);
  try {
    mesh_.destroy(e);
  } catch (const std::logic_error& error) {
    expect(!users.empty(), std::string("deletion refused: ") + error.what());
    const std::string first = name_of(e) + " is used by " + name_of(users[0]);
    expect(std::string(error.what()).find(first) == 0,
           std::string("refusal says: ") + error.what());
    return false;
  }
  expect(users.empty(), "deletion of " + name_of(e) + " should be refused");
  plain_.destroy(e);
  edited();
  return true;
}

void Twin::destroy_with_users(EntityRef e) {
  std::vector<EntityRef> gone = plain_.users(e);
  mesh_.destroy_with_users(e);
  gone.push_back(e);
  std::array<std::size_t, 4> removed{};
  for (const EntityRef g : gone) {
    plain_.destroy(g);
    ++removed[g.dimension];
  }
  for (int dim = 0; dim <= 3; ++dim) check_stack(dim, removed[static_cast<std::size_t>(dim)]);
  edited();
}

// The order in which several entities of a level were deleted is the mesh's business, not which.
void Twin::check_stack(int dim, std::size_t removed) {
  Ids& should = plain_.free_ids(dim);
  const Ids& is = mesh_.ids(dim).free_ids();
  expect(
      is.size() == should.size() &&
          std::equal(is.begin(), is.end() - static_cast<std::ptrdiff_t>(removed), should.begin()) &&
          std::is_permutation(is.begin(), is.end(), should.begin()),
      std::string("stack of level ") + entity_name(dim));
  should = is;
}

void Twin::move(Vertex v, const glm::dvec3& position) {
  mesh_.move(v, position);
  plain_[v].position = position;
  touch(v);
  edited();
}

bool Twin::classify(EntityRef e, ModelRef model) {
  const bool legal = model.may_classify(e.dimension);
  try {
    mesh_.set_classification(e, model);
  } catch (const std::invalid_argument& error) {
    expect(!legal, std::string("classification refused: ") + error.what());
    return false;
  }
  expect(legal, "classification of " + name_of(e) + " should be refused");
  plain_[e].model = model;
  touch(e);
  edited();
  return true;
}

// Whatever surrounds one end and could be seen from the other must lie in something that joins the
// two.
bool Twin::may_collapse(Index gone, Index kept) const {
  std::set<Ids> around[2], between;
  const auto note = [&](const Ids& vertices) {
    Ids rest = sorted(vertices);
    const bool a = std::erase(rest, gone) > 0, b = std::erase(rest, kept) > 0;
    if (a && b) between.insert(rest);
    if (a != b) around[a ? 0 : 1].insert(rest);
  };
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto& [id, e] : plain_.level(dim)) {
      const bool a = has_side(e, 0, {gone}), b = has_side(e, 0, {kept});
      if (!a && !b) continue;
      if (a && b && static_cast<int>(e.vertices.size()) != dim + 1) return false;
      note(e.vertices);
      for (int k = 1; k < dim; ++k)
        for (int i = 0; i < shape_template(e.shape).count(k); ++i) note(side(e, k, i));
    }
  return between.count({}) > 0 &&
         std::all_of(around[0].begin(), around[0].end(), [&](const Ids& s) {
           return s.empty() || !around[1].count(s) || between.count(s);
         });
}

bool Twin::collapse(Vertex gone, Vertex kept) {
  if (!may_collapse(gone.index, kept.index)) return false;
  std::vector<Rebinding> items;
  std::vector<EntityRef> doomed;
  for (int dim = 1; dim <= 3; ++dim)
    for (const auto& [id, e] : plain_.level(dim)) {
      const auto at = std::find(e.vertices.begin(), e.vertices.end(), gone.index);
      if (at == e.vertices.end()) continue;
      Ids after = e.vertices;
      std::replace(after.begin(), after.end(), gone.index, kept.index);
      if (has_side(e, 0, {kept.index}) || plain_.find(dim, after) != no_index)
        doomed.emplace_back(dim, id);
      else
        items.push_back(
            {EntityRef(dim, id), static_cast<std::uint32_t>(at - e.vertices.begin()), gone, kept});
    }
  if (attached()) journal_.begin_step(StepKind::Collapse, gone);
  mesh_.rebind(items);
  for (const Rebinding& r : items) {
    plain_[r.entity].vertices[r.slot] = kept.index;
    touch(r.entity);
  }
  doomed.insert(doomed.begin(), gone);
  for (auto it = doomed.rbegin(); it != doomed.rend(); ++it) {
    mesh_.destroy_unused(*it);
    plain_.destroy(*it);
  }
  if (attached()) journal_.end_step();
  touch(kept);
  edited();
  return true;
}

void Twin::adopt() {
  for (int dim = 0; dim <= 3; ++dim) {
    std::vector<EntityRef> gone;
    for (const auto& [id, e] : plain_.level(dim)) {
      const EntityRef ref(dim, id);
      if (!mesh_.alive(ref)) {
        gone.push_back(ref);
        continue;
      }
      VertexBuffer buffer;
      const auto v = mesh_.vertices_of(ref, buffer);
      Entity& own = plain_[ref];
      if (Ids now(v.begin(), v.end()); now != own.vertices) {
        own.vertices = std::move(now);
        touch(ref);
      }
      own.model = mesh_.classification(ref);
      if (dim == 0) own.position = mesh_.position(Vertex(id));
    }
    for (const EntityRef g : gone) plain_.destroy(g);
    check_stack(dim, gone.size());
  }
  edited();
}

void Twin::compact() {
  if (attached()) {
    try {
      (void)mesh_.compact();
    } catch (const std::logic_error&) {
      return;
    }
    throw Difference("compact() should refuse while a journal is attached");
  }
  const auto maps = mesh_.compact();
  for (int dim = 0; dim <= 3; ++dim) {
    Index next = 0;
    const auto& map = maps[static_cast<std::size_t>(dim)];
    expect(map.size() == plain_.capacity(dim), "size of compact()'s answer");
    for (Index id = 0; id < map.size(); ++id)
      expect(map[id] == (plain_.alive(EntityRef(dim, id)) ? next++ : no_index),
             "compact()'s answer");
  }
  plain_.compact();
  touched_.clear();
}

// Attached data and comparison

void Twin::set_value(EntityRef e, double value) {
  if (e.dimension == 0) values_of<Vertex>(mesh_)[Vertex(e.index)] = value;
  if (e.dimension == 1) values_of<Edge>(mesh_)[Edge(e.index)] = value;
  if (e.dimension == 2) values_of<Face>(mesh_)[Face(e.index)] = value;
  if (e.dimension == 3) values_of<Region>(mesh_)[Region(e.index)] = value;
  values_[plain_[e].instance] = value;
}

double Twin::value_in_mesh(EntityRef e) const {
  const std::string column = "value";
  if (e.dimension == 0) return (*mesh_.find_attached<Vertex, double>(column))[Vertex(e.index)];
  if (e.dimension == 1) return (*mesh_.find_attached<Edge, double>(column))[Edge(e.index)];
  if (e.dimension == 2) return (*mesh_.find_attached<Face, double>(column))[Face(e.index)];
  return (*mesh_.find_attached<Region, double>(column))[Region(e.index)];
}

void Twin::check_values() const {
  for (int dim = 0; dim <= 3; ++dim)
    for (const auto& [id, e] : plain_.level(dim)) {
      const auto at = values_.find(e.instance);
      const double should = at == values_.end() ? initial_value : at->second;
      expect(value_in_mesh(EntityRef(dim, id)) == should,
             "value of " + name_of(EntityRef(dim, id)));
    }
}

void Twin::check_touched(std::mt19937_64& random) {
  std::erase_if(touched_, [&](EntityRef e) { return !plain_.alive(e); });
  for (int dim = 0; dim <= 3; ++dim)
    expect(mesh_.count(dim) == plain_.count(dim),
           std::string("count of level ") + entity_name(dim));
  if (touched_.empty()) return;
  const EntityRef e = touched_[random() % touched_.size()];
  touched_.clear();
  if (std::string d = entity_difference(mesh_, plain_, e); !d.empty()) throw Difference(d);
}

void Twin::check_all() const {
  if (std::string d = difference(mesh_, plain_); !d.empty()) throw Difference(d);
  check_values();
  for (const Finding& f : verify(mesh_))  // programs classify at random, so closure does not hold
    expect(f.name == "classification closure", "verify: " + f.name + ": " + f.text);
}

}  // namespace aomd::oracle
