#pragma once
// The mesh database: entities of four levels, the adjacencies that T(I,J) asks for, classification, and
// edits.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/class_lists.h"
#include "core/mesh/entity_hash.h"
#include "core/mesh/handle.h"
#include "core/mesh/id_pool.h"
#include "core/mesh/mesh_data.h"
#include "core/mesh/model_ref.h"
#include "core/mesh/relation.h"
#include "core/mesh/representation.h"
#include "core/mesh/shape.h"

namespace aomd {

class Journal;
class Mesh;

/// The entities of one level that are alive, in ascending order of ids. Creating or deleting entities while
/// iterating is allowed: deleted ones are skipped, those with a larger id than the present one are visited.
template <int Dim>
class EntityRange {
 public:
  struct Sentinel {};
  class Iterator {
   public:
    Iterator(const IdPool* ids, std::uint32_t at) : ids_(ids), at_(ids->next_alive(at)) {}
    Handle<Dim> operator*() const { return Handle<Dim>(at_); }
    Iterator& operator++() { return at_ = ids_->next_alive(at_ + 1), *this; }
    friend bool operator==(const Iterator& i, Sentinel) { return i.at_ >= i.ids_->capacity(); }

   private:
    const IdPool* ids_;
    std::uint32_t at_;
  };
  explicit EntityRange(const IdPool& ids) : ids_(&ids) {}
  [[nodiscard]] Iterator begin() const { return {ids_, 0}; }
  [[nodiscard]] Sentinel end() const { return {}; }

 private:
  const IdPool* ids_;
};

/// Keeps a relation stored for as long as it lives (see Mesh::request).
class Request {
 public:
  Request() = default;
  Request(Mesh& mesh, int i, int j) : mesh_(&mesh), i_(i), j_(j) {}
  Request(Request&& other) noexcept : mesh_(other.mesh_), i_(other.i_), j_(other.j_) {
    other.mesh_ = nullptr;
  }
  Request& operator=(Request&& other) noexcept;
  ~Request() { release(); }
  void release();

 private:
  Mesh* mesh_ = nullptr;
  int i_ = 0, j_ = 0;
};

/// Replaces one vertex of an edge or face by another; the entity keeps its id and classification.
struct Rebinding {
  EntityRef entity;
  std::uint32_t slot = 0;  ///< position in the entity's vertex list
  Vertex from, to;
};

/// The database. Rows and references are valid until the next edit. Movable while no request is out; not
/// copyable.
class Mesh {
 public:
  Mesh() = default;
  /// Faces held by T(2,0); edges only where the data lists some. O(size).
  explicit Mesh(const MeshData& data);
  Mesh(Mesh&&) = default;
  Mesh& operator=(Mesh&&) = default;

  // Entities ------------------------------------------------------------------------------------------------
  [[nodiscard]] std::uint32_t count(int dim) const { return level(dim).ids.size(); }
  /// One past the largest id: the size for columns.
  [[nodiscard]] std::uint32_t capacity(int dim) const { return level(dim).ids.capacity(); }
  [[nodiscard]] const IdPool& ids(int dim) const { return level(dim).ids; }
  [[nodiscard]] bool alive(EntityRef e) const { return level(e.dimension).ids.alive(e.index); }
  [[nodiscard]] EntityRange<0> vertices() const { return EntityRange<0>(ids(0)); }
  [[nodiscard]] EntityRange<1> edges() const { return EntityRange<1>(ids(1)); }
  [[nodiscard]] EntityRange<2> faces() const { return EntityRange<2>(ids(2)); }
  [[nodiscard]] Shape shape(EntityRef e) const {
    const Level& l = level(e.dimension);
    return l.shapes.empty() ? l.uniform : l.shapes[e.index];
  }
  [[nodiscard]] const glm::dvec3& position(Vertex v) const { return positions_[v.index]; }
  [[nodiscard]] ModelRef classification(EntityRef e) const { return level(e.dimension).classes[e.index]; }

  // T(I,J): which adjacencies are stored (paper, section 2) ------------------------------------------------
  [[nodiscard]] const Representation& representation() const { return representation_; }
  [[nodiscard]] bool stored(int i, int j) const { return i != j && representation_.stored(i, j); }
  /// Stores a relation from now on; built in bulk, O(entities). Creates the entities of a level that has
  /// none. Throws std::invalid_argument for the diagonal.
  void set(int i, int j);
  /// Frees a relation unless a request still holds it. Throws std::logic_error where the relation is the last
  /// downward one of a populated level, since it defines the entities; the message names another to set
  /// first.
  void unset(int i, int j);
  /// Stores a relation until the returned object dies (it stays if the user has set it too). Counted.
  [[nodiscard]] Request request(int i, int j);

