#pragma once
// Any adjacency at any time: relations that T does not store are derived from those it does.

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Levels passed through, one after the other; at most five.
class LevelPath {
 public:
  LevelPath() = default;
  LevelPath(std::initializer_list<int> levels) {
    for (const int level : levels) push_back(level);
  }
  void push_back(int level) { levels_[size_++] = static_cast<std::int8_t>(level); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] int operator[](std::size_t k) const { return levels_[k]; }
  [[nodiscard]] const std::int8_t* begin() const { return levels_.data(); }
  [[nodiscard]] const std::int8_t* end() const { return levels_.data() + size_; }

 private:
  std::array<std::int8_t, 5> levels_{};
  std::size_t size_ = 0;
};

/// How an adjacency is answered.
struct AdjacencyPath {
  enum class Kind {
    Stored,    ///< the row of T(I,J)
    Upward,    ///< through levels in between: the union of rows, sorted
    Shared,    ///< down to a lower level and up from there: what has the entity as a side
    Corners,   ///< down to vertices, from whichever downward relation is stored
    Downward,  ///< region to faces to edges, put into the order of the template
    Sides,     ///< down to vertices, then each side of the template by an existence query
    None
  };
  Kind kind = Kind::None;
  LevelPath levels;      ///< I first and J last
  bool by_hash = false;  ///< Sides: existence queries go through a hash set
  double cost = 0;       ///< how many indices are read, on average; a look into a hash set counts 8

  /// "0 -> 1 -> 2 (union of rows)"; where there is no path, what to request.
  [[nodiscard]] std::string text() const;
};

/// The cheapest path of stored relations that answers T(i,j) now. Kind::None where there is none.
/// O(1). Throws std::invalid_argument for the diagonal.
[[nodiscard]] AdjacencyPath explain(const Mesh& mesh, int i, int j);

/// True where `side` (any order) is just the vertices of one of e's lower entities of level k.
/// O(1).
[[nodiscard]] bool has_side(const Mesh& mesh, EntityRef e, int k,
                            std::span<const std::uint32_t> side);

/// The entities of level j adjacent to e, into `result`: lower ones in template order, higher ones
/// sorted. Through explain()'s path. Throws std::logic_error naming what to request where there is
/// no path, and where a lower entity is asked for of a level that is not complete.
void adjacent(const Mesh& mesh, EntityRef e, int j, std::vector<std::uint32_t>& result);

/// The entities of level J adjacent to e as handles, in the order and at the cost of the function
/// above, with what it throws.
template <int J, int I>
[[nodiscard]] std::vector<Handle<J>> adjacent(const Mesh& mesh, Handle<I> e) {
  std::vector<std::uint32_t> indices;
  adjacent(mesh, e, J, indices);
  std::vector<Handle<J>> result;
  result.reserve(indices.size());
  for (const std::uint32_t index : indices) result.push_back(Handle<J>(index));
  return result;
}

}  // namespace aomd

#pragma GCC visibility pop
