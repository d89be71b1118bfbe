#pragma once
// The mesh database: entities of four levels, the adjacencies that T(I,J) asks for, classification,
// attached data, and edits.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/attached.h"
#include "core/mesh/class_lists.h"
#include "core/mesh/entity_hash.h"
#include "core/mesh/entity_range.h"
#include "core/mesh/handle.h"
#include "core/mesh/id_pool.h"
#include "core/mesh/mesh_data.h"
#include "core/mesh/model_ref.h"
#include "core/mesh/relation.h"
#include "core/mesh/representation.h"
#include "core/mesh/request.h"
#include "core/mesh/shape.h"

#pragma GCC visibility push(default)

namespace aomd {

class Journal;
struct MissingEntities;

/// Replaces one vertex of an edge, face or region by another; the entity keeps its id and
/// classification.
struct Rebinding {
  EntityRef entity;
  std::uint32_t slot = 0;  ///< position in the entity's vertex list
  Vertex from, to;
};

/// Vertices of one entity, on the stack.
using VertexBuffer = std::array<std::uint32_t, max_shape_vertices>;

/// The database. Rows and references are valid until the next edit. Not copyable; movable while no
/// request is out, and a mesh that was moved from is empty. Several threads may read at once while
/// none edits; existence queries only after build_hash() or with stored adjacency, since they may
/// build a hash set.
class Mesh {
 public:
  Mesh() = default;
  /// Holds what the data lists and no more: regions by T(3,0), faces by T(2,0), edges by T(1,0).
  /// O(size). Attributes of one or three components become attached data. Throws
  /// std::invalid_argument for indices out of range, lists that do not fit each other, and
  /// classifications that break the rule.
  explicit Mesh(const MeshData& data);
  Mesh(Mesh&& other) noexcept { swap(other); }
  Mesh& operator=(Mesh&& other) noexcept;
  void swap(Mesh& other) noexcept;

  // Entities
  // ----------------------------------------------------------------------------------------------
  [[nodiscard]] std::uint32_t count(int dim) const { return level(dim).ids.size(); }
  /// One past the largest id: the size for columns.
  [[nodiscard]] std::uint32_t capacity(int dim) const { return level(dim).ids.capacity(); }
  [[nodiscard]] const IdPool& ids(int dim) const { return level(dim).ids; }
  [[nodiscard]] bool alive(EntityRef e) const { return level(e.dimension).ids.alive(e.index); }
  [[nodiscard]] EntityRange<0> vertices() const { return EntityRange<0>(ids(0)); }
  [[nodiscard]] EntityRange<1> edges() const { return EntityRange<1>(ids(1)); }
  [[nodiscard]] EntityRange<2> faces() const { return EntityRange<2>(ids(2)); }
  [[nodiscard]] EntityRange<3> regions() const { return EntityRange<3>(ids(3)); }
  /// The highest level with entities.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] Shape shape(EntityRef e) const {
    const Level& l = level(e.dimension);
    return l.shapes.empty() ? l.uniform : l.shapes[e.index];
  }
  /// The template of all entities of a level, or null where their shapes may differ.
  [[nodiscard]] const ShapeTemplate* uniform_shape(int dim) const {
    return level(dim).shapes.empty() ? &shape_template(level(dim).uniform) : nullptr;
  }
  [[nodiscard]] const glm::dvec3& position(Vertex v) const { return positions_[v.index]; }
  [[nodiscard]] ModelRef classification(EntityRef e) const {
    return level(e.dimension).classes[e.index];
  }
  /// What the file told about the model.
  [[nodiscard]] const ModelTable& model_table() const { return model_table_; }

