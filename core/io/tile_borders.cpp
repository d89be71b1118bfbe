#include "core/io/tile_borders.h"

#include <algorithm>
#include <utility>

#include "core/base/edge_key.h"

namespace aomd::io::detail {
namespace {

/// Others are no faces.
bool has_three_corners(const StreamedFile::Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// The vertices of edges that have one face.
VertexRanks border_vertices(const StreamedFile& tile) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * std::size_t{tile.faces()});
  tile.each_faces([&](std::span<const StreamedFile::Triangle> triangles, std::string_view) {
    for (const auto& t : triangles)
      for (std::size_t k = 0; k < 3 && has_three_corners(t); ++k)
        edges.push_back(edge_key(t[k], t[(k + 1) % 3]));
  });
  std::sort(edges.begin(), edges.end());
  VertexRanks border(tile.vertices());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end - i > 1) continue;
    border.add(static_cast<std::uint32_t>(edges[i] >> 32));
    border.add(static_cast<std::uint32_t>(edges[i]));
  }
  return border;
}

}  // namespace

TileBorders::TileBorders(const StreamedFiles& tiles, std::span<const std::uint32_t> first,
                         double tolerance)
    : replaced_(first.back()) {
  Places places;
  for (std::uint32_t tile = 0; tile < tiles.size(); ++tile)
    add_borders(*tiles[tile], tile, first[tile], places);
  Replacements replacements = join_places(std::move(places), tolerance);
  std::sort(replacements.begin(), replacements.end());
  for (const auto& [vertex, by] : replacements) {
    replaced_.add(vertex);
    by_.push_back(by);
  }
  replaced_.finish();
}

void TileBorders::add_borders(const StreamedFile& tile, std::uint32_t number, std::uint32_t first,
                              Places& places) {
  const VertexRanks border = border_vertices(tile);
  std::uint32_t v = 0;
  tile.each_vertices([&](std::span<const glm::dvec3> positions, std::string_view) {
    for (const glm::dvec3& p : positions) {
      if (border.has(v)) places.push_back({p, first + v, number});
      ++v;
    }
  });
}

}  // namespace aomd::io::detail
