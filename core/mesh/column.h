#pragma once
// Data attached to entities: an array that only its own kind of handle can index.

#include <vector>

#include "core/mesh/handle.h"

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

}  // namespace aomd
