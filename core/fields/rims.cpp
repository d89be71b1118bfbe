#include "core/fields/rims.h"

#include <algorithm>
#include <compare>
#include <span>

#include "core/base/buckets.h"

namespace aomd::fields {
namespace {

std::array<std::uint32_t, 2> ends_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// A side of a face, filed under the smaller one of its ends.
struct FiledSide {
  std::uint32_t larger = 0, face = 0;
  friend auto operator<=>(const FiledSide&, const FiledSide&) = default;
};

Buckets<FiledSide> sides_of(const Cells& faces) {
  return {faces.mesh().positions.size(), [&](auto&& file) {
            for (std::uint32_t f = 0; f < faces.size(); ++f) {
              const auto v = faces.vertices(f);
              for (std::size_t k = 0; k < v.size(); ++k) {
                const auto ends = ends_of(v[k], v[k + 1 < v.size() ? k + 1 : 0]);
                file(ends[0], FiledSide{ends[1], f});
              }
            }
          }};
}

/// The listed edges on model edges, sorted.
std::vector<std::array<std::uint32_t, 2>> listed_curves(const MeshData& mesh) {
  std::vector<std::array<std::uint32_t, 2>> curves;
  for (std::size_t e = 0; e < mesh.edges.classes.size(); ++e)
    if (mesh.edges.classes[e].dimension() == 1)
      curves.push_back(ends_of(mesh.edges.vertices[2 * e], mesh.edges.vertices[2 * e + 1]));
  std::sort(curves.begin(), curves.end());
  return curves;
}

}  // namespace

std::vector<RimSide> rims_of(const Cells& faces) {
  Buckets<FiledSide> filed = sides_of(faces);
  const auto curves = listed_curves(faces.mesh());
  std::vector<RimSide> rims;
  for (std::uint32_t v = 0; v < filed.count(); ++v) {
    const std::span<FiledSide> sides = filed[v];
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      while (end < sides.size() && sides[end].larger == sides[i].larger) ++end;
      const std::array ends{v, sides[i].larger};
      if (end - i == 2 && !std::binary_search(curves.begin(), curves.end(), ends)) continue;
      for (std::size_t k = i; k < end; ++k) rims.push_back({ends, sides[k].face});
    }
  }
  return rims;
}

}  // namespace aomd::fields
