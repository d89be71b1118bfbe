// Edits of Mesh: every stored relation follows, and the journal records.

#include <algorithm>
#include <utility>

#include "core/mesh/check.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"

namespace aomd {

void Mesh::grow_level(int dim) {
  const std::uint32_t n = capacity(dim);
  Level& l = level(dim);
  l.classes.resize(n);
  if (!l.shapes.empty()) l.shapes.resize(n, l.uniform);
  if (dim == 0) positions_.resize(n);
  for (int k = 0; k < 4; ++k) {
    if (k < dim && stored(dim, k)) representation_.down(dim, k).resize(n);
    if (k > dim && stored(dim, k)) representation_.up(dim, k).resize(n);
  }
}

void Mesh::set_shape(int dim, std::uint32_t id, Shape shape) {
  Level& l = level(dim);
  if (l.shapes.empty() && shape == l.uniform) return;
  if (l.shapes.empty()) l.shapes.assign(capacity(dim), l.uniform);
  l.shapes[id] = shape;
  for (int k = 0; k < dim; ++k)
    if (stored(dim, k))
      representation_.down(dim, k).widen(static_cast<std::uint32_t>(shape_template(shape).count(k)));
}

void Mesh::attach_vertex(std::uint32_t id, const glm::dvec3& position, ModelRef model) {
  positions_[id] = position;
  level(0).classes[id] = model;
  if (class_lists_) class_lists_->insert(0, id, model);
}

void Mesh::attach_entity(int dim, std::uint32_t id, Shape shape, std::span<const std::uint32_t> vertices,
                         ModelRef model) {
  AOMD_CHECK(dim == 1 || dim == 2);
  level(dim).classes[id] = model;
  if (class_lists_) class_lists_->insert(dim, id, model);
  set_shape(dim, id, shape);
  if (stored(dim, 0)) std::copy(vertices.begin(), vertices.end(), representation_.down(dim, 0).row(id));
  if (stored(0, dim))
    for (const std::uint32_t v : vertices) representation_.up(0, dim).insert(v, id);
  if (dim == 1 && edge_hash_.built()) edge_hash_.insert(edge_key(id), id);
  if (dim == 2) attach_sides(id, vertices);
}

void Mesh::attach_sides(std::uint32_t face, std::span<const std::uint32_t> vertices) {
  if (!stored(2, 1) && !stored(1, 2)) return;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Edge e = find_edge(Vertex(vertices[k]), Vertex(vertices[(k + 1) % vertices.size()]));
    AOMD_CHECK(e.valid());
    if (stored(2, 1)) representation_.down(2, 1).row(face)[k] = e.index;
    if (stored(1, 2)) representation_.up(1, 2).insert(e.index, face);
  }
  if (stored(2, 1)) find_use_directions(face, vertices);
}

void Mesh::find_use_directions(std::uint32_t face, std::span<const std::uint32_t> vertices) {
  DownRows& sides = representation_.down(2, 1);
  unsigned bits = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    bits |= unsigned{edge_vertices(Edge(sides.row(face)[k]))[0].index == vertices[k]} << k;
  sides.set_directions(face, static_cast<std::uint16_t>(bits));
}

void Mesh::detach_sides(std::uint32_t face, std::span<const std::uint32_t> vertices) {
  if (!stored(1, 2)) return;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const std::uint32_t e =
        stored(2, 1) ? representation_.down(2, 1).row(face)[k]
                     : find_edge(Vertex(vertices[k]), Vertex(vertices[(k + 1) % vertices.size()])).index;
    AOMD_CHECK(representation_.up(1, 2).erase(e, face));
  }
}

void Mesh::detach_entity(int dim, std::uint32_t id) {
  if (class_lists_) class_lists_->erase(dim, id, level(dim).classes[id]);
  if (dim == 0) return;
  std::array<std::uint32_t, max_shape_vertices> buffer;
  const auto vertices = vertices_of(EntityRef(dim, id), buffer);
  if (dim == 2) detach_sides(id, vertices);
  if (dim == 1 && edge_hash_.built()) edge_hash_.erase(id);
  if (stored(0, dim))
    for (const std::uint32_t v : vertices) AOMD_CHECK(representation_.up(0, dim).erase(v, id));
}

Vertex Mesh::create_vertex(const glm::dvec3& position, ModelRef model) {
  const auto [id, fresh] = level(0).ids.create();
  if (fresh) grow_level(0);
  attach_vertex(id, position, model);
  if (journal_) journal_->record_entity(true, *this, Vertex(id), fresh);
  return Vertex(id);
}

Edge Mesh::create_edge(Vertex a, Vertex b, ModelRef model) {
  AOMD_CHECK(a != b && alive(a) && alive(b) && model.may_classify(1));
  ensure_level(1);
  const auto [id, fresh] = level(1).ids.create();
  if (fresh) grow_level(1);
  const std::uint32_t ends[] = {a.index, b.index};
  attach_entity(1, id, Shape::Line, ends, model);
  if (journal_) journal_->record_entity(true, *this, Edge(id), fresh);
  return Edge(id);
}

void Mesh::ensure_edges(std::span<const Vertex> vertices, ModelRef model) {
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Vertex a = vertices[k], b = vertices[(k + 1) % vertices.size()];
    if (!find_edge(a, b).valid()) create_edge(a, b, model);
  }
}

