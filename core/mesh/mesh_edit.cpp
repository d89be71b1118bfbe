// Edits of Mesh: every stored relation follows, and the journal records.

#include <algorithm>
#include <utility>

#include "core/base/assertion.h"
#include "core/mesh/derive.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/names.h"
#include "core/mesh/side_index.h"

namespace aomd {
namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument(what);
}

void require_alive(const Mesh& mesh, EntityRef e) {
  if (!mesh.alive(e)) throw std::invalid_argument(name_of(e) + " does not exist");
}

void require_class(EntityRef e, ModelRef model) {
  if (model.may_classify(e.dimension)) return;
  throw std::invalid_argument(std::string("a mesh ") + entity_name(e.dimension) +
                              " cannot be on a model " + entity_name(model.dimension() & 3) +
                              ": M^I on G^J only if J >= I");
}

}  // namespace

// Elementary edits
// -------------------------------------------------------------------------------------------

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
  attached_.resize(dim, n);
}

void Mesh::ensure_level(int dim, std::size_t vertices) {
  if (!representation_.has_level(dim))
    representation_.down(dim, 0).allocate(capacity(dim), static_cast<std::uint32_t>(vertices),
                                          false);
}

void Mesh::set_shape(int dim, std::uint32_t id, Shape shape) {
  Level& l = level(dim);
  for (int k = 0; k < dim; ++k)  // rows that were built while the level was empty may be narrow
    if (stored(dim, k))
      representation_.down(dim, k).widen(
          static_cast<std::uint32_t>(shape_template(shape).count(k)));
  if (l.shapes.empty() && shape == l.uniform) return;
  if (l.shapes.empty()) l.shapes.assign(capacity(dim), l.uniform);
  l.shapes[id] = shape;
}

void Mesh::attach_vertex(std::uint32_t id, const glm::dvec3& position, ModelRef model) {
  positions_[id] = position;
  level(0).classes[id] = model;
  if (class_lists_) class_lists_->insert(0, id, model);
}

void Mesh::attach_entity(int dim, std::uint32_t id, Shape shape,
                         std::span<const std::uint32_t> vertices, ModelRef model) {
  ensure_level(dim,
               vertices.size());  // undo may fill a level again that was empty when T let go of it
  level(dim).classes[id] = model;
  if (class_lists_) class_lists_->insert(dim, id, model);
  set_shape(dim, id, shape);
  if (stored(dim, 0))
    std::copy(vertices.begin(), vertices.end(), representation_.down(dim, 0).row(id));
  if (stored(0, dim))
    for (const std::uint32_t v : vertices) representation_.up(0, dim).insert(v, id);
  if (hash_of(dim).built()) hash_of(dim).insert(EntityHash::key(vertices), id);
  for (int k = 1; k < dim; ++k) attach_sides(EntityRef(dim, id), k, vertices);
}

void Mesh::attach_sides(EntityRef e, int k, std::span<const std::uint32_t> vertices) {
  const int dim = e.dimension;
  if (!stored(dim, k) && !stored(k, dim)) return;
  const ShapeTemplate& shape = shape_template(this->shape(e));
  for (int i = 0; i < shape.count(k); ++i) {
    const std::uint32_t side = find(k, SideVertices(shape.sub(k, i), vertices.data()).span());
    AOMD_CHECK(side != no_index);
    if (stored(dim, k)) representation_.down(dim, k).row(e.index)[i] = side;
    if (stored(k, dim)) representation_.up(k, dim).insert(side, e.index);
  }
  if (k == dim - 1 && stored(dim, k)) find_use_directions(e, vertices);
}

// A side is used in its own direction when its first two vertices, in its own order, follow each
// other the same way in the template's.
void Mesh::find_use_directions(EntityRef e, std::span<const std::uint32_t> vertices) {
  const int k = e.dimension - 1;
  DownRows& sides = representation_.down(e.dimension, k);
  const ShapeTemplate& shape = shape_template(this->shape(e));
  unsigned bits = 0;
  for (int i = 0; i < shape.count(k); ++i) {
    const SideVertices side(shape.sub(k, i), vertices.data());
    VertexBuffer buffer;
    const auto own = vertices_of(EntityRef(k, sides.row(e.index)[i]), buffer);
    const auto at = static_cast<std::size_t>(
        std::find(side.ids.begin(), side.ids.begin() + side.count, own[0]) - side.ids.begin());
    const bool along = k == 1 ? at == 0 : side.ids[(at + 1) % side.count] == own[1];
    bits |= unsigned{along} << i;
  }
  sides.set_directions(e.index, static_cast<std::uint16_t>(bits));
}

void Mesh::detach_sides(EntityRef e, int k, std::span<const std::uint32_t> vertices) {
  if (!stored(k, e.dimension)) return;
  for (int i = 0; i < lower_count(e, k); ++i)
    AOMD_CHECK(representation_.up(k, e.dimension).erase(side_of(e, k, i, vertices), e.index));
}

