#include "core/measure/surface_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/fields/surface_pairing.h"

namespace aomd::measure {
namespace {

using fields::Cells;
using fields::VertexSource;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

VertexSource middle_of(const Cells& faces, std::uint32_t f) {
  const auto corners = faces.vertices(f);
  VertexSource source{{corners[0], corners[0], corners[0], corners[0]}, {}};
  for (std::size_t k = 0; k < corners.size() && k < 4; ++k) {
    source.corners[k] = corners[k];
    source.weights[k] = 1 / static_cast<double>(corners.size());
  }
  return source;
}

/// The corners of a face, by their place among those of all faces, instead of its vertices.
VertexSource at_corners(const Cells& cells, std::uint32_t face, VertexSource source) {
  if (face == no_index) return {};
  const auto vertices = cells.vertices(face);
  for (std::uint32_t& v : source.corners) {
    const auto at = std::find(vertices.begin(), vertices.end(), v);
    if (at == vertices.end()) return {};
    v = static_cast<std::uint32_t>(cells.first_corner(face) +
                                   static_cast<std::size_t>(at - vertices.begin()));
  }
  return source;
}

/// Between two directions; none where one has no length.
double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  const double across = glm::length(glm::cross(a, b)), along = glm::dot(a, b);
  const bool both = glm::dot(a, a) > 0 && glm::dot(b, b) > 0;
  return both ? std::atan2(across, along) * 180 / std::numbers::pi : no_number;
}

}  // namespace

SurfacePlaces::SurfacePlaces(const MeshData& original, const MeshData& result, int threads)
    : before_(original, 2), after_(result, 2) {
  add(original, result, true, threads);
  add(result, original, false, threads);
}

void SurfacePlaces::add(const MeshData& own, const MeshData& other, bool own_is_original,
                        int threads) {
  const Cells &cells = own_is_original ? before_ : after_,
              &others = own_is_original ? after_ : before_;
  const fields::SameVertices same(other, own);
  const fields::SurfacePairing pairing(others, cells, same, threads);
  const auto place = [&](const Spot& here, const Spot& there, double area) {
    return own_is_original ? Place{here, there, area} : Place{there, here, area};
  };
  const std::size_t first = middles_.size();
  middles_.resize(first + cells.size());
  parallel_for(cells.size(), threads, 128, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      const fields::SurfacePlace found = pairing.place_at(cells.centre(f), f);
      middles_[first + f] =
          place({f, middle_of(cells, f)}, {found.face, found.corners}, cells.measure(f));
    }
  });
  const std::vector<VertexSource> sources = pairing.vertex_sources();
  for (std::uint32_t v = 0; v < sources.size(); ++v)
    if (sources[v].corners[0] != no_index)
      vertices_.push_back(place({no_index, VertexSource::only(v)}, {no_index, sources[v]}, 0));
}

void SurfacePlaces::fill(const Attribute& array, bool on_corners, const Cells& cells,
                         const Spot& spot, std::vector<double>& values) {
  const bool by_corner = on_corners || array.dimension == 0;
  const VertexSource source =
      on_corners ? at_corners(cells, spot.face, spot.corners) : spot.corners;
  values.assign(static_cast<std::size_t>(array.components), no_number);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (by_corner)
      values[k] = fields::value_at(array, source, k);
    else if (spot.face != no_index)
      values[k] = array.values[values.size() * spot.face + k];
}

template <typename Use>
void SurfacePlaces::for_values(const Attribute& before, const Attribute& after, bool on_corners,
                               Use&& use) const {
  std::vector<double> a, b;
  const auto visit = [&](const Place& place) {
    fill(before, on_corners, before_, place.before, a);
    fill(after, on_corners, after_, place.after, b);
    use(a, b, place.area);
  };
  for (const Place& place : middles_) visit(place);
  if (!on_corners && before.dimension == 0)
    for (const Place& place : vertices_) visit(place);
}

void SurfacePlaces::add_differences(const Attribute& before, const Attribute& after,
                                    bool on_corners, DifferenceSums& sums) const {
  for_values(before, after, on_corners, [&](const auto& a, const auto& b, double area) {
    double squares = 0;
    for (std::size_t k = 0; k < a.size(); ++k) squares += (b[k] - a[k]) * (b[k] - a[k]);
    sums.add(squares, area);
  });
}

void SurfacePlaces::add_angles(const Attribute& before, const Attribute& after, bool on_corners,
                               DifferenceSums& sums) const {
  for_values(before, after, on_corners, [&](const auto& a, const auto& b, double area) {
    const double angle = angle_deg({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
    sums.add(angle * angle, area);
  });
}

}  // namespace aomd::measure
