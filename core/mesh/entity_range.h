#pragma once
// Iteration over the entities of one level.

#include <vector>

#include "core/mesh/handle.h"
#include "core/mesh/id_pool.h"

#pragma GCC visibility push(default)

namespace aomd {

/// The entities of one level that are alive, in ascending order of ids. Creating or deleting
/// entities while iterating is allowed: deleted ones are skipped, those with a larger id than the
/// present one are visited.
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
  /// Calls visit(handle) for all of them. None may be created or deleted meanwhile, so that this
  /// costs less than iterating.
  template <typename Visit>
  void each(Visit&& visit) const {
    each_alive(*ids_, 0, ids_->capacity(), [&](std::uint32_t id) { visit(Handle<Dim>(id)); });
  }
  /// All of them. O(capacity).
  [[nodiscard]] std::vector<Handle<Dim>> list() const {
    std::vector<Handle<Dim>> all;
    all.reserve(ids_->size());
    for (const Handle<Dim> h : *this) all.push_back(h);
    return all;
  }

 private:
  const IdPool* ids_;
};

}  // namespace aomd

#pragma GCC visibility pop
