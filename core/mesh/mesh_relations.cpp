// T(I,J) of Mesh: what is stored, who wants it, and bulk building (count, prefix sum, fill).

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/bulk.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/names.h"

namespace aomd {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point before) {
  return std::chrono::duration<double, std::milli>(Clock::now() - before).count();
}

void check_cell(int i, int j) {
  if (i < 0 || i > 3 || j < 0 || j > 3 || i == j)
    throw std::invalid_argument(relation_name(i, j) +
                                " is not a relation: I and J are two different levels of 0 to 3");
}

}  // namespace

Request& Request::operator=(Request&& other) noexcept {
  std::swap(mesh_, other.mesh_);
  std::swap(i_, other.i_);
  std::swap(j_, other.j_);
  std::swap(by_, other.by_);
  return *this;
}

void Request::release() {
  if (!mesh_) return;
  Representation::Demand& demand = mesh_->representation_.demand(i_, j_);
  --demand.requests;
  demand.by.erase(std::find(demand.by.begin(), demand.by.end(), by_));
  mesh_->free_unwanted(i_, j_);
  mesh_ = nullptr;
}

void Mesh::set(int i, int j) {
  check_cell(i, j);
  complete_levels(i, j);
  build(i, j);
  representation_.demand(i, j).user = true;
}

void Mesh::unset(int i, int j) {
  check_cell(i, j);
  if (stored(i, j) && defines_level(i, j)) {
    std::string others;
    for (int k = 0; k < i; ++k)
      if (k != j && can_hold(i, k)) others += (others.empty() ? "" : " or ") + relation_name(i, k);
    throw std::logic_error(relation_name(i, j) + " defines the " + entity_plural(i) + ": " +
                           (others.empty() ? "delete them first" : "set " + others + " first"));
  }
  representation_.demand(i, j).user = false;
  free_unwanted(i, j);
}

Request Mesh::request(int i, int j, const char* by) {
  check_cell(i, j);
  complete_levels(i, j);
  return hold(i, j, by);
}

Request Mesh::request_listed(int i, int j, const char* by) {
  check_cell(i, j);
  if (i > 0 && j > 0)
    throw std::invalid_argument(relation_name(i, j) +
                                " is between sides, of which levels must be complete");
  return hold(i, j, by);
}

Request Mesh::hold(int i, int j, const char* by) {
  build(i, j);
  Representation::Demand& demand = representation_.demand(i, j);
  demand.by.push_back(by);
  ++demand.requests;
  return Request(*this, i, j, by);
}

bool Mesh::can_hold(int i, int j) const {
  if (j == 0 || i == 2) return true;
  const Level& l = level(i);
  if (l.shapes.empty()) return told_by_sides(shape_template(l.uniform), j);
  std::array<bool, max_shapes> present{};
  for (const Shape s : l.shapes) present[static_cast<std::size_t>(s)] = true;
  for (std::size_t s = 0; s < max_shapes; ++s)
    if (present[s] && !told_by_sides(shape_template(static_cast<Shape>(s)), j)) return false;
  return true;
}

bool Mesh::defines_level(int i, int j) const {
  if (i < j || count(i) == 0) return false;
  for (int k = 0; k < i; ++k)
    if (k != j && stored(i, k) && can_hold(i, k)) return false;
  return true;
}

void Mesh::free_unwanted(int i, int j) {
  if (!stored(i, j) || representation_.demand(i, j).wanted() || defines_level(i, j)) return;
  Representation::Record& record = representation_.record(i, j);
  ++record.frees;
  record.freed_bytes = representation_.bytes(i, j);
  if (i > j)
    representation_.down(i, j).release();
  else
    representation_.up(i, j).release();
}

void Mesh::build(int i, int j) {
  if (stored(i, j)) return;
  const auto before = Clock::now();
  if (i < j)
    build_up(i, j);
  else if (j == 0)
    build_vertices(i);
  else
    build_sides(*this, i, j, representation_.down(i, j));
  note_built(i, j, milliseconds_since(before));
}

void Mesh::note_built(int i, int j, double milliseconds) {
  Representation::Record& record = representation_.record(i, j);
  ++record.builds;
  record.build_ms = milliseconds;
}

std::uint32_t Mesh::widest(int dim, int lower) const {
  int most = shape_template(level(dim).uniform).count(lower);
  for (const Shape s : level(dim).shapes) most = std::max(most, shape_template(s).count(lower));
  return static_cast<std::uint32_t>(most);
}

void Mesh::build_up(int i, int j) {
  Request sides;  // which edges or faces an entity has cannot be read off its vertices
  if (i > 0) sides = request(j, i, "building the other way");
  build_upward(*this, i, j, representation_.up(i, j));
  if (i == 0) hash_of(j).release();
}

