#include "core/fields/vertex_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/fields/field.h"

namespace aomd::fields {
namespace {

/// A region of each vertex, or no_index.
std::vector<std::uint32_t> some_region(const Cells& regions) {
  std::vector<std::uint32_t> some(regions.mesh().positions.size(), no_index);
  for (std::uint32_t r = 0; r < regions.size(); ++r)
    for (const std::uint32_t v : regions.vertices(r))
      if (some[v] == no_index) some[v] = r;
  return some;
}

VertexSource corners_of(const Cells& original, std::uint32_t region, const glm::dvec3& p) {
  VertexSource source;
  const auto corners = original.vertices(region);
  std::copy(corners.begin(), corners.end(), source.corners.begin());
  source.weights = TetCoordinates(original.tet(region)).refined(p);
  return source;
}

/// A little from the vertex towards the middle of one of its regions: on their side of what touches
/// there.
glm::dvec3 inward(const glm::dvec3& p, const Cells& regions, std::uint32_t region) {
  return region == no_index ? p : p + 1e-6 * (regions.centre(region) - p);
}

VertexSource source_at(const Cells& original, const TetTree& tree, const glm::dvec3& p,
                       const glm::dvec3& inner, std::span<const std::uint32_t> same) {
  if (same.size() == 1) return VertexSource::only(same[0]);
  const std::uint32_t region = tree.region_at(inner);
  if (same.empty()) return region == no_index ? VertexSource() : corners_of(original, region, p);
  if (region != no_index)
    for (const std::uint32_t v : original.vertices(region))
      if (original.mesh().positions[v] == p) return VertexSource::only(v);
  return VertexSource::only(same[0]);
}

double interpolated(const Attribute& array, const VertexSource& source, std::size_t component) {
  const auto value = [&](std::size_t k) {
    return array.values[static_cast<std::size_t>(array.components) * source.corners[k] + component];
  };
  if (source.weights[0] == 1) return value(0);
  double known = 0, sum = 0;
  bool all = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = value(k);
    all = all && std::isfinite(x);
    if (!std::isfinite(x)) continue;
    known += source.weights[k];
    sum += source.weights[k] * x;
  }
  if (!all) return known > 0.5 ? sum / known : std::numeric_limits<double>::quiet_NaN();
  double change = 0;
  for (std::size_t k = 1; k < 4; ++k) change += source.weights[k] * (value(k) - value(0));
  return value(0) + change;
}

double label(const Attribute& array, const VertexSource& source, std::size_t component) {
  const auto heaviest = std::max_element(source.weights.begin(), source.weights.end());
  const auto k = static_cast<std::size_t>(heaviest - source.weights.begin());
  return array.values[static_cast<std::size_t>(array.components) * source.corners[k] + component];
}

}  // namespace

std::vector<VertexSource> vertex_sources(const Cells& original, const TetTree& tree,
                                         const Cells& result, const SameVertices& same,
                                         int threads) {
  const std::vector<glm::dvec3>& positions = result.mesh().positions;
  const std::vector<std::uint32_t> region = some_region(result);
  std::vector<VertexSource> sources(positions.size());
  parallel_for(positions.size(), threads, 256, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
      sources[v] = source_at(original, tree, positions[v], inward(positions[v], result, region[v]),
                             same.at(v));
  });
  return sources;
}

double value_at(const Attribute& array, const VertexSource& source, std::size_t component) {
  const bool mixes = kind_of(array) != FieldKind::Label;
  if (source.corners[0] == no_index) return mixes ? std::numeric_limits<double>::quiet_NaN() : 0;
  return mixes ? interpolated(array, source, component) : label(array, source, component);
}

Attribute at_vertices(const Attribute& array, const std::vector<VertexSource>& sources) {
  Attribute result = like(array);
  const auto stride = static_cast<std::size_t>(array.components);
  result.values.reserve(sources.size() * stride);
  const bool mixes = kind_of(array) != FieldKind::Label;
  for (const VertexSource& source : sources) {
    for (std::size_t k = 0; k < stride; ++k) result.values.push_back(value_at(array, source, k));
    if (mixes && (source.corners[0] == no_index || source.weights[0] != 1))
      settle(array, std::span(result.values).last(stride));
  }
  return result;
}

}  // namespace aomd::fields