  // T(I,J): which adjacencies are stored (paper, section 2; mesh_relations.cpp)
  // ------------------------------
  [[nodiscard]] const Representation& representation() const { return representation_; }
  [[nodiscard]] bool stored(int i, int j) const { return i != j && representation_.stored(i, j); }
  /// True when every side of every higher entity is an entity of this level, as each relation that
  /// was ever asked for needs it; a level that only holds what a file lists is not complete. Once
  /// complete, a level stays so: creating an entity creates its sides.
  [[nodiscard]] bool complete(int dim) const { return level(dim).complete; }
  /// Stores a relation from now on; built in bulk, O(entities). Completes both levels: missing
  /// entities take the classification of the first entity whose side they are (faces before
  /// regions, smallest id first). Throws std::invalid_argument for the diagonal, std::logic_error
  /// when a level would have to be completed while the attached journal holds a history, which the
  /// new entities would not be part of.
  void set(int i, int j);
  /// Frees a relation unless a request still holds it. Throws std::logic_error where the relation
  /// is the last downward one of a populated level, since it defines the entities; the message
  /// names another to set first.
  void unset(int i, int j);
  /// Stores a relation until the returned object dies (it stays if the user has set it too).
  /// Counted. `by` names who asks, for those who look (Representation::Demand), and must outlive
  /// the mesh. Throws as set() does.
  [[nodiscard]] Request request(int i, int j, const char* by = "an algorithm");
  /// A request for a relation of the entities that both levels hold now: nothing is completed, so
  /// that T(0,2) of a volume has its model faces only. Where a level is completed later, the
  /// relation grows with it. Throws std::invalid_argument unless one of I and J is 0.
  [[nodiscard]] Request request_listed(int i, int j, const char* by = "an algorithm");