Face Mesh::create_face(std::span<const Vertex> vertices, ModelRef model) {
  const std::size_t n = vertices.size();
  AOMD_CHECK((n == 3 || n == 4) && model.may_classify(2));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) AOMD_CHECK(alive(vertices[i]) && vertices[i] != vertices[j]);
  ensure_level(2);
  if (representation_.has_level(1)) ensure_edges(vertices, model);
  const auto [id, fresh] = level(2).ids.create();
  if (fresh) grow_level(2);
  std::array<std::uint32_t, max_shape_vertices> indices;
  for (std::size_t i = 0; i < n; ++i) indices[i] = vertices[i].index;
  attach_entity(2, id, n == 3 ? Shape::Triangle : Shape::Quad, std::span(indices).first(n), model);
  if (journal_) journal_->record_entity(true, *this, Face(id), fresh);
  return Face(id);
}

bool Mesh::used(EntityRef e) const {
  for (int j = e.dimension + 1; j < 4; ++j)
    if (stored(e.dimension, j) && !representation_.up(e.dimension, j).row(e.index).empty()) return true;
  return false;
}

void Mesh::destroy(EntityRef e) {
  AOMD_CHECK(alive(e) && !used(e));
  if (journal_) journal_->record_entity(false, *this, e, false);
  detach_entity(e.dimension, e.index);
  level(e.dimension).ids.destroy(e.index);
}

void Mesh::rebind_edge(const Rebinding& item) {
  const std::uint32_t id = item.entity.index;
  std::uint32_t* ends = representation_.down(1, 0).row(id);
  AOMD_CHECK(ends[item.slot] == item.from.index);
  if (edge_hash_.built()) edge_hash_.erase(id);
  ends[item.slot] = item.to.index;
  if (edge_hash_.built()) edge_hash_.insert(edge_key(id), id);
  if (!stored(0, 1)) return;
  representation_.up(0, 1).erase(item.from.index, id);
  representation_.up(0, 1).insert(item.to.index, id);
}

void Mesh::rebind_face(const Rebinding& item, std::span<std::uint32_t> vertices) {
  AOMD_CHECK(vertices[item.slot] == item.from.index);
  if (stored(2, 1) || stored(1, 2)) rebind_sides(item, vertices);
  vertices[item.slot] = item.to.index;
  if (stored(2, 1)) find_use_directions(item.entity.index, vertices);
  if (!stored(0, 2)) return;
  representation_.up(0, 2).erase(item.from.index, item.entity.index);
  representation_.up(0, 2).insert(item.to.index, item.entity.index);
}

// The two sides at the replaced vertex. A side whose edge was itself rebound keeps that edge: then the old
// pair of vertices is no longer found, or the new pair is found to be the same edge.
void Mesh::rebind_sides(const Rebinding& item, std::span<const std::uint32_t> vertices) {
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

void Mesh::apply_rebindings(std::span<const Rebinding> items) {
  const auto first_face =
      std::find_if(items.begin(), items.end(), [](const Rebinding& r) { return r.entity.dimension == 2; });
  if (stored(2, 0)) {
    for (auto it = items.begin(); it != first_face; ++it) rebind_edge(*it);
    for (auto it = first_face; it != items.end(); ++it) {
      const auto n = static_cast<std::size_t>(lower_count(it->entity, 0));
      rebind_face(*it, {representation_.down(2, 0).row(it->entity.index), n});
    }
    return;
  }
  // Faces known by their edges: take their vertices down before the edges change.
  struct Held {
    std::uint32_t face;
    std::array<std::uint32_t, max_shape_vertices> vertices;
    std::size_t count;
  };
  std::vector<Held> held;
  const auto find = [&](std::uint32_t face) {
    return std::find_if(held.begin(), held.end(), [&](const Held& h) { return h.face == face; });
  };
  for (auto it = first_face; it != items.end(); ++it) {
    if (find(it->entity.index) != held.end()) continue;
    Held h{it->entity.index, {}, 0};
    std::array<std::uint32_t, max_shape_vertices> buffer;
    const auto v = vertices_of(it->entity, buffer);
    std::copy(v.begin(), v.end(), h.vertices.begin());
    h.count = v.size();
    held.push_back(h);
  }
  for (auto it = items.begin(); it != first_face; ++it) rebind_edge(*it);
  for (auto it = first_face; it != items.end(); ++it) {
    Held& h = *find(it->entity.index);
    rebind_face(*it, std::span(h.vertices).first(h.count));
  }
}

void Mesh::rebind(std::span<const Rebinding> items) {
  if (items.empty()) return;
  AOMD_DEBUG_CHECK(std::is_sorted(items.begin(), items.end(), [](const Rebinding& a, const Rebinding& b) {
    return a.entity.dimension < b.entity.dimension;
  }));
  apply_rebindings(items);
  if (journal_) journal_->record_rebind(items);
}

void Mesh::move(Vertex v, const glm::dvec3& position) {
  if (journal_) journal_->record_move(v, positions_[v.index], position);
  positions_[v.index] = position;
}

void Mesh::set_classification(EntityRef e, ModelRef model) {
  AOMD_CHECK(alive(e) && model.may_classify(e.dimension));
  const ModelRef present = classification(e);
  if (present == model) return;
  if (journal_) journal_->record_classify(e, present, model);
  classify(e.dimension, e.index, model);
}

void Mesh::classify(int dim, std::uint32_t id, ModelRef model) {
  ModelRef& present = level(dim).classes[id];
  if (class_lists_) {
    class_lists_->erase(dim, id, present);
    class_lists_->insert(dim, id, model);
  }
  present = model;
}

}  // namespace aomd
