#include "core/mesh/derive.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/assertion.h"
#include "core/mesh/names.h"
#include "core/mesh/side_index.h"

namespace aomd {
namespace {

using Kind = AdjacencyPath::Kind;
using Ids = std::vector<std::uint32_t>;

constexpr double hash_cost = 8;

// The way from an entity to its vertices, as Mesh::vertices_of goes it.
LevelPath way_to_vertices(const Mesh& mesh, int i) {
  LevelPath levels{i};
  while (i > 0 && !mesh.stored(i, 0) && mesh.representation().has_level(i))
    levels.push_back(i = mesh.stored(i, 2) && i == 3 ? 2 : 1);
  if (i > 0) levels.push_back(0);
  return levels;
}

double row_cost(const Mesh& mesh, const LevelPath& levels) {
  double rows = 1, cost = 0;
  for (std::size_t k = 1; k < levels.size(); ++k) {
    rows *= mesh.representation().average_row(levels[k - 1], levels[k]);
    cost += rows;
  }
  return cost;
}

class Explorer {
 public:
  Explorer(const Mesh& mesh, int i, int j) : mesh_(mesh), i_(i), j_(j) {}

  AdjacencyPath run() {
    if (mesh_.stored(i_, j_)) {
      offer(Kind::Stored, {i_, j_}, row_cost(mesh_, {i_, j_}));
    } else if (i_ < j_) {
      offer_upward();
      offer_shared();
    } else if (mesh_.representation().has_level(i_)) {
      offer_downward();
    }
    return best_;
  }

 private:
  void offer(Kind kind, LevelPath levels, double cost, bool by_hash = false) {
    if (best_.kind == Kind::None || cost < best_.cost) best_ = {kind, levels, by_hash, cost};
  }

  void offer_upward() {
    for (int k = i_ + 1; k < j_; ++k)
      if (mesh_.stored(i_, k) && mesh_.stored(k, j_))
        offer(Kind::Upward, {i_, k, j_}, row_cost(mesh_, {i_, k, j_}));
    if (i_ == 0 && j_ == 3 && mesh_.stored(0, 1) && mesh_.stored(1, 2) && mesh_.stored(2, 3))
      offer(Kind::Upward, {0, 1, 2, 3}, row_cost(mesh_, {0, 1, 2, 3}));
  }

  // The rows of all lower entities are looked at for the shortest; its entries are tested by their
  // vertices.
  void offer_shared() {
    for (int k = 0; k < i_; ++k) {
      if (!mesh_.stored(k, j_) || (k > 0 && !mesh_.stored(i_, k))) continue;
      LevelPath levels = k == 0 ? way_to_vertices(mesh_, i_) : LevelPath{i_, k};
      const double down = row_cost(mesh_, levels), up = mesh_.representation().average_row(k, j_);
      levels.push_back(j_);
      offer(Kind::Shared, levels, down + up * (1 + row_cost(mesh_, way_to_vertices(mesh_, j_))));
    }
  }

  void offer_downward() {
    LevelPath levels = way_to_vertices(mesh_, i_);
    const double corners = row_cost(mesh_, levels);
    if (j_ == 0) return offer(Kind::Corners, levels, corners);
    if (!mesh_.complete(j_)) return;
    if (mesh_.stored(i_, 2) && i_ == 3 && j_ == 1 && mesh_.stored(2, 1))
      offer(Kind::Downward, {3, 2, 1}, corners + 3 * row_cost(mesh_, {3, 2, 1}));
    const bool adjacency =
        mesh_.stored(0, j_) || (j_ == 2 && mesh_.stored(0, 1) && mesh_.stored(1, 2));
    const double query = mesh_.stored(0, j_)
                             ? mesh_.representation().average_row(0, j_) * (j_ == 1 ? 2 : 4)
                         : adjacency ? mesh_.representation().average_row(0, 1) * 2 + 8
                                     : hash_cost;
    levels.push_back(j_);
    offer(Kind::Sides, levels, corners + query * mesh_.dimension() * 2, !adjacency);
  }