  // Adjacency; relations that are not stored: core/mesh/derive.h
  // --------------------------------------------
  /// The stored row of T(I,J): downward rows in the order of the template, upward rows sorted. No
  /// allocation, O(1). The relation must be stored.
  template <int J, int I>
  [[nodiscard]] Row<J> row(Handle<I> h) const {
    if constexpr (I > J)
      return Row<J>(
          {representation_.down(I, J).row(h.index), static_cast<std::size_t>(lower_count(h, J))});
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
  /// The vertices of a tetrahedron whose T(3,0) is stored.
  [[nodiscard]] std::array<Vertex, 4> tetrahedron(Region r) const {
    const std::uint32_t* v = representation_.down(3, 0).row(r.index);
    return {Vertex(v[0]), Vertex(v[1]), Vertex(v[2]), Vertex(v[3])};
  }
  /// The vertices of any entity in template order, from whichever downward relation is stored.
  [[nodiscard]] std::span<const std::uint32_t> vertices_of(EntityRef e, VertexBuffer& buffer) const;
  /// True when the face uses the edge, or the region the face, in its own direction (paper, figure
  /// 3): the region's template lists the face's vertices in the face's order. T(2,1) or T(3,2) must
  /// be stored.
  [[nodiscard]] bool use_direction(Face f, Edge e) const;
  [[nodiscard]] bool use_direction(Region r, Face f) const;

  // Existence (paper, section 2.1.1; mesh_find.cpp)
  // ---------------------------------------------------------
  /// The entity on just these vertices, in any order, or an invalid handle; the one with the
  /// smallest id where a file brings several. Through upward adjacency of a vertex when it is
  /// stored, else through a hash set that is built at the first call and kept until the adjacency
  /// is stored or drop_hash is called.
  [[nodiscard]] Edge find_edge(Vertex a, Vertex b) const;
  [[nodiscard]] Face find_face(std::span<const Vertex> vertices) const;
  [[nodiscard]] Region find_region(std::span<const Vertex> vertices) const;
  /// The hash set of level 1, 2 or 3; may not be built.
  [[nodiscard]] const EntityHash& hash(int dim) const {
    return hashes_[static_cast<std::size_t>(dim)];
  }
  /// Builds it now if it is not: what several threads need before they ask at once. It starts with
  /// about so many buckets (0: one for each entity) and grows as it must. O(entities).
  void build_hash(int dim, std::uint32_t buckets = 0) const;
  void drop_hash(int dim) { hashes_[static_cast<std::size_t>(dim)].release(); }

  // The mesh entities of each model entity (paper, section 2.2)
  // ---------------------------------------------
  /// Builds the lists, which every edit then keeps, or frees them. O(entities).
  void keep_class_lists(bool keep);
  /// Null unless kept.
  [[nodiscard]] const ClassLists* class_lists() const { return class_lists_.get(); }

  // Attached data
  // -------------------------------------------------------------------------------------------
  /// The data of this name, made when there is none: one T for every entity of the kind,
  /// `initial` for those created later. Follows creation, deletion, undo, redo and compact().
  /// Throws std::invalid_argument when the name is taken by another type.
  template <typename H, typename T>
  Attached<H, T>& attached(std::string_view name, T initial = {});
  /// The data of this name, or null.
  template <typename H, typename T>
  [[nodiscard]] Attached<H, T>* find_attached(std::string_view name) const;
  bool drop_attached(int dim, std::string_view name) { return attached_.drop(dim, name); }
  [[nodiscard]] const AttachedData::List& attached(int dim) const { return attached_.columns(dim); }

  // Edits: all relations follow, and the journal records when one is attached (mesh_edit.cpp)
  // ---------------
  /// Edges, faces and regions from their vertices, edges or faces in template order (edges of a
  /// face: one after the other around it). Sides that a complete level lacks are created with the
  /// entity's classification. All throw std::invalid_argument when what is given does not form the
  /// shape or is not alive, when the classification breaks the rule M^I on G^J only if J >= I, and
  /// for a second edge on the same vertices, or a second face where there are regions.
  Vertex create_vertex(const glm::dvec3& position, ModelRef model = {});
  Edge create_edge(Vertex a, Vertex b, ModelRef model = {});
  Face create_face(std::span<const Vertex> vertices, ModelRef model = {});
  Face create_face(std::span<const Edge> edges, ModelRef model = {});
  Region create_region(Shape shape, std::span<const Vertex> vertices, ModelRef model = {});
  Region create_region(Shape shape, std::span<const Edge> edges, ModelRef model = {});
  Region create_region(Shape shape, std::span<const Face> faces, ModelRef model = {});
  /// The higher entities that use an entity, by level and id. Read from T where it stores the
  /// upward relation or a path leads there, otherwise found by going through the higher level,
  /// O(its size).
  [[nodiscard]] std::vector<EntityRef> users(EntityRef e) const;
  /// Deletes an entity; its lower ones stay. Throws std::logic_error naming the users where there
  /// are any. Cost as users().
  void destroy(EntityRef e);
  /// Deletes an entity for an operator that knows that nothing uses it: only stored relations are
  /// asked, and an answer against it is a programming error. O(row).
  void destroy_unused(EntityRef e);
  /// Deletes an entity and everything that uses it, highest first.
  void destroy_with_users(EntityRef e);
  /// Replaces vertices in edges, faces and regions (in this order), all at once as far as relations
  /// can see.
  void rebind(std::span<const Rebinding> items);
  void move(Vertex v, const glm::dvec3& position);
  /// Throws std::invalid_argument where the rule is broken.
  void set_classification(EntityRef e, ModelRef model) {
    if (journal_ || class_lists_ || !alive(e) || !model.may_classify(e.dimension))
      return edit_classification(e, model);
    ModelRef& present = level(e.dimension).classes[e.index];
    revision_ += present != model;
    present = model;
  }

  /// Another number after every edit, undo and redo included: what was judged at one number holds
  /// while the mesh has it.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  [[nodiscard]] Journal* journal() const { return journal_; }
  /// Attaches a journal (or none): from now on every edit is recorded. Changes of T are not edits.
  /// What the journal holds already must lead to this mesh; attached values that its creations
  /// covered are forgotten. O(records of the journal).
  void attach(Journal* journal);
  /// The opposite of completing level 1: lets go of every edge that lies on a model face or region,
  /// or is unclassified and a side of something, and of T(0,1), T(1,2), T(2,1), T(1,3), T(3,1).
  /// What is left are the edges on model edges and those that nothing else implies; the others come
  /// back when T asks for them. Ids of edges become consecutive. O(edges). Throws std::logic_error
  /// while a journal is attached or an algorithm has requested one of these.
  void keep_model_edges_only() { keep_model_entities_only(1); }
  /// The opposite of completing level 2: what is left are the faces on model faces, edges or
  /// vertices and those that nothing implies. T(0,2), T(1,2), T(2,1), T(2,3) and T(3,2) go.
  /// O(faces). Throws as keep_model_edges_only() does.
  void keep_model_faces_only() { keep_model_entities_only(2); }
  /// Makes ids consecutive in each level, in ascending order, and frees what deleted entities still
  /// occupy. Returns the new id of each old one by level (no_index where deleted). O(size). Throws
  /// std::logic_error while a journal is attached: its records name ids.
  std::array<std::vector<std::uint32_t>, 4> compact();

  /// Bytes of entities, coordinates, classification and attached data; of relations and hash sets.
  [[nodiscard]] std::size_t entity_bytes() const;
  [[nodiscard]] std::size_t adjacency_bytes() const;

 private:
  friend class Journal;
  friend class JournalReplay;
  friend class Request;
  friend class SharedEdits;
  struct Level {
    IdPool ids;
    std::vector<ModelRef> classes;
    Shape uniform = Shape::Point;  ///< the shape of all, while `shapes` is empty
    std::vector<Shape> shapes;
    bool complete = false;
  };
  [[nodiscard]] const Level& level(int dim) const { return levels_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] Level& level(int dim) { return levels_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] int lower_count(EntityRef e, int dim) const {
    return shape_template(shape(e)).count(dim);
  }
  [[nodiscard]] EntityHash& hash_of(int dim) { return hashes_[static_cast<std::size_t>(dim)]; }
  void take_list(int dim, const EntityList& list);
  void take_attributes(const std::vector<Attribute>& attributes);

  // Building and freeing relations (mesh_relations.cpp; the bulk work in bulk.cpp)
  void build(int i, int j);
  [[nodiscard]] Request hold(int i, int j, const char* by);
  void build_up(int i, int j);
  void build_vertices(int i);
  void complete_levels(int i, int j);
  void complete_level(int dim, DownRows* sides_of_faces = nullptr);
  void take_missing(int dim, const MissingEntities& missing);
  void note_built(int i, int j, double milliseconds);
  void free_unwanted(int i, int j);
  [[nodiscard]] DownRows compact_rows(int i, int j,
                                      const std::array<std::vector<std::uint32_t>, 4>& maps) const;
  [[nodiscard]] std::vector<std::uint8_t> entities_to_keep(int dim);
  void close_up_level(int dim, std::span<const std::uint32_t> new_index, std::uint32_t count);
  [[nodiscard]] std::vector<std::pair<int, int>> compact_relations(
      const std::array<std::vector<std::uint32_t>, 4>& maps);
  void keep_model_entities_only(int dim);
  /// What release_derived() let go of.
  struct Derived {
    bool bare = false;  ///< not where other relations than T(I,0) define a level
    std::vector<std::array<int, 2>> relations;
    std::array<bool, 4> hashes{};
    bool class_lists = false;
  };
  [[nodiscard]] Derived release_derived();
  void build_again(const Derived& derived);
  [[nodiscard]] bool defines_level(int i, int j) const;
  [[nodiscard]] bool can_hold(int i, int j) const;
  [[nodiscard]] std::uint32_t widest(int dim, int lower) const;

  // Elementary edits shared by the public ones, undo and redo (mesh_edit.cpp, mesh_rebind.cpp)
  std::uint32_t create_entity(int dim, Shape shape, std::span<const std::uint32_t> vertices,
                              ModelRef model);
  Region create_region_of(Shape shape, int k, std::span<const std::uint32_t> sides, ModelRef model);
  void check_new(int dim, Shape shape, std::span<const std::uint32_t> vertices,
                 ModelRef model) const;
  void ensure_sides(int dim, Shape shape, std::span<const std::uint32_t> vertices, ModelRef model);
  void note_created(EntityRef e, bool fresh);
  void grow_level(int dim);
  void ensure_level(int dim, std::size_t vertices);
  void set_shape(int dim, std::uint32_t id, Shape shape);
  void attach_vertex(std::uint32_t id, const glm::dvec3& position, ModelRef model);
  void attach_entity(int dim, std::uint32_t id, Shape shape,
                     std::span<const std::uint32_t> vertices, ModelRef model);
  void detach_entity(int dim, std::uint32_t id);
  void attach_sides(EntityRef e, int k, std::span<const std::uint32_t> vertices);
  void detach_sides(EntityRef e, int k, std::span<const std::uint32_t> vertices);
  void find_use_directions(EntityRef e, std::span<const std::uint32_t> vertices);
  void apply_rebindings(std::span<const Rebinding> items);
  void rebind_edge(const Rebinding& item);
  void rebind_face(const Rebinding& item, std::span<std::uint32_t> vertices);
  void rebind_face_sides(const Rebinding& item, std::span<const std::uint32_t> vertices);
  void rebind_faces(std::span<const Rebinding> items);
  void replace_in_row(const Rebinding& item);
  void rebind_bare_regions(std::span<const Rebinding> items);
  [[nodiscard]] bool regions_are_bare() const;
  void edit_classification(EntityRef e, ModelRef model);
  void classify(int dim, std::uint32_t id, ModelRef model);

  // Existence (mesh_find.cpp)
  [[nodiscard]] std::uint32_t find(int dim, std::span<const std::uint32_t> vertices) const;
  [[nodiscard]] std::uint32_t find_on(int dim, std::span<const Vertex> vertices) const;
  [[nodiscard]] std::uint32_t find_edge_index(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::uint32_t find_by_hash(int dim, std::span<const std::uint32_t> vertices) const;
  [[nodiscard]] std::uint64_t hash_key(EntityRef e) const;
  [[nodiscard]] bool same_vertices(EntityRef e, std::span<const std::uint32_t> vertices) const;
  [[nodiscard]] bool corners_from_sides(Shape whole, int k, const std::uint32_t* sides,
                                        VertexBuffer& buffer) const;
  [[nodiscard]] std::uint32_t side_of(EntityRef e, int k, int i,
                                      std::span<const std::uint32_t> vertices) const;

  std::vector<glm::dvec3> positions_;
  std::array<Level, 4> levels_{
      Level{{}, {}, Shape::Point, {}, true}, Level{{}, {}, Shape::Line, {}, false},
      Level{{}, {}, Shape::Triangle, {}, false}, Level{{}, {}, Shape::Tetrahedron, {}, true}};
  Representation representation_;
  mutable std::array<EntityHash, 4> hashes_;
  std::unique_ptr<ClassLists> class_lists_;
  AttachedData attached_;
  std::array<std::size_t, 4>
      recorded_creations_{};  ///< by level, those that the journal has applied
  ModelTable model_table_;
  Journal* journal_ = nullptr;
  std::uint64_t revision_ = 0;
};

/// The mesh as plain arrays, ids made consecutive in ascending order; unused vertices are kept.
/// Edges and faces of a level that is not complete are all listed; of a complete one, those
/// classified on a model entity of their own dimension, and those that nothing uses. Attached
/// double, std::int64_t and glm::dvec3 become attributes. O(size).
[[nodiscard]] MeshData to_data(const Mesh& mesh);

template <typename H, typename T>
Attached<H, T>* Mesh::find_attached(std::string_view name) const {
  AttachedBase* found = attached_.find(H::dimension, name);
  return found && found->type() == typeid(T) ? static_cast<Attached<H, T>*>(found) : nullptr;
}

template <typename H, typename T>
Attached<H, T>& Mesh::attached(std::string_view name, T initial) {
  if (Attached<H, T>* known = find_attached<H, T>(name)) return *known;
  constexpr int dim = H::dimension;
  if (attached_.find(dim, name))
    throw std::invalid_argument("column \"" + std::string(name) + "\" holds another type");
  return static_cast<Attached<H, T>&>(attached_.add(
      dim, std::make_unique<Attached<H, T>>(std::string(name), std::move(initial), capacity(dim),
                                            recorded_creations_[static_cast<std::size_t>(dim)])));
}

}  // namespace aomd

#pragma GCC visibility pop