void Mesh::detach_entity(int dim, std::uint32_t id) {
  if (class_lists_) class_lists_->erase(dim, id, level(dim).classes[id]);
  if (dim == 0) return;
  VertexBuffer buffer;
  const EntityRef e(dim, id);
  const auto vertices = vertices_of(e, buffer);
  for (int k = 1; k < dim; ++k) detach_sides(e, k, vertices);
  if (hash_of(dim).built()) hash_of(dim).erase(id);
  if (stored(0, dim))
    for (const std::uint32_t v : vertices) AOMD_CHECK(representation_.up(0, dim).erase(v, id));
}

void Mesh::note_created(EntityRef e, bool fresh) {
  ++revision_;
  std::size_t& creations = recorded_creations_[e.dimension];
  if (!journal_) return attached_.created(e.dimension, e.index);
  attached_.cover(e.dimension, e.index, creations++);
  journal_->record_entity(true, *this, e, fresh);
}

// Creation
// ------------------------------------------------------------------------------------------------

Vertex Mesh::create_vertex(const glm::dvec3& position, ModelRef model) {
  require_class(Vertex(), model);
  const auto [id, fresh] = level(0).ids.create();
  if (fresh) grow_level(0);
  attach_vertex(id, position, model);
  note_created(Vertex(id), fresh);
  return Vertex(id);
}

void Mesh::check_new(int dim, Shape shape, std::span<const std::uint32_t> vertices,
                     ModelRef model) const {
  require_class(EntityRef(dim, no_index), model);
  require(static_cast<std::size_t>(shape) < shape_count() &&
              shape_template(shape).dimension == dim &&
              shape_template(shape).vertex_count == static_cast<int>(vertices.size()),
          std::string("a ") + entity_name(dim) + " cannot be made from " +
              std::to_string(vertices.size()) + " vertices in this shape");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    require(alive(Vertex(vertices[i])), name_of(Vertex(vertices[i])) + " does not exist");
    require(std::find(vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1, vertices.end(),
                      vertices[i]) == vertices.end(),
            name_of(Vertex(vertices[i])) + " is used twice");
  }
}

void Mesh::ensure_sides(int dim, Shape shape, std::span<const std::uint32_t> vertices,
                        ModelRef model) {
  for (int k = 1; k < dim; ++k) {
    if (!complete(k)) continue;
    for (int i = 0; i < shape_template(shape).count(k); ++i) {
      const SubEntity& sub = shape_template(shape).sub(k, i);
      const SideVertices side(sub, vertices.data());
      if (find(k, side.span()) == no_index) create_entity(k, sub.shape, side.span(), model);
    }
  }
}

std::uint32_t Mesh::create_entity(int dim, Shape shape, std::span<const std::uint32_t> vertices,
                                  ModelRef model) {
  ensure_level(dim, vertices.size());
  if (dim == 3 && !stored(3, 0) &&
      !((stored(3, 2) && told_by_sides(shape_template(shape), 2)) ||
        (stored(3, 1) && told_by_sides(shape_template(shape), 1))))
    build_vertices(3);
  ensure_sides(dim, shape, vertices, model);
  const auto [id, fresh] = level(dim).ids.create();
  if (fresh) grow_level(dim);
  attach_entity(dim, id, shape, vertices, model);
  note_created(EntityRef(dim, id), fresh);
  return id;
}

Edge Mesh::create_edge(Vertex a, Vertex b, ModelRef model) {
  const std::uint32_t ends[] = {a.index, b.index};
  check_new(1, Shape::Line, ends, model);
  if (const Edge known = find_edge(a, b); known.valid())
    throw std::invalid_argument(name_of(known) + " joins these vertices already");
  return Edge(create_entity(1, Shape::Line, ends, model));
}

Face Mesh::create_face(std::span<const Vertex> vertices, ModelRef model) {
  VertexBuffer buffer;
  require(vertices.size() <= buffer.size(), "too many vertices for a face");
  for (std::size_t k = 0; k < vertices.size(); ++k) buffer[k] = vertices[k].index;
  const std::span ids(std::as_const(buffer).data(), vertices.size());
  const Shape shape = face_shape(ids.size());
  check_new(2, shape, ids, model);
  if (const Face known = count(3) > 0 ? find_face(vertices) : Face(); known.valid())
    throw std::invalid_argument(name_of(known) +
                                " has these vertices already, and regions could use only one");
  return Face(create_entity(2, shape, ids, model));
}

