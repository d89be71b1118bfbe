#pragma once
// Data attached to entities: an array that only its own kind of handle can index.

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/handle.h"

#pragma GCC visibility push(default)

namespace aomd {

/// One T for every entity id of a kind. `Column<Vertex, double> spacing(mesh.capacity<0>())`.
template <typename H, typename T>
class Column {
 public:
  Column() = default;
  explicit Column(std::size_t size, T value = T{}) : values_(size, value) {}

  [[nodiscard]] T& operator[](H h) { return values_[h.index]; }
  [[nodiscard]] const T& operator[](H h) const { return values_[h.index]; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  void resize(std::size_t size, T value = T{}) { values_.resize(size, value); }
  void assign(std::size_t size, T value) { values_.assign(size, value); }
  [[nodiscard]] std::size_t bytes() const { return values_.capacity() * sizeof(T); }

 private:
  std::vector<T> values_;
};

/// The values of some entities, one after the other: for a copy in which these are all. T() where
/// an entity came after the column was made.
template <typename H, typename T>
[[nodiscard]] Column<H, T> closed_up(const Column<H, T>& column, std::span<const H> entities) {
  Column<H, T> result(entities.size());
  for (std::uint32_t i = 0; i < entities.size(); ++i)
    if (entities[i].index < column.size()) result[H(i)] = column[entities[i]];
  return result;
}

}  // namespace aomd

#pragma GCC visibility pop
