#pragma once
// What a mesh is, by definition: plain lists of entities with their vertices, and no adjacency at
// all. Every question is answered by going through everything, slowly. Tests compare the database
// with it.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/mesh.h"

namespace aomd::oracle {

using Index = std::uint32_t;
using Ids = std::vector<Index>;

struct Entity {
  Shape shape = Shape::Point;
  Ids vertices;  ///< in template order; of a vertex, itself
  ModelRef model;
  glm::dvec3 position{};       ///< vertices only
  std::uint64_t instance = 0;  ///< different for every creation: what attached data belongs to
};

/// The vertices of the i-th lower entity of dimension `dim`, by the template.
[[nodiscard]] Ids side(const Entity& whole, int dim, int i);
/// True when a lower entity of the template has just these vertices, in any order.
[[nodiscard]] bool has_side(const Entity& whole, int dim, const Ids& vertices);
/// True when both are the same vertices in the same cyclic order, or in the opposite one.
[[nodiscard]] bool same_cycle(const Ids& a, const Ids& b);
[[nodiscard]] Ids sorted(Ids ids);

/// A mesh as lists. The id stack is part of it.
class Plain {
 public:
  Plain() = default;
  explicit Plain(const MeshData& data);

  [[nodiscard]] const std::map<Index, Entity>& level(int dim) const {
    return levels_[static_cast<std::size_t>(dim)];
  }
  [[nodiscard]] bool alive(EntityRef e) const { return level(e.dimension).count(e.index) > 0; }
  [[nodiscard]] const Entity& operator[](EntityRef e) const {
    return level(e.dimension).at(e.index);
  }
  [[nodiscard]] Entity& operator[](EntityRef e) {
    return levels_[static_cast<std::size_t>(e.dimension)].at(e.index);
  }
  [[nodiscard]] Index count(int dim) const { return static_cast<Index>(level(dim).size()); }
  [[nodiscard]] Index capacity(int dim) const { return capacity_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] const Ids& free_ids(int dim) const { return free_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] Ids& free_ids(int dim) { return free_[static_cast<std::size_t>(dim)]; }

  // Questions
  // --------------------------------------------------------------------------------------------
  /// Lower entities in template order (the smallest id where several have the vertices, no_index
  /// where none has), higher ones in ascending order.
  [[nodiscard]] Ids adjacent(EntityRef e, int j) const;
  /// adjacent() of all entities of level i at once.
  [[nodiscard]] std::map<Index, Ids> rows(int i, int j) const;
  /// The smallest id with just these vertices, or no_index.
  [[nodiscard]] Index find(int dim, const Ids& vertices) const;
  [[nodiscard]] std::vector<EntityRef> users(EntityRef e) const;
  /// True when `whole` lists the vertices of its i-th side in the order of the entity `own`.
  [[nodiscard]] bool use_direction(const Entity& whole, int i, const Entity& own) const;
  /// The sides of an entity that are no entities, each once.
  [[nodiscard]] std::vector<Ids> missing_sides(const Entity& whole, int dim) const;
  /// The sides of all entities that are no entities, with the class of the first that has each:
  /// faces before regions, smallest id first.
  [[nodiscard]] std::map<Ids, ModelRef> missing(int dim) const;

  // Edits, of one entity and nothing else
  // ----------------------------------------------------------------
  /// Takes the id from the stack, or the largest one plus one where `fresh` or the stack is empty.
  Index create(int dim, const Entity& entity, bool fresh = false);
  void destroy(EntityRef e);
  /// Numbers every level consecutively.
  void compact();

 private:
  std::array<std::map<Index, Entity>, 4> levels_;
  std::array<Ids, 4> free_;
  std::array<Index, 4> capacity_{};
};

// Each returns what differs first, or nothing

/// Ids, id stacks, shapes, vertices, positions, classes, class lists.
[[nodiscard]] std::string state_difference(const Mesh& mesh, const Plain& plain);
/// Everything that can be asked about one entity: relations stored and derived, use directions,
/// users.
[[nodiscard]] std::string entity_difference(const Mesh& mesh, const Plain& plain, EntityRef e);
/// state_difference(), and every relation and existence query of every entity.
[[nodiscard]] std::string difference(const Mesh& mesh, const Plain& plain);

}  // namespace aomd::oracle
