#include "tests/support/oracle.h"

#include <algorithm>
#include <set>

#include "core/mesh/derive.h"
#include "core/mesh/names.h"

namespace aomd::oracle {

// The plain model

Ids sorted(Ids ids) {
  std::sort(ids.begin(), ids.end());
  return ids;
}

Ids side(const Entity& whole, int dim, int i) {
  if (dim == 0) return {whole.vertices[static_cast<std::size_t>(i)]};
  const SubEntity& sub = shape_template(whole.shape).sub(dim, i);
  Ids ids;
  for (int k = 0; k < shape_template(sub.shape).vertex_count; ++k)
    ids.push_back(whole.vertices[sub.vertices[static_cast<std::size_t>(k)]]);
  return ids;
}

bool has_side(const Entity& whole, int dim, const Ids& vertices) {
  for (const Index v : vertices)  // saves sorting where a vertex is not there at all
    if (std::find(whole.vertices.begin(), whole.vertices.end(), v) == whole.vertices.end())
      return false;
  for (int i = 0; i < shape_template(whole.shape).count(dim); ++i)
    if (sorted(side(whole, dim, i)) == sorted(vertices)) return true;
  return false;
}

bool same_cycle(const Ids& a, const Ids& b) {
  Ids turned = b;
  for (int reversed = 0; reversed < 2; ++reversed, std::reverse(turned.begin(), turned.end()))
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (turned == a) return true;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
  return false;
}

Plain::Plain(const MeshData& data) {
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    const ModelRef model = data.vertex_classes.empty() ? ModelRef() : data.vertex_classes[v];
    create(0, {Shape::Point, {static_cast<Index>(v)}, model, data.positions[v]});
  }
  for (int dim = 1; dim <= 3; ++dim) {
    const EntityList& list = data.list(dim);
    auto at = list.vertices.begin();
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto end = at + shape_template(list.shapes[i]).vertex_count;
      create(dim,
             {list.shapes[i], Ids(at, end), list.classes.empty() ? ModelRef() : list.classes[i]});
      at = end;
    }
  }
}

Ids Plain::adjacent(EntityRef e, int j) const {
  Ids result;
  const Entity& own = (*this)[e];
  if (j < e.dimension)
    for (int i = 0; i < shape_template(own.shape).count(j); ++i)
      result.push_back(find(j, side(own, j, i)));
  else
    for (const auto& [id, higher] : level(j))
      if (has_side(higher, e.dimension, own.vertices)) result.push_back(id);
  return result;
}

std::map<Index, Ids> Plain::rows(int i, int j) const {
  const int low = std::min(i, j), high = std::max(i, j);
  std::map<Ids, Ids> by_vertices;
  for (const auto& [id, e] : level(low)) by_vertices[sorted(e.vertices)].push_back(id);
  std::map<Index, Ids> result;
  for (const auto& [id, e] : level(i)) result[id];
  for (const auto& [id, e] : level(high))
    for (int k = 0; k < shape_template(e.shape).count(low); ++k) {
      const auto found = by_vertices.find(sorted(side(e, low, k)));
      if (i > j)
        result[id].push_back(found == by_vertices.end() ? no_index : found->second.front());
      if (i < j && found != by_vertices.end())
        for (const Index lower : found->second) result[lower].push_back(id);
    }
  return result;
}

Index Plain::find(int dim, const Ids& vertices) const {
  if (dim == 0) return alive(EntityRef(0, vertices[0])) ? vertices[0] : no_index;
  const Ids key = sorted(vertices);
  for (const auto& [id, e] : level(dim))
    if (e.vertices.size() == key.size() && sorted(e.vertices) == key) return id;
  return no_index;
}

std::vector<EntityRef> Plain::users(EntityRef e) const {
  std::vector<EntityRef> result;
  for (int j = e.dimension + 1; j <= 3; ++j)
    for (const Index id : adjacent(e, j)) result.emplace_back(j, id);
  return result;
}

bool Plain::use_direction(const Entity& whole, int i, const Entity& own) const {
  const int dim = shape_template(own.shape).dimension;
  const Ids seen = side(whole, dim, i);
  if (dim == 1) return seen == own.vertices;
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (seen[k] == own.vertices[0]) return seen[(k + 1) % seen.size()] == own.vertices[1];
  return false;
}

std::vector<Ids> Plain::missing_sides(const Entity& whole, int dim) const {
  std::vector<Ids> result;
  for (int i = 0; i < shape_template(whole.shape).count(dim); ++i)
    if (Ids s = side(whole, dim, i); find(dim, s) == no_index) result.push_back(std::move(s));
  return result;
}