  // Adjacency -----------------------------------------------------------------------------------------------
  /// The stored row of T(I,J); upward rows are sorted. No allocation, O(1). The relation must be stored.
  template <int J, int I>
  [[nodiscard]] Row<J> row(Handle<I> h) const {
    if constexpr (I > J)
      return Row<J>({representation_.down(I, J).row(h.index), static_cast<std::size_t>(lower_count(h, J))});
    else
      return Row<J>(representation_.up(I, J).row(h.index));
  }
  [[nodiscard]] std::array<Vertex, 2> edge_vertices(Edge e) const {
    const std::uint32_t* r = representation_.down(1, 0).row(e.index);
    return {Vertex(r[0]), Vertex(r[1])};
  }
  /// The end of an edge that is not `v`, one of its ends.
  [[nodiscard]] Vertex other_end(Edge e, Vertex v) const {
    const auto [a, b] = edge_vertices(e);
    return a == v ? b : a;
  }
  /// The vertices of a triangle whose T(2,0) is stored.
  [[nodiscard]] std::array<Vertex, 3> triangle(Face f) const {
    const std::uint32_t* r = representation_.down(2, 0).row(f.index);
    return {Vertex(r[0]), Vertex(r[1]), Vertex(r[2])};
  }
  /// The vertices of any entity in template order, from whichever downward relation is stored.
  [[nodiscard]] std::span<const std::uint32_t> vertices_of(
      EntityRef e, std::array<std::uint32_t, max_shape_vertices>& buffer) const;
  /// True when the face uses the edge in the edge's own direction (paper, figure 3). T(2,1) must be stored.
  [[nodiscard]] bool use_direction(Face f, Edge e) const;
  /// The edge between two vertices, or an invalid handle (paper: E_exists_). Through T(0,1) when stored,
  /// else through a hash set that is built at the first call and then kept.
  [[nodiscard]] Edge find_edge(Vertex a, Vertex b) const;
  [[nodiscard]] const EntityHash& edge_hash() const { return edge_hash_; }

  // The mesh entities of each model entity (paper, section 2.2) ---------------------------------------------
  /// Builds the lists, which every edit then keeps, or frees them. O(entities).
  void keep_class_lists(bool keep);
  /// Null unless kept.
  [[nodiscard]] const ClassLists* class_lists() const { return class_lists_.get(); }

  // Edits: all relations follow, and the journal records when one is attached ------------------------------
  Vertex create_vertex(const glm::dvec3& position, ModelRef model = {});
  Edge create_edge(Vertex a, Vertex b, ModelRef model = {});
  /// A triangle or quad. Missing edges are created with the face's classification where the level is
  /// represented.
  Face create_face(std::span<const Vertex> vertices, ModelRef model = {});
  /// Deletes an entity that no higher entity uses; its lower ones stay.
  void destroy(EntityRef e);
  /// Replaces vertices in edges and faces (edges first in the list), all at once as far as relations can see.
  void rebind(std::span<const Rebinding> items);
  void move(Vertex v, const glm::dvec3& position);
  void set_classification(EntityRef e, ModelRef model);

  [[nodiscard]] Journal* journal() const { return journal_; }
  /// Attaches a journal (or none): from now on every edit is recorded. Changes of T are not edits.
  void attach(Journal* journal) { journal_ = journal; }

  /// Bytes of entities, coordinates and classification; of relations and hash sets.
  [[nodiscard]] std::size_t entity_bytes() const;
  [[nodiscard]] std::size_t adjacency_bytes() const;

 private:
  friend class Journal;
  friend class Request;
  struct Level {
    IdPool ids;
    std::vector<ModelRef> classes;
    Shape uniform = Shape::Point;  ///< the shape of all, while `shapes` is empty
    std::vector<Shape> shapes;
  };
  [[nodiscard]] const Level& level(int dim) const { return levels_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] Level& level(int dim) { return levels_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] int lower_count(EntityRef e, int dim) const { return shape_template(shape(e)).count(dim); }

  // Building and freeing relations (mesh_relations.cpp)
  void build(int i, int j);
  void build_up(int i, int j);
  void build_face_edges();
  void build_face_vertices();
  void ensure_level(int dim);
  void create_implicit_edges();
  void free_unwanted(int i, int j);
  [[nodiscard]] bool defines_level(int i, int j) const;
  [[nodiscard]] std::uint32_t widest(int dim, int lower) const;

  // Elementary edits shared by the public ones, undo and redo (mesh_edit.cpp)
  void grow_level(int dim);
  void set_shape(int dim, std::uint32_t id, Shape shape);
  void attach_vertex(std::uint32_t id, const glm::dvec3& position, ModelRef model);
  void attach_entity(int dim, std::uint32_t id, Shape shape, std::span<const std::uint32_t> vertices,
                     ModelRef model);
  void detach_entity(int dim, std::uint32_t id);
  void apply_rebindings(std::span<const Rebinding> items);
  void rebind_edge(const Rebinding& item);
  void rebind_face(const Rebinding& item, std::span<std::uint32_t> vertices);
  void rebind_sides(const Rebinding& item, std::span<const std::uint32_t> vertices);
  void find_use_directions(std::uint32_t face, std::span<const std::uint32_t> vertices);
  void attach_sides(std::uint32_t face, std::span<const std::uint32_t> vertices);
  void detach_sides(std::uint32_t face, std::span<const std::uint32_t> vertices);
  void ensure_edges(std::span<const Vertex> vertices, ModelRef model);
  void classify(int dim, std::uint32_t id, ModelRef model);
  [[nodiscard]] std::uint64_t edge_key(std::uint32_t e) const;
  [[nodiscard]] bool used(EntityRef e) const;

  std::vector<glm::dvec3> positions_;
  std::array<Level, 4> levels_{Level{{}, {}, Shape::Point, {}}, Level{{}, {}, Shape::Line, {}},
                               Level{{}, {}, Shape::Triangle, {}}, Level{{}, {}, Shape::Tetrahedron, {}}};
  Representation representation_;
  mutable EntityHash edge_hash_;
  std::unique_ptr<ClassLists> class_lists_;
  Journal* journal_ = nullptr;
};

/// The mesh as plain arrays, ids made consecutive in ascending order; unused vertices are kept. Edges are
/// listed where they are classified on a model edge. O(size).
[[nodiscard]] MeshData to_data(const Mesh& mesh);

}  // namespace aomd
