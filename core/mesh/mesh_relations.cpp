// T(I,J) of Mesh: bulk building (count, prefix sum, fill), implicit creation of edges, and release.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/mesh/check.h"
#include "core/mesh/mesh.h"

namespace aomd {
namespace {

std::string name(int i, int j) { return "T(" + std::to_string(i) + "," + std::to_string(j) + ")"; }

void check_cell(int i, int j) {
  if (i < 0 || i > 3 || j < 0 || j > 3 || i == j)
    throw std::invalid_argument(name(i, j) +
                                " is not a relation: I and J are two different levels of 0 to 3");
}

}  // namespace

Request& Request::operator=(Request&& other) noexcept {
  std::swap(mesh_, other.mesh_);
  std::swap(i_, other.i_);
  std::swap(j_, other.j_);
  return *this;
}

void Request::release() {
  if (!mesh_) return;
  --mesh_->representation_.demand(i_, j_).requests;
  mesh_->free_unwanted(i_, j_);
  mesh_ = nullptr;
}

void Mesh::set(int i, int j) {
  check_cell(i, j);
  representation_.demand(i, j).user = true;
  build(i, j);
}

void Mesh::unset(int i, int j) {
  check_cell(i, j);
  if (stored(i, j) && defines_level(i, j)) {
    std::string others;
    for (int k = 0; k < i; ++k)
      if (k != j) others += (others.empty() ? "" : " or ") + name(i, k);
    throw std::logic_error(name(i, j) + " defines the " + entity_name(i) +
                           "s: " + (others.empty() ? "delete them first" : "set " + others + " first"));
  }
  representation_.demand(i, j).user = false;
  free_unwanted(i, j);
}

Request Mesh::request(int i, int j) {
  check_cell(i, j);
  build(i, j);
  ++representation_.demand(i, j).requests;
  return Request(*this, i, j);
}

bool Mesh::defines_level(int i, int j) const {
  if (i < j || count(i) == 0) return false;
  for (int k = 0; k < i; ++k)
    if (k != j && stored(i, k)) return false;
  return true;
}

void Mesh::free_unwanted(int i, int j) {
  if (!stored(i, j) || representation_.demand(i, j).wanted() || defines_level(i, j)) return;
  if (i == 1 && j == 0) edge_hash_.release();
  if (i > j)
    representation_.down(i, j).release();
  else
    representation_.up(i, j).release();
}

void Mesh::build(int i, int j) {
  if (stored(i, j)) return;
  ensure_level(std::max(i, j));
  ensure_level(std::min(i, j));
  if (stored(i, j)) return;
  if (i < j)
    build_up(i, j);
  else if (i == 2 && j == 1)
    build_face_edges();
  else if (i == 2 && j == 0)
    build_face_vertices();
  else
    representation_.down(i, j).allocate(capacity(i), widest(i, j), j == i - 1);
}

void Mesh::ensure_level(int dim) {
  if (representation_.has_level(dim)) return;
  AOMD_CHECK(count(dim) == 0);
  representation_.down(dim, 0).allocate(capacity(dim), static_cast<std::uint32_t>(dim + 1), false);
  if (dim == 1) create_implicit_edges();
}

std::uint32_t Mesh::widest(int dim, int lower) const {
  int most = shape_template(level(dim).uniform).count(lower);
  for (const Shape s : level(dim).shapes) most = std::max(most, shape_template(s).count(lower));
  return static_cast<std::uint32_t>(most);
}

void Mesh::build_up(int i, int j) {
  Request sides;  // edges of faces are not derivable from vertices in one step
  if (i == 1 && j == 2) sides = request(2, 1);
  std::array<std::uint32_t, max_shape_vertices> buffer;
  const auto lower = [&](std::uint32_t id) {
    if (i == 0) return vertices_of(EntityRef(j, id), buffer);
    return std::span(static_cast<const Representation&>(representation_).down(j, i).row(id),
                     static_cast<std::size_t>(lower_count(EntityRef(j, id), i)));
  };
  std::vector<std::uint32_t> sizes(capacity(i), 0);
  for (std::uint32_t id = 0; id < capacity(j); ++id)
    if (ids(j).alive(id))
      for (const std::uint32_t l : lower(id)) ++sizes[l];
  UpRows& rows = representation_.up(i, j);
  rows.allocate(sizes);
  for (std::uint32_t id = 0; id < capacity(j); ++id)
    if (ids(j).alive(id))
      for (const std::uint32_t l : lower(id)) rows.append(l, id);
}

void Mesh::build_face_edges() {
  const Request edges_of_vertices = request(0, 1);
  DownRows& rows = representation_.down(2, 1);
  rows.allocate(capacity(2), widest(2, 1), true);
  for (const Face f : faces()) {
    const Row<0> v = row<0>(f);
    for (std::size_t k = 0; k < v.size(); ++k) {
      const Edge e = find_edge(v[k], v[(k + 1) % v.size()]);
      AOMD_CHECK(e.valid());
      rows.row(f.index)[k] = e.index;
    }
    find_use_directions(f.index, v.indices());
  }
}

void Mesh::build_face_vertices() {
  std::array<std::uint32_t, max_shape_vertices> buffer;
  DownRows rows;
  rows.allocate(capacity(2), widest(2, 0), false);
  for (const Face f : faces()) {
    const auto v = vertices_of(f, buffer);
    std::copy(v.begin(), v.end(), rows.row(f.index));
  }
  representation_.down(2, 0) = std::move(rows);
}

// Edges in ascending order of their smaller vertex, then of the first face that uses them, whose direction
// and classification they take. Linear: the sides of each vertex are told apart by marks, not by searching.
void Mesh::create_implicit_edges() {
  const DownRows& rows = std::as_const(representation_).down(2, 0);
  if (count(2) == 0) return;
  std::vector<std::uint32_t> begin(capacity(0) + std::size_t{1}, 0);
  const auto each_side = [&](auto&& visit) {
    for (const Face f : faces()) {
      const std::uint32_t* v = rows.row(f.index);
      const auto n = static_cast<std::uint32_t>(lower_count(f, 0));
      for (std::uint32_t k = 0; k < n; ++k) visit(v[k], v[k + 1 == n ? 0 : k + 1], f.index);
    }
  };
  struct Side {
    std::uint32_t from, to, face;
  };
  each_side([&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++begin[std::min(a, b) + 1]; });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Side> sides(begin.back());
  {
    std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
    each_side([&](std::uint32_t a, std::uint32_t b, std::uint32_t f) {
      sides[at[std::min(a, b)]++] = {a, b, f};
    });
  }
  std::vector<std::uint32_t> mark(capacity(0), no_index);
  std::vector<Side> unique;
  unique.reserve(sides.size() / 2 + 16);
  for (const Side& s : sides) {
    const std::uint32_t low = std::min(s.from, s.to);
    std::uint32_t& seen = mark[std::max(s.from, s.to)];
    if (seen != low) unique.push_back(s);
    seen = low;
  }
  level(1).ids.create_many(static_cast<std::uint32_t>(unique.size()));
  grow_level(1);
  for (std::uint32_t e = 0; e < unique.size(); ++e) {
    std::uint32_t* ends = representation_.down(1, 0).row(e);
    ends[0] = unique[e].from;
    ends[1] = unique[e].to;
    level(1).classes[e] = level(2).classes[unique[e].face];
    if (class_lists_) class_lists_->insert(1, e, level(1).classes[e]);
  }
}

}  // namespace aomd