/// Makes the mesh bare: lets go of all relations but those of higher levels to vertices, which
/// define the entities, of hash sets and of the lists of model entities; of nothing where other
/// relations define a level. For changes of large parts, which build_again() ends; for those who
/// look T stays what it was.
Mesh::Derived Mesh::release_derived() {
  Derived released;
  for (int i = 1; i < 4; ++i)
    if (representation_.has_level(i) && !stored(i, 0)) return released;
  released.bare = true;
  for (int i = 0; i < 4; ++i)
    for (int j = 1; j < 4; ++j) {
      if (i == j || !stored(i, j)) continue;
      released.relations.push_back({i, j});
      if (i > j)
        representation_.down(i, j).release();
      else
        representation_.up(i, j).release();
    }
  for (int dim = 1; dim < 4; ++dim) {
    released.hashes[static_cast<std::size_t>(dim)] = hash(dim).built();
    drop_hash(dim);
  }
  released.class_lists = class_lists_ != nullptr;
  keep_class_lists(false);
  return released;
}

void Mesh::build_again(const Derived& derived) {
  const auto& relations = derived.relations;
  // Each relation is built from T(j,0) alone, and the lists from none.
  parallel_for(relations.size() + 1, 2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k == relations.size()) {
        if (derived.class_lists) keep_class_lists(true);
      } else if (const auto [i, j] = relations[k]; i == 0) {
        build_upward(*this, 0, j, representation_.up(0, j));
      }
    }
  });
  for (const auto [i, j] : relations)
    if (i == 0) representation_.up(0, j).make_room();
  for (const auto [i, j] : relations)
    if (i > j) build_sides(*this, i, j, representation_.down(i, j));
  for (const auto [i, j] : relations) {
    if (i == 0 || i > j) continue;
    DownRows& sides = representation_.down(j, i);
    const bool lent = !sides.stored();
    if (lent) build_sides(*this, j, i, sides);
    build_upward(*this, i, j, representation_.up(i, j));
    if (lent) sides.release();
  }
  for (int dim = 1; dim < 4; ++dim)
    if (derived.hashes[static_cast<std::size_t>(dim)]) build_hash(dim);
}

void Mesh::build_vertices(int i) {
  DownRows rows;
  rows.allocate(capacity(i), widest(i, 0), false);
  VertexBuffer buffer;
  for (std::uint32_t id = 0; id < capacity(i); ++id) {
    if (!ids(i).alive(id)) continue;
    const auto v = vertices_of(EntityRef(i, id), buffer);
    std::copy(v.begin(), v.end(), rows.row(id));
  }
  representation_.down(i, 0) = std::move(rows);
}

// Where faces ask for the edges that they lack, T(2,1) is known as soon as these are.
void Mesh::complete_levels(int i, int j) {
  complete_level(i);
  if (i != 2 || j != 1 || complete(1)) return complete_level(j);
  const auto before = Clock::now();
  DownRows sides;
  complete_level(1, &sides);
  if (!sides.stored()) return;
  representation_.down(2, 1) = std::move(sides);
  note_built(2, 1, milliseconds_since(before));
}

void Mesh::complete_level(int dim, DownRows* sides_of_faces) {
  if (complete(dim)) return;
  // A history that has known higher entities would bring some back, or take some away, without
  // their sides.
  const bool only_ever_below = capacity(3) == 0 && (dim == 2 || capacity(2) == 0);
  if (journal_ && journal_->size() > 0 &&
      !(only_ever_below && journal_->cursor() == journal_->size()))
    throw std::logic_error(
        "the " + std::string(entity_name(dim)) +
        "s that this relation needs would not be part of the journal's history: request "
        "it before the first edit, or clear the journal");
  level(dim).complete = true;
  if (count(3) == 0 && (dim == 2 || count(2) == 0)) return;
  take_missing(dim, dim == 1 ? missing_edges(*this, sides_of_faces) : missing_faces(*this));
}

// The new ids are fresh, in the order given. All that an incomplete level may have stored are
// relations with the vertices, of which T(0,dim) is built again: others complete the level first.
void Mesh::take_missing(int dim, const MissingEntities& missing) {
  if (missing.shapes.empty()) return;
  const std::uint32_t first =
      level(dim).ids.create_many(static_cast<std::uint32_t>(missing.shapes.size()));
  DownRows& rows = representation_.down(dim, 0);
  if (!representation_.has_level(dim)) rows.allocate(0, static_cast<std::uint32_t>(dim + 1), false);
  hash_of(dim).release();
  grow_level(dim);
  std::copy(missing.classes.begin(), missing.classes.end(),
            level(dim).classes.begin() + static_cast<std::ptrdiff_t>(first));
  if (dim == 1) {  // of one shape, whose rows are full
    std::copy(missing.vertices.begin(), missing.vertices.end(), rows.row(first));
  } else {
    const std::uint32_t* from = missing.vertices.data();
    for (std::uint32_t k = 0; k < missing.shapes.size(); ++k) {
      set_shape(dim, first + k, missing.shapes[k]);
      const int n = shape_template(missing.shapes[k]).vertex_count;
      std::copy_n(from, n, rows.row(first + k));
      from += n;
    }
  }
  for (std::uint32_t k = 0; class_lists_ && k < missing.classes.size(); ++k)
    class_lists_->insert(dim, first + k, missing.classes[k]);
  if (stored(0, dim)) build_upward(*this, 0, dim, representation_.up(0, dim));
}

}  // namespace aomd
