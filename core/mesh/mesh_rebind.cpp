// Rebinding: entities stretch to another vertex and keep their identity (the inner loop of a
// collapse).

#include <algorithm>
#include <utility>

#include "core/base/assertion.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"

namespace aomd {
namespace {

using Items = std::span<const Rebinding>;

// What an entity held before anything changed, for those whose vertices are known through others.
struct Held {
  std::uint32_t id;
  VertexBuffer vertices;
  std::size_t count;

  Held(const Mesh& mesh, EntityRef e) : id(e.index) {
    VertexBuffer buffer;
    const auto v = mesh.vertices_of(e, buffer);
    std::copy(v.begin(), v.end(), vertices.begin());
    count = v.size();
  }
  [[nodiscard]] std::span<std::uint32_t> span() { return {vertices.data(), count}; }
};

Held& held_of(std::vector<Held>& held, std::uint32_t id) {
  return *std::find_if(held.begin(), held.end(), [&](const Held& h) { return h.id == id; });
}

std::vector<Held> hold_all(const Mesh& mesh, Items items) {
  std::vector<Held> held;
  for (const Rebinding& r : items)
    if (std::none_of(held.begin(), held.end(),
                     [&](const Held& h) { return h.id == r.entity.index; }))
      held.emplace_back(mesh, r.entity);
  return held;
}

// They come in the order of their dimensions.
struct ByDimension {
  Items edges, faces, regions;

  explicit ByDimension(Items items) {
    const auto first_of = [items](int dim) {
      return std::partition_point(items.begin(), items.end(),
                                  [dim](const Rebinding& r) { return r.entity.dimension < dim; });
    };
    const auto face = first_of(2), region = first_of(3);
    edges = {items.begin(), face}, faces = {face, region}, regions = {region, items.end()};
  }
};

}  // namespace

void Mesh::replace_in_row(const Rebinding& item) {
  const int dim = item.entity.dimension;
  if (!stored(0, dim)) return;
  representation_.up(0, dim).erase(item.from.index, item.entity.index);
  representation_.up(0, dim).insert(item.to.index, item.entity.index);
}

void Mesh::rebind_edge(const Rebinding& item) {
  const std::uint32_t id = item.entity.index;
  std::uint32_t* ends = representation_.down(1, 0).row(id);
  AOMD_CHECK(ends[item.slot] == item.from.index);
  if (hash_of(1).built()) hash_of(1).erase(id);
  ends[item.slot] = item.to.index;
  if (hash_of(1).built()) hash_of(1).insert(EntityHash::key({ends, 2}), id);
  replace_in_row(item);
}

void Mesh::rebind_face(const Rebinding& item, std::span<std::uint32_t> vertices) {
  AOMD_CHECK(vertices[item.slot] == item.from.index);
  if (stored(2, 1) || stored(1, 2)) rebind_face_sides(item, vertices);
  if (hash_of(2).built()) hash_of(2).erase(item.entity.index);
  vertices[item.slot] = item.to.index;
  if (hash_of(2).built()) hash_of(2).insert(EntityHash::key(vertices), item.entity.index);
  if (stored(2, 1)) find_use_directions(item.entity, vertices);
  replace_in_row(item);
}

// The two sides at the replaced vertex. A side whose edge was itself rebound keeps that edge: then
// the old pair of vertices is no longer found, or the new pair is found to be the same edge.
void Mesh::rebind_face_sides(const Rebinding& item, std::span<const std::uint32_t> vertices) {
  const auto n = static_cast<std::uint32_t>(vertices.size());
  const std::uint32_t slots[] = {(item.slot + n - 1) % n, item.slot};
  const std::uint32_t others[] = {vertices[(item.slot + n - 1) % n], vertices[(item.slot + 1) % n]};
  const std::uint32_t face = item.entity.index;
  Edge before[2], after[2];
  for (std::size_t s = 0; s < 2; ++s) {
    before[s] = stored(2, 1) ? Edge(representation_.down(2, 1).row(face)[slots[s]])
                             : find_edge(item.from, Vertex(others[s]));
    after[s] = find_edge(item.to, Vertex(others[s]));
    if (!after[s].valid()) after[s] = before[s];
    if (stored(2, 1)) representation_.down(2, 1).row(face)[slots[s]] = after[s].index;
  }
  if (!stored(1, 2)) return;
  UpRows& faces_of = representation_.up(1, 2);
  for (const Edge e : before)
    if (e.valid()) faces_of.erase(e.index, face);
  for (const Edge e : after)
    if (e.valid() && !faces_of.contains(e.index, face)) faces_of.insert(e.index, face);
}

void Mesh::rebind_faces(Items items) {
  for (const Rebinding& item : items) {
    const auto n = static_cast<std::size_t>(lower_count(item.entity, 0));
    rebind_face(item, {representation_.down(2, 0).row(item.entity.index), n});
  }
}

// Regions that are known by their vertices alone, as while a volume is decimated: nothing is held.
void Mesh::rebind_bare_regions(Items items) {
  for (const Rebinding& item : items) {
    std::uint32_t& vertex = representation_.down(3, 0).row(item.entity.index)[item.slot];
    AOMD_CHECK(vertex == item.from.index);
    vertex = item.to.index;
    replace_in_row(item);
  }
}

bool Mesh::regions_are_bare() const {
  const bool sides = stored(3, 1) || stored(3, 2) || stored(1, 3) || stored(2, 3);
  return stored(3, 0) && !sides && !hash(3).built();
}

// Regions let go of their sides before these change, and look them up again afterwards.
void Mesh::apply_rebindings(Items items) {
  const auto [edges, faces, regions] = ByDimension(items);
  const bool bare = regions_are_bare();
  std::vector<Held> held_faces, held_regions = hold_all(*this, bare ? Items() : regions);
  if (!stored(2, 0)) held_faces = hold_all(*this, faces);
  for (Held& h : held_regions) {
    for (int k = 1; k < 3; ++k) detach_sides(Region(h.id), k, h.span());
    if (hash_of(3).built()) hash_of(3).erase(h.id);
  }
  for (const Rebinding& item : edges) rebind_edge(item);
  if (stored(2, 0)) rebind_faces(faces);
  for (const Rebinding& item : held_faces.empty() ? Items() : faces)
    rebind_face(item, held_of(held_faces, item.entity.index).span());
  if (bare) return rebind_bare_regions(regions);
  for (const Rebinding& item : regions) {
    std::uint32_t& vertex = held_of(held_regions, item.entity.index).vertices[item.slot];
    AOMD_CHECK(vertex == item.from.index);
    vertex = item.to.index;
    replace_in_row(item);
  }
  for (Held& h : held_regions) {
    if (stored(3, 0))
      std::copy_n(h.vertices.begin(), h.count, representation_.down(3, 0).row(h.id));
    if (hash_of(3).built()) hash_of(3).insert(EntityHash::key(h.span()), h.id);
    for (int k = 1; k < 3; ++k) attach_sides(Region(h.id), k, h.span());
  }
}

void Mesh::rebind(Items items) {
  if (items.empty()) return;
  AOMD_DEBUG_CHECK(
      std::is_sorted(items.begin(), items.end(), [](const Rebinding& a, const Rebinding& b) {
        return a.entity.dimension < b.entity.dimension;
      }));
  ++revision_;
  apply_rebindings(items);
  if (journal_) journal_->record_rebind(items);
}

}  // namespace aomd
