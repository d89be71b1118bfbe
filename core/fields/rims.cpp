#include "core/fields/rims.h"

#include <algorithm>
#include <tuple>

namespace aomd::fields {
namespace {

RimSide side_of(std::uint32_t a, std::uint32_t b, std::uint32_t face) {
  return {{std::min(a, b), std::max(a, b)}, face};
}

/// The listed edges on model edges, sorted.
std::vector<std::array<std::uint32_t, 2>> listed_curves(const MeshData& mesh) {
  std::vector<std::array<std::uint32_t, 2>> curves;
  for (std::size_t e = 0; e < mesh.edges.classes.size(); ++e)
    if (mesh.edges.classes[e].dimension() == 1)
      curves.push_back(side_of(mesh.edges.vertices[2 * e], mesh.edges.vertices[2 * e + 1], 0).ends);
  std::sort(curves.begin(), curves.end());
  return curves;
}

}  // namespace

std::vector<RimSide> rims_of(const Cells& faces) {
  std::vector<RimSide> sides;
  sides.reserve(faces.mesh().faces.vertices.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto v = faces.vertices(f);
    for (std::size_t k = 0; k < v.size(); ++k)
      sides.push_back(side_of(v[k], v[(k + 1) % v.size()], f));
  }
  std::sort(sides.begin(), sides.end(), [](const RimSide& a, const RimSide& b) {
    return std::tie(a.ends, a.face) < std::tie(b.ends, b.face);
  });
  const auto curves = listed_curves(faces.mesh());
  std::size_t kept = 0;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
    const bool rim =
        end - i != 2 || std::binary_search(curves.begin(), curves.end(), sides[i].ends);
    for (std::size_t k = i; rim && k < end; ++k) sides[kept++] = sides[k];
  }
  sides.resize(kept);
  return sides;
}

}  // namespace aomd::fields