std::map<Ids, ModelRef> Plain::missing(int dim) const {
  std::set<Ids> known;
  for (const auto& [id, e] : level(dim)) known.insert(sorted(e.vertices));
  std::map<Ids, ModelRef> result;
  for (int high = dim + 1; high <= 3; ++high)
    for (const auto& [id, e] : level(high))
      for (int i = 0; i < shape_template(e.shape).count(dim); ++i)
        if (const Ids key = sorted(side(e, dim, i)); !known.count(key))
          result.try_emplace(key, e.model);
  return result;
}

Index Plain::create(int dim, const Entity& entity, bool fresh) {
  const auto d = static_cast<std::size_t>(dim);
  Index id = capacity_[d];
  if (fresh || free_[d].empty()) {
    ++capacity_[d];
  } else {
    id = free_[d].back();
    free_[d].pop_back();
  }
  Entity& made = levels_[d][id] = entity;
  static std::uint64_t instances =
      0;  // of all models, so that no copy of one gives out a number twice
  made.instance = ++instances;
  if (dim == 0) made.vertices = {id};
  return id;
}

void Plain::destroy(EntityRef e) {
  levels_[static_cast<std::size_t>(e.dimension)].erase(e.index);
  free_ids(e.dimension).push_back(e.index);
}

void Plain::compact() {
  std::map<Index, Index> renamed;
  for (const auto& [id, e] : level(0)) renamed.emplace(id, static_cast<Index>(renamed.size()));
  for (std::size_t d = 0; d < 4; ++d) {
    std::map<Index, Entity> consecutive;
    for (auto& [id, e] : levels_[d]) {
      for (Index& v : e.vertices) v = renamed.at(v);
      consecutive.emplace(static_cast<Index>(consecutive.size()), std::move(e));
    }
    levels_[d] = std::move(consecutive);
    free_[d].clear();
    capacity_[d] = static_cast<Index>(levels_[d].size());
  }
}

// The comparison

namespace {

std::string text(const Ids& ids) {
  std::string s = "(";
  for (const Index id : ids)
    s += (s.size() > 1 ? " " : "") + (id == no_index ? "-" : std::to_string(id));
  return s + ")";
}

std::string differ(const std::string& what, const Ids& is, const Ids& should) {
  return is == should ? "" : what + " is " + text(is) + ", should be " + text(should);
}

std::string cell(const char* what, int i, int j) {
  return std::string(what) + " T(" + std::to_string(i) + "," + std::to_string(j) + ")";
}

template <int I, int J>
Ids row_of(const Mesh& mesh, Index id) {
  const auto row = mesh.row<J>(Handle<I>(id)).indices();
  return {row.begin(), row.end()};
}

Ids stored_row(const Mesh& mesh, EntityRef e, int j) {
  using Read = Ids (*)(const Mesh&, Index);
  constexpr Read table[4][4] = {{nullptr, row_of<0, 1>, row_of<0, 2>, row_of<0, 3>},
                                {row_of<1, 0>, nullptr, row_of<1, 2>, row_of<1, 3>},
                                {row_of<2, 0>, row_of<2, 1>, nullptr, row_of<2, 3>},
                                {row_of<3, 0>, row_of<3, 1>, row_of<3, 2>, nullptr}};
  return table[e.dimension][j](mesh, e.index);
}

// Stored or derived: one of them where there is a way, the documented exception where there is
// none.
std::string relation_difference(const Mesh& mesh, EntityRef e, int j, const Ids& should) {
  const int i = e.dimension;
  if (mesh.stored(i, j))
    if (std::string d = differ(name_of(e) + cell(" stored", i, j), stored_row(mesh, e, j), should);
        !d.empty())
      return d;
  const bool empty_above = i < j && mesh.count(j) == 0;
  const bool possible =
      explain(mesh, i, j).kind != AdjacencyPath::Kind::None && (i < j || mesh.complete(j));
  Ids derived;
  try {
    adjacent(mesh, e, j, derived);
    if (!possible && !empty_above) return name_of(e) + cell(" derived", i, j) + " should throw";
  } catch (const std::logic_error& error) {
    return possible ? name_of(e) + cell(" derived", i, j) + " throws: " + error.what() : "";
  }
  return differ(name_of(e) + cell(" derived", i, j), derived, should);
}

std::string direction_difference(const Mesh& mesh, const Plain& plain, EntityRef e) {
  const int dim = e.dimension - 1;
  if (dim < 1 || !mesh.stored(e.dimension, dim)) return "";
  const Ids sides = stored_row(mesh, e, dim);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const EntityRef s(dim, sides[k]);
    const bool is = dim == 1 ? mesh.use_direction(Face(e.index), Edge(s.index))
                             : mesh.use_direction(Region(e.index), Face(s.index));
    if (is != plain.use_direction(plain[e], static_cast<int>(k), plain[s]))
      return name_of(e) + " has a wrong use direction of " + name_of(s);
  }
  return "";
}

