#include "core/measure/surface_places.h"

#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/fields/surface_pairing.h"

namespace aomd::measure {
namespace {

using fields::Cells;
using fields::VertexSource;

VertexSource middle_of(const Cells& faces, std::uint32_t f) {
  const auto corners = faces.vertices(f);
  VertexSource source{{corners[0], corners[0], corners[0], corners[0]}, {}};
  for (std::size_t k = 0; k < corners.size() && k < 4; ++k) {
    source.corners[k] = corners[k];
    source.weights[k] = 1 / static_cast<double>(corners.size());
  }
  return source;
}

}  // namespace

SurfacePlaces::SurfacePlaces(const MeshData& original, const MeshData& result, int threads) {
  add(original, result, true, threads);
  add(result, original, false, threads);
}

void SurfacePlaces::add(const MeshData& own, const MeshData& other, bool own_is_original,
                        int threads) {
  const Cells cells(own, 2), others(other, 2);
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

double SurfacePlaces::value(const Attribute& array, const Spot& spot, std::size_t component) {
  if (array.dimension == 0) return fields::value_at(array, spot.corners, component);
  if (spot.face == no_index) return std::numeric_limits<double>::quiet_NaN();
  return array.values[static_cast<std::size_t>(array.components) * spot.face + component];
}

void SurfacePlaces::add_differences(const Attribute& before, const Attribute& after,
                                    DifferenceSums& sums) const {
  const auto add = [&](const Place& place) {
    double squares = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(before.components); ++k) {
      const double d = value(after, place.after, k) - value(before, place.before, k);
      squares += d * d;
    }
    sums.add(squares, place.area);
  };
  for (const Place& place : middles_) add(place);
  if (before.dimension == 0)
    for (const Place& place : vertices_) add(place);
}

}  // namespace aomd::measure
