#pragma once
// Which border vertices of tiles are one although they are not quite at the same place.

#include <cstdint>
#include <exception>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::io::detail {

/// A vertex on the border of a tile.
struct TilePlace {
  glm::dvec3 position;
  std::uint32_t vertex = 0;  ///< counted through all tiles
  std::uint32_t tile = 0;
};

/// A vertex, and which one stands for it.
using TileReplacements = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Those at exactly the same place become the first of them, or with a tolerance what
/// weld_places() says. A place at which one tile has two stays as it is.
[[nodiscard]] TileReplacements join_places(std::vector<TilePlace> places, double tolerance);

/// There are too many within the tolerance to go through.
struct WeldTooWide : std::exception {};

/// Those that lie within the tolerance, more than 0, of the first of them: the nearest two are
/// joined first, of equally near ones those that come first. No two of one tile become one. It
/// follows from the set of places alone. In memory are 24 B for each two within the tolerance.
/// Throws WeldTooWide for more than 64 times as many as places.
[[nodiscard]] TileReplacements weld_places(std::span<const TilePlace> given, double tolerance);

}  // namespace aomd::io::detail
