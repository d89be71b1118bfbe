#pragma once
// Ways to cut a triangle into parts.

#include <array>
#include <cstddef>
#include <span>

#include "core/model/triangle_tree.h"

namespace aomd {

/// Where a distance decides: parts shorter than this share of it are cut no further, nor is what
/// came to more parts. Nothing is certain of them then.
inline constexpr double least_part = 1.0 / 16;
inline constexpr int most_parts = 4096;

/// Parts of a triangle, which together are all of it: none, or two or three.
struct TriangleParts {
  std::array<Triangle, 3> corners;
  std::size_t count = 0;

  [[nodiscard]] std::span<const Triangle> span() const { return {corners.data(), count}; }
};

/// Squared.
[[nodiscard]] double longest_side2(const Triangle& t);

/// Two, by the middle of the longest side.
[[nodiscard]] TriangleParts bisected(const Triangle& t);

/// Three, by the upright plane along a side of `one`, and `out` beyond it: the side that `t`
/// reaches over most. None where it reaches over each by at most `out` and `least`, or does not
/// come that far inside, and where `one` has no area.
[[nodiscard]] TriangleParts cut_along_sides(const Triangle& t, const Triangle& one, double out,
                                            double least);

}  // namespace aomd