Face Mesh::create_face(std::span<const Edge> edges, ModelRef model) {
  std::array<Vertex, max_shape_vertices> vertices;
  const std::size_t n = edges.size();
  require(n >= 3 && n <= vertices.size(), "a face has three edges or more");
  for (const Edge e : edges) require_alive(*this, e);
  for (std::size_t k = 0; k < n; ++k) {
    const auto [a, b] = edge_vertices(edges[k]);
    const auto before = edge_vertices(edges[(k + n - 1) % n]);
    const bool first = a == before[0] || a == before[1], second = b == before[0] || b == before[1];
    require(first != second,
            name_of(edges[k]) + " does not follow " + name_of(edges[(k + n - 1) % n]));
    vertices[k] = first ? a : b;
  }
  return create_face(std::span<const Vertex>(vertices.data(), n), model);
}

Region Mesh::create_region(Shape shape, std::span<const Vertex> vertices, ModelRef model) {
  VertexBuffer buffer;
  require(vertices.size() <= buffer.size(), "too many vertices for a region");
  for (std::size_t k = 0; k < vertices.size(); ++k) buffer[k] = vertices[k].index;
  const std::span ids(std::as_const(buffer).data(), vertices.size());
  check_new(3, shape, ids, model);
  return Region(create_entity(3, shape, ids, model));
}

Region Mesh::create_region_of(Shape shape, int k, std::span<const std::uint32_t> sides,
                              ModelRef model) {
  for (const std::uint32_t s : sides) require_alive(*this, EntityRef(k, s));
  VertexBuffer buffer;
  require(static_cast<std::size_t>(shape) < shape_count() &&
              shape_template(shape).count(k) == static_cast<int>(sides.size()) &&
              corners_from_sides(shape, k, sides.data(), buffer),
          std::string("these ") + entity_plural(k) + " do not form a region of this shape");
  const std::span ids(std::as_const(buffer).data(),
                      static_cast<std::size_t>(shape_template(shape).vertex_count));
  check_new(3, shape, ids, model);
  return Region(create_entity(3, shape, ids, model));
}

Region Mesh::create_region(Shape shape, std::span<const Edge> edges, ModelRef model) {
  std::vector<std::uint32_t> ids;
  for (const Edge e : edges) ids.push_back(e.index);
  return create_region_of(shape, 1, ids, model);
}

Region Mesh::create_region(Shape shape, std::span<const Face> faces, ModelRef model) {
  std::vector<std::uint32_t> ids;
  for (const Face f : faces) ids.push_back(f.index);
  return create_region_of(shape, 2, ids, model);
}

// Deletion
// ------------------------------------------------------------------------------------------------

std::vector<EntityRef> Mesh::users(EntityRef e) const {
  std::vector<EntityRef> result;
  VertexBuffer buffer;
  const auto own = vertices_of(e, buffer);
  for (int j = e.dimension + 1; j < 4; ++j) {
    std::vector<std::uint32_t> found;
    if (count(j) == 0) continue;
    if (explain(*this, e.dimension, j).kind != AdjacencyPath::Kind::None)
      adjacent(*this, e, j, found);
    else
      for (std::uint32_t id = 0; id < capacity(j); ++id)
        if (ids(j).alive(id) && has_side(*this, EntityRef(j, id), e.dimension, own))
          found.push_back(id);
    for (const std::uint32_t id : found) result.emplace_back(j, id);
  }
  return result;
}

void Mesh::destroy(EntityRef e) {
  require_alive(*this, e);
  if (const auto by = users(e); !by.empty()) {
    std::string text = name_of(e) + " is used by ";
    for (std::size_t k = 0; k < by.size() && k < 6; ++k) text += (k ? ", " : "") + name_of(by[k]);
    if (by.size() > 6) text += " and " + std::to_string(by.size() - 6) + " more";
    throw std::logic_error(text + ": delete them first, or with it");
  }
  destroy_unused(e);
}

void Mesh::destroy_unused(EntityRef e) {
  AOMD_CHECK(alive(e));
  for (int j = e.dimension + 1; j < 4; ++j)
    AOMD_CHECK(!stored(e.dimension, j) || representation_.up(e.dimension, j).row(e.index).empty());
  if (journal_) journal_->record_entity(false, *this, e, false);
  ++revision_;
  detach_entity(e.dimension, e.index);
  level(e.dimension).ids.destroy(e.index);
}

void Mesh::destroy_with_users(EntityRef e) {
  require_alive(*this, e);
  const auto by = users(e);
  for (auto it = by.rbegin(); it != by.rend(); ++it) destroy_unused(*it);
  destroy_unused(e);
}

// Other edits
// ------------------------------------------------------------------------------------------------

void Mesh::move(Vertex v, const glm::dvec3& position) {
  if (journal_) journal_->record_move(v, positions_[v.index], position);
  ++revision_;
  positions_[v.index] = position;
}

void Mesh::edit_classification(EntityRef e, ModelRef model) {
  require_alive(*this, e);
  require_class(e, model);
  const ModelRef present = classification(e);
  if (present == model) return;
  if (journal_) journal_->record_classify(e, present, model);
  ++revision_;
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
