#pragma once
// The mesh entities of each model entity (paper, section 2.2), kept while the mesh changes.

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/mesh/id_pool.h"
#include "core/mesh/model_ref.h"

#pragma GCC visibility push(default)

namespace aomd {

/// For every level and model entity, the ids of the mesh entities classified on it. Insert and
/// erase O(1); the order within a list is unspecified. Unclassified entities have a list of their
/// own, that of ModelRef().
class ClassLists {
 public:
  [[nodiscard]] std::span<const std::uint32_t> entities(int dim, ModelRef model) const;
  /// The model entities that have mesh entities of a level, sorted. O(n log n) in their number.
  [[nodiscard]] std::vector<ModelRef> models(int dim) const;
  /// How many these are. O(1).
  [[nodiscard]] std::size_t model_count(int dim) const { return level(dim).used; }
  [[nodiscard]] std::size_t bytes() const;

  /// All entities of a level, which has no lists yet; `classes` by id. O(ids).
  void insert_all(int dim, const IdPool& ids, std::span<const ModelRef> classes);
  void insert(int dim, std::uint32_t id, ModelRef model);
  void erase(int dim, std::uint32_t id, ModelRef model);

 private:
  struct Level {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> lists;  ///< by ModelRef::bits
    std::vector<std::uint32_t> place;  ///< by id: position in its list
    std::size_t used = 0;              ///< lists that are not empty
  };
  [[nodiscard]] Level& level(int dim) { return levels_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] const Level& level(int dim) const { return levels_[static_cast<std::size_t>(dim)]; }

  std::array<Level, 4> levels_;
};

}  // namespace aomd

#pragma GCC visibility pop
