#include "core/measure/histogram.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/measure/volume_statistics.h"
#include "core/mesh/geometry.h"

namespace aomd::measure {

std::vector<Sample> smallest_angles(const Mesh& mesh) {
  std::vector<Sample> samples;
  samples.reserve(mesh.count(2));
  VertexBuffer buffer;
  for (const Face f : mesh.faces()) {
    const auto v = mesh.vertices_of(f, buffer);
    const auto at = [&](std::size_t k) { return mesh.position(Vertex(v[k])); };
    double smallest = 180;
    for (std::size_t k = 1; k + 1 < v.size(); ++k)
      smallest = std::min(smallest, smallest_angle_deg(at(0), at(k), at(k + 1)));
    samples.push_back({f, smallest});
  }
  return samples;
}

std::vector<Sample> smallest_dihedrals(const Mesh& mesh) {
  std::vector<Sample> samples;
  samples.reserve(mesh.count(3));
  for (const Region r : mesh.regions()) samples.push_back({r, smallest_dihedral_deg(mesh, r)});
  return samples;
}

std::vector<Sample> length_ratios(const Mesh& mesh, const Column<Vertex, double>& wanted) {
  std::vector<Sample> samples;
  samples.reserve(mesh.count(1));
  const auto at = [&](Vertex v) { return v.index < wanted.size() ? wanted[v] : 0.0; };
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    const double length = 0.5 * (at(a) + at(b));
    if (!(at(a) > 0) || !(at(b) > 0) || !std::isfinite(length)) continue;
    samples.push_back({e, glm::length(mesh.position(b) - mesh.position(a)) / length});
  }
  return samples;
}

std::vector<Sample> valences(const Mesh& mesh) {
  std::vector<std::uint32_t> edges(mesh.capacity(0), 0);
  for (const Edge e : mesh.edges())
    for (const Vertex v : mesh.edge_vertices(e)) ++edges[v.index];
  std::vector<Sample> samples;
  for (const Vertex v : mesh.vertices())
    if (edges[v.index] > 0) samples.push_back({v, static_cast<double>(edges[v.index])});
  return samples;
}

std::size_t Histogram::bin(double value) const {
  const double place = std::floor((value - low) / width());
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(counts.size() - 1)));
}

Histogram make_histogram(std::span<const Sample> samples, double low, double high,
                         std::size_t bins) {
  Histogram result{low, high, std::vector<std::size_t>(bins, 0), samples.size()};
  if (samples.empty()) return result;
  result.least = result.largest = samples[0].value;
  for (const Sample& sample : samples) {
    ++result.counts[result.bin(sample.value)];
    result.mean += sample.value;
    result.least = std::min(result.least, sample.value);
    result.largest = std::max(result.largest, sample.value);
  }
  result.mean /= static_cast<double>(samples.size());
  return result;
}

std::vector<EntityRef> entities_in(std::span<const Sample> samples, const Histogram& histogram,
                                   std::size_t bin) {
  std::vector<EntityRef> found;
  for (const Sample& sample : samples)
    if (histogram.bin(sample.value) == bin) found.push_back(sample.entity);
  return found;
}

}  // namespace aomd::measure
