#pragma once
// How values spread over the entities of a mesh: smallest angles, lengths of edges, valences.

#include <cstddef>
#include <span>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd::measure {

/// One number of one entity.
struct Sample {
  EntityRef entity;
  double value = 0;
  friend bool operator==(const Sample&, const Sample&) = default;
};

/// The smallest angle of each face in degrees, by ascending ids; of a quad the smaller one of its
/// two triangles. O(faces).
[[nodiscard]] std::vector<Sample> smallest_angles(const Mesh& mesh);

/// The smallest dihedral angle of each region in degrees, by ascending ids. O(regions).
[[nodiscard]] std::vector<Sample> smallest_dihedrals(const Mesh& mesh);

/// The length of each edge over the mean of what is wanted at its ends, by ascending ids. Edges
/// whose ends want nothing (0, infinite, or beyond the column) are left out. The mesh's edges must
/// be entities. O(edges).
[[nodiscard]] std::vector<Sample> length_ratios(const Mesh& mesh,
                                                const Column<Vertex, double>& wanted);

/// How many edges each vertex has, by ascending ids; vertices without edges are left out. The
/// mesh's edges must be entities. O(edges).
[[nodiscard]] std::vector<Sample> valences(const Mesh& mesh);

/// Counts of values in bins of equal width over [low, high]. A bin holds its lower bound, the last
/// one both.
struct Histogram {
  double low = 0, high = 1;
  std::vector<std::size_t>
      counts;  ///< a bin each; what lies beyond a bound counts in the bin there
  std::size_t total = 0;
  double mean = 0;                ///< 0 without values, as are the next two
  double least = 0, largest = 0;  ///< of the values themselves

  [[nodiscard]] double width() const { return (high - low) / static_cast<double>(counts.size()); }
  /// The bin in which a value counts.
  [[nodiscard]] std::size_t bin(double value) const;
  /// The lower bound of a bin; of counts.size() the upper bound of the last.
  [[nodiscard]] double bound(std::size_t bin) const {
    return low + width() * static_cast<double>(bin);
  }
};

/// low < high, bins > 0. O(values + bins).
[[nodiscard]] Histogram make_histogram(std::span<const Sample> samples, double low, double high,
                                       std::size_t bins);

/// The entities that a bin counts, in the order of the samples. O(samples).
[[nodiscard]] std::vector<EntityRef> entities_in(std::span<const Sample> samples,
                                                 const Histogram& histogram, std::size_t bin);

}  // namespace aomd::measure