  const Mesh& mesh_;
  int i_, j_;
  AdjacencyPath best_;
};

void sort_unique(Ids& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

void read_row(const Mesh& mesh, EntityRef e, int j, Ids& result) {
  if (e.dimension < j) {
    const auto row = mesh.representation().up(e.dimension, j).row(e.index);
    result.assign(row.begin(), row.end());
  } else {
    const std::uint32_t* row = mesh.representation().down(e.dimension, j).row(e.index);
    result.assign(row, row + shape_template(mesh.shape(e)).count(j));
  }
}

void go_up(const Mesh& mesh, EntityRef e, const LevelPath& levels, Ids& result) {
  Ids from{e.index};
  for (std::size_t k = 1; k < levels.size(); ++k) {
    result.clear();
    for (const std::uint32_t id : from) {
      const auto row = mesh.representation().up(levels[k - 1], levels[k]).row(id);
      result.insert(result.end(), row.begin(), row.end());
    }
    sort_unique(result);
    if (k + 1 < levels.size()) from = result;
  }
}

void go_shared(const Mesh& mesh, EntityRef e, const LevelPath& levels, Ids& result) {
  const int k = levels[levels.size() - 2], j = levels[levels.size() - 1];
  VertexBuffer buffer;
  const auto own = mesh.vertices_of(e, buffer);
  std::span<const std::uint32_t> lower = own;
  if (k > 0)
    lower = {mesh.representation().down(e.dimension, k).row(e.index),
             static_cast<std::size_t>(shape_template(mesh.shape(e)).count(k))};
  auto shortest = mesh.representation().up(k, j).row(lower[0]);
  for (const std::uint32_t l : lower.subspan(1))
    if (const auto row = mesh.representation().up(k, j).row(l); row.size() < shortest.size())
      shortest = row;
  for (const std::uint32_t id : shortest)
    if (has_side(mesh, EntityRef(j, id), e.dimension, own)) result.push_back(id);
}

void go_down(const Mesh& mesh, EntityRef region, Ids& result) {
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(region, buffer);
  const ShapeTemplate& shape = shape_template(mesh.shape(region));
  const auto edge_of = [&](std::uint32_t a, std::uint32_t b) {
    for (const Face f : mesh.row<2>(Region(region.index)))
      for (const Edge e : mesh.row<1>(f)) {
        const auto ends = mesh.edge_vertices(e);
        if ((ends[0].index == a && ends[1].index == b) ||
            (ends[0].index == b && ends[1].index == a))
          return e.index;
      }
    return no_index;
  };
  for (int i = 0; i < shape.edge_count; ++i) {
    const auto& ends = shape.sub(1, i).vertices;
    result.push_back(edge_of(vertices[ends[0]], vertices[ends[1]]));
    AOMD_CHECK(result.back() != no_index);
  }
}

void go_sides(const Mesh& mesh, EntityRef e, int j, Ids& result) {
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  const ShapeTemplate& shape = shape_template(mesh.shape(e));
  for (int i = 0; i < shape.count(j); ++i) {
    const SideVertices side(shape.sub(j, i), vertices.data());
    std::array<Vertex, max_face_vertices> v;
    for (std::uint32_t k = 0; k < side.count; ++k) v[k] = Vertex(side.ids[k]);
    const std::uint32_t found = j == 1 ? mesh.find_edge(v[0], v[1]).index
                                       : mesh.find_face(std::span(v).first(side.count)).index;
    AOMD_CHECK(found != no_index);
    result.push_back(found);
  }
}

[[noreturn]] void fail(const Mesh& mesh, int i, int j) {
  if (i > j && j > 0 && !mesh.complete(j))
    throw std::logic_error(relation_name(i, j) + " is not stored, and not every " + entity_name(j) +
                           " exists: request " + relation_name(i, j));
  std::string others;
  for (int k = i + 1; k < j; ++k)
    others +=
        ", or " + (mesh.stored(i, k) ? "" : relation_name(i, k) + " and ") + relation_name(k, j);
  if (i > 0) others += ", or " + relation_name(0, j);
  throw std::logic_error(relation_name(i, j) + " is not stored and no path leads there: request " +
                         relation_name(i, j) + others);
}

}  // namespace

std::string AdjacencyPath::text() const {
  constexpr const char* how[] = {"stored",
                                 "union of rows",
                                 "what has it as a side",
                                 "vertices from its sides",
                                 "edges of its faces",
                                 "each side looked up",
                                 "no path: request it"};
  std::string result;
  for (const std::int8_t level : levels)
    result += (result.empty() ? "" : " -> ") + std::to_string(int{level});
  return result + (result.empty() ? "" : " (") + how[static_cast<std::size_t>(kind)] +
         (by_hash ? " by hash" : "") + (result.empty() ? "" : ")");
}

AdjacencyPath explain(const Mesh& mesh, int i, int j) {
  if (i < 0 || i > 3 || j < 0 || j > 3 || i == j)
    throw std::invalid_argument(relation_name(i, j) + " is not a relation");
  return Explorer(mesh, i, j).run();
}

bool has_side(const Mesh& mesh, EntityRef e, int k, std::span<const std::uint32_t> side) {
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  const auto uses = [&](std::uint32_t v) {
    return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
  };
  if (!std::all_of(side.begin(), side.end(), uses)) return false;
  const ShapeTemplate& shape = shape_template(mesh.shape(e));
  const bool simplex = shape.vertex_count == e.dimension + 1;  // any of its vertices form a side
  if (k == 0 || simplex) return side.size() == static_cast<std::size_t>(k + 1);
  for (int i = 0; i < shape.count(k); ++i) {
    const SideVertices s(shape.sub(k, i), vertices.data());
    if (s.count == side.size() && std::is_permutation(side.begin(), side.end(), s.ids.begin()))
      return true;
  }
  return false;
}

void adjacent(const Mesh& mesh, EntityRef e, int j, std::vector<std::uint32_t>& result) {
  result.clear();
  const int i = e.dimension;
  if (mesh.stored(i, j)) return read_row(mesh, e, j, result);
  const AdjacencyPath path = explain(mesh, i, j);
  switch (path.kind) {
    case Kind::Stored:
      return;
    case Kind::Upward:
      return go_up(mesh, e, path.levels, result);
    case Kind::Shared:
      return go_shared(mesh, e, path.levels, result);
    case Kind::Corners: {
      VertexBuffer buffer;
      const auto vertices = mesh.vertices_of(e, buffer);
      result.assign(vertices.begin(), vertices.end());
      return;
    }
    case Kind::Downward:
      return go_down(mesh, e, result);
    case Kind::Sides:
      return go_sides(mesh, e, j, result);
    case Kind::None:
      if (i < j && mesh.count(j) == 0) return;
      fail(mesh, i, j);
  }
}

}  // namespace aomd
