#pragma once
// How a journal packs one edit into words: the one description that recording, undoing and checking
// read.
//
//   Create, Destroy   head, id, class, then 6 words of a position (vertices) or `count` vertices
//   Rebind            head, then `count` times: dimension << 8 | slot, id, from, to
//   Move              head, vertex, position before, position after
//   Classify          head, id, class before, class after

#include <bit>
#include <cstdint>

#include <glm/vec3.hpp>

#include "core/mesh/shape.h"

#pragma GCC visibility push(default)

namespace aomd {

enum class RecordKind : std::uint32_t { Create, Destroy, Rebind, Move, Classify };

/// A position in six words.
[[nodiscard]] inline glm::dvec3 unpack_position(const std::uint32_t* w) {
  glm::dvec3 p;
  for (int k = 0; k < 3; ++k, w += 2)
    p[k] = std::bit_cast<double>(std::uint64_t{w[0]} | std::uint64_t{w[1]} << 32);
  return p;
}

/// The first word of a record.
struct RecordHead {
  RecordKind kind = RecordKind::Create;
  int dim = 0;
  Shape shape = Shape::Point;
  bool fresh = false;  ///< the id was the maximum plus one, not taken from the stack
  std::uint32_t count = 0;

  // A Rebind may hold more items than 18 bits count: the high part stands where others keep dim,
  // fresh and shape.
  [[nodiscard]] constexpr std::uint32_t packed() const {
    const auto low = static_cast<std::uint32_t>(kind);
    if (kind == RecordKind::Rebind) return low | (count >> 18) << 3 | count << 14;
    return low | static_cast<std::uint32_t>(dim) << 3 | std::uint32_t{fresh} << 5 |
           static_cast<std::uint32_t>(shape) << 6 | count << 14;
  }
  [[nodiscard]] static constexpr RecordHead unpack(std::uint32_t w) {
    const auto kind = static_cast<RecordKind>(w & 7u);
    if (kind == RecordKind::Rebind)
      return {kind, 0, Shape::Point, false, w >> 14 | ((w >> 3) & 0x7ffu) << 18};
    return {kind, static_cast<int>((w >> 3) & 3u), static_cast<Shape>((w >> 6) & 255u),
            ((w >> 5) & 1u) != 0, w >> 14};
  }
  /// Words of the whole record, the head included.
  [[nodiscard]] constexpr std::size_t length() const {
    switch (kind) {
      case RecordKind::Create:
      case RecordKind::Destroy:
        return 3 + std::size_t{dim == 0 ? 6 : count};
      case RecordKind::Rebind:
        return 1 + 4 * std::size_t{count};
      case RecordKind::Move:
        return 14;
      case RecordKind::Classify:
        return 4;
    }
    return 1;
  }
};

}  // namespace aomd

#pragma GCC visibility pop
