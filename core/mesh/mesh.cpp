#include "core/mesh/mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/assertion.h"
#include "core/mesh/journal.h"

namespace aomd {

Mesh& Mesh::operator=(Mesh&& other) noexcept {
  Mesh taken(std::move(other));
  swap(taken);
  return *this;
}

void Mesh::swap(Mesh& other) noexcept {
  std::swap(positions_, other.positions_);
  std::swap(levels_, other.levels_);
  std::swap(representation_, other.representation_);
  std::swap(hashes_, other.hashes_);
  std::swap(class_lists_, other.class_lists_);
  std::swap(attached_, other.attached_);
  std::swap(recorded_creations_, other.recorded_creations_);
  std::swap(model_table_, other.model_table_);
  std::swap(journal_, other.journal_);
}

int Mesh::dimension() const {
  int dim = 3;
  while (dim > 0 && count(dim) == 0) --dim;
  return dim;
}

std::span<const std::uint32_t> Mesh::vertices_of(EntityRef e, VertexBuffer& buffer) const {
  if (e.dimension == 0) {
    buffer[0] = e.index;
    return {buffer.data(), 1};
  }
  const auto n = static_cast<std::size_t>(lower_count(e, 0));
  const DownRows& direct = representation_.down(e.dimension, 0);
  if (direct.stored()) return {direct.row(e.index), n};
  if (e.dimension == 2) {
    const DownRows& sides = representation_.down(2, 1);
    for (std::size_t k = 0; k < n; ++k) {
      const auto ends = edge_vertices(Edge(sides.row(e.index)[k]));
      buffer[k] = ends[(sides.directions(e.index) >> k & 1u) ? 0 : 1].index;
    }
  } else {
    const auto told = [&](int k) {
      return stored(3, k) && told_by_sides(shape_template(shape(e)), k) &&
             corners_from_sides(shape(e), k, representation_.down(3, k).row(e.index), buffer);
    };
    AOMD_CHECK(told(2) || told(1));
  }
  return {buffer.data(), n};
}

// Each vertex is told by the set of sides on which it lies, which is different for each in every
// shape that may be held this way (can_hold).
bool Mesh::corners_from_sides(Shape whole, int k, const std::uint32_t* sides,
                              VertexBuffer& buffer) const {
  const ShapeTemplate& shape = shape_template(whole);
  VertexBuffer found;
  std::array<std::uint32_t, max_shape_vertices> masks{};
  int count = 0;
  for (int i = 0; i < shape.count(k); ++i) {
    VertexBuffer side_buffer;
    for (const std::uint32_t v : vertices_of(EntityRef(k, sides[i]), side_buffer)) {
      const auto at = std::find(found.begin(), found.begin() + count, v) - found.begin();
      if (at == count && count++ == shape.vertex_count) return false;
      found[static_cast<std::size_t>(at)] = v;
      masks[static_cast<std::size_t>(at)] |= 1u << i;
    }
  }
  const auto expected = side_masks(shape, k);
  for (int v = 0; v < shape.vertex_count; ++v) {
    const auto at =
        std::find(masks.begin(), masks.begin() + count, expected[static_cast<std::size_t>(v)]) -
        masks.begin();
    if (at == count) return false;
    buffer[static_cast<std::size_t>(v)] = found[static_cast<std::size_t>(at)];
  }
  return count == shape.vertex_count;
}

bool Mesh::use_direction(Face f, Edge e) const {
  const Row<1> sides = row<1>(f);
  const auto k =
      std::find(sides.indices().begin(), sides.indices().end(), e.index) - sides.indices().begin();
  AOMD_CHECK(static_cast<std::size_t>(k) < sides.size());
  return (representation_.down(2, 1).directions(f.index) >> k & 1u) != 0;
}

bool Mesh::use_direction(Region r, Face f) const {
  const Row<2> sides = row<2>(r);
  const auto k =
      std::find(sides.indices().begin(), sides.indices().end(), f.index) - sides.indices().begin();
  AOMD_CHECK(static_cast<std::size_t>(k) < sides.size());
  return (representation_.down(3, 2).directions(r.index) >> k & 1u) != 0;
}

void Mesh::keep_class_lists(bool keep) {
  class_lists_.reset();
  if (!keep) return;
  class_lists_ = std::make_unique<ClassLists>();
  for (int dim = 0; dim < 4; ++dim) class_lists_->insert_all(dim, ids(dim), level(dim).classes);
}

void Mesh::attach(Journal* journal) {
  journal_ = journal;
  recorded_creations_ = journal ? journal->applied_creations() : std::array<std::size_t, 4>{};
  for (int dim = 0; dim < 4; ++dim)
    attached_.start_after(dim, recorded_creations_[static_cast<std::size_t>(dim)]);
}

std::size_t Mesh::entity_bytes() const {
  std::size_t sum = positions_.capacity() * sizeof(glm::dvec3) +
                    (class_lists_ ? class_lists_->bytes() : 0) + attached_.bytes();
  for (const Level& l : levels_)
    sum += l.ids.bytes() + l.classes.capacity() * sizeof(ModelRef) +
           l.shapes.capacity() * sizeof(Shape);
  return sum;
}

std::size_t Mesh::adjacency_bytes() const {
  std::size_t sum = 0;
  for (const EntityHash& hash : hashes_) sum += hash.bytes();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (stored(i, j)) sum += representation_.bytes(i, j);
  return sum;
}

}  // namespace aomd