std::string self_difference(const Mesh& mesh, const Plain& plain, EntityRef e) {
  if (!mesh.alive(e)) return name_of(e) + " should be alive";
  const Entity& own = plain[e];
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(e, buffer);
  if (mesh.shape(e) != own.shape) return name_of(e) + " has a wrong shape";
  if (mesh.classification(e) != own.model) return name_of(e) + " has a wrong class";
  if (e.dimension == 0 && mesh.position(Vertex(e.index)) != own.position)
    return name_of(e) + " is elsewhere";
  return differ(name_of(e) + " on vertices", Ids(v.begin(), v.end()), own.vertices);
}

Index found_by_mesh(const Mesh& mesh, int dim, const Ids& vertices) {
  std::vector<Vertex> v;
  for (const Index id : vertices) v.emplace_back(id);
  if (dim == 1) return mesh.find_edge(v[0], v[1]).index;
  return dim == 2 ? mesh.find_face(v).index : mesh.find_region(v).index;
}

std::string class_list_difference(const Mesh& mesh, const Plain& plain, int dim) {
  std::map<std::uint32_t, Ids> should;
  for (const auto& [id, e] : plain.level(dim)) should[e.model.bits()].push_back(id);
  if (mesh.class_lists()->models(dim).size() != should.size() ||
      mesh.class_lists()->model_count(dim) != should.size())
    return std::string("model entities with a ") + entity_name(dim) + " on them";
  for (const auto& [bits, ids] : should) {
    const auto is = mesh.class_lists()->entities(dim, ModelRef::from_bits(bits));
    if (std::string d = differ("class list", sorted({is.begin(), is.end()}), ids); !d.empty())
      return d;
  }
  return "";
}

}  // namespace

std::string state_difference(const Mesh& mesh, const Plain& plain) {
  for (int dim = 0; dim <= 3; ++dim) {
    const std::string kind = entity_name(dim);
    if (mesh.count(dim) != plain.count(dim)) return "count of level " + kind;
    if (mesh.capacity(dim) != plain.capacity(dim)) return "capacity of level " + kind;
    if (std::string d = differ(kind + " stack", mesh.ids(dim).free_ids(), plain.free_ids(dim));
        !d.empty())
      return d;
    for (const auto& [id, e] : plain.level(dim))
      if (std::string d = self_difference(mesh, plain, EntityRef(dim, id)); !d.empty()) return d;
    if (mesh.class_lists())
      if (std::string d = class_list_difference(mesh, plain, dim); !d.empty()) return d;
  }
  return "";
}

std::string entity_difference(const Mesh& mesh, const Plain& plain, EntityRef e) {
  if (std::string d = self_difference(mesh, plain, e); !d.empty()) return d;
  for (int j = 0; j <= 3; ++j) {
    if (j == e.dimension) continue;
    if (std::string d = relation_difference(mesh, e, j, plain.adjacent(e, j)); !d.empty()) return d;
  }
  if (mesh.users(e) != plain.users(e)) return name_of(e) + " has wrong users";
  if (e.dimension > 0 && found_by_mesh(mesh, e.dimension, plain[e].vertices) !=
                             plain.find(e.dimension, plain[e].vertices))
    return name_of(e) + " is not found";
  return direction_difference(mesh, plain, e);
}

std::string difference(const Mesh& mesh, const Plain& plain) {
  if (std::string d = state_difference(mesh, plain); !d.empty()) return d;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; j <= 3; ++j) {
      if (i == j) continue;
      for (const auto& [id, row] : plain.rows(i, j))
        if (std::string d = relation_difference(mesh, EntityRef(i, id), j, row); !d.empty())
          return d;
    }
  for (int dim = 1; dim <= 3; ++dim) {
    std::map<Ids, Index> first;
    for (const auto& [id, e] : plain.level(dim)) first.try_emplace(sorted(e.vertices), id);
    for (const auto& [id, e] : plain.level(dim)) {
      const Index should = first.at(sorted(e.vertices));
      if (const Index is = found_by_mesh(mesh, dim, e.vertices); is != should)
        return name_of(EntityRef(dim, id)) + " is found as " + std::to_string(is) + ", should be " +
               std::to_string(should);
      if (std::string d = direction_difference(mesh, plain, EntityRef(dim, id)); !d.empty())
        return d;
    }
  }
  return "";
}

}  // namespace aomd::oracle
