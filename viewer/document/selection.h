#pragma once
// Which entities are selected.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// Entities of any kinds. They stay selected while they live.
class Selection {
 public:
  [[nodiscard]] bool empty() const { return entities_.empty(); }
  [[nodiscard]] std::size_t size() const { return entities_.size(); }
  /// Sorted: vertices first, by id.
  [[nodiscard]] std::span<const EntityRef> entities() const { return entities_; }
  [[nodiscard]] bool contains(EntityRef e) const;
  /// The only one, or an invalid one.
  [[nodiscard]] EntityRef single() const { return size() == 1 ? entities_[0] : EntityRef(); }

  void clear() { replace({}); }
  void replace(std::vector<EntityRef> entities);
  void add(std::span<const EntityRef> entities);
  void remove(std::span<const EntityRef> entities);
  /// What a click with Shift does.
  void toggle(EntityRef e);
  /// Lets go of what does not live any more. O(size).
  void drop_dead(const Mesh& mesh);

  /// Another one whenever the selection has changed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  std::vector<EntityRef> entities_;
  std::uint64_t revision_ = 0;
};

/// "3 edges, 1 face"; "nothing".
[[nodiscard]] std::string selection_text(const Selection& selection);

/// What the selection touches: the entities of its kinds that share a vertex with one of it, itself
/// included. For vertices those of the faces and regions around. Whatever T stores; O(entities of
/// those kinds).
[[nodiscard]] std::vector<EntityRef> grown(const Mesh& mesh, const Selection& selection);

}  // namespace aomd::scene
