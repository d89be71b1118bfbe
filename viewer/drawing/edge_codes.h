#pragma once
// What is said about each edge, as its two faces carry it to the picture.

#include <cstdint>

#include "core/mesh/column.h"
#include "core/operators/verdict.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene {

/// By edge: a Reason, or `unjudged`. Four bits of CornerFlag hold one.
using EdgeCodes = Column<Edge, std::uint8_t>;
inline constexpr std::uint8_t unjudged = 15;
static_assert(reason_count <= unjudged);

/// The colour of an edge with this code; safe for colour-blind eyes as far as fourteen can be.
[[nodiscard]] Color verdict_color(std::uint8_t code);

}  // namespace aomd::scene
