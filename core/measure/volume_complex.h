#pragma once
// A volume mesh as model regions with the surfaces around and between them, and what does not fit
// together in it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/side_index.h"

namespace aomd::measure {

/// What a mesh has of one model region. Regions without a class count as one, whose `model` is
/// invalid.
struct RegionFacts {
  ModelRef model;
  std::size_t regions = 0;
  double volume = 0;
  std::int64_t euler = 0;  ///< vertices - edges + faces - regions, of what its regions use
  std::size_t parts = 0;   ///< sets of its regions that hang together by faces
};

/// Where a face of the skin lies: between a model region and the outside, or between two.
struct Interface {
  bool boundary = true;
  ModelRef first, second;  ///< the smaller one first; on the boundary both are the region
  ModelRef face;           ///< the model face on which the mesh lists it, or none

  /// Whether it is one even where model faces do not count: no face inside a model region.
  [[nodiscard]] bool separates() const { return boundary || first != second; }
  /// Without the model face unless these count.
  [[nodiscard]] Interface seen(bool model_faces) const {
    return {boundary, first, second, model_faces ? face : ModelRef()};
  }
  friend bool operator==(const Interface&, const Interface&) = default;
  friend bool operator<(const Interface& a, const Interface& b);
};

/// A side of one region, of two on different model regions, or one that is listed on a model face.
struct SkinFace {
  SideVertices vertices;  ///< looking out of `first`
  Interface on;
};

struct VolumeComplex {
  std::vector<RegionFacts> regions;  ///< by ascending `model`
  std::vector<SkinFace> skin;
  std::vector<Region> repeated;               ///< on the same vertices as an earlier one
  std::vector<Region> crowded;                ///< the first of three or more at one side, each
  std::vector<std::array<Region, 2>> folded;  ///< lie on the same side of the face they share
  std::size_t dangling_faces = 0;             ///< listed, but a side of no region

  [[nodiscard]] bool conforming() const {
    return repeated.empty() && crowded.empty() && folded.empty();
  }
};

/// Whether or not the mesh has faces and edges as entities. Faces that a region shares with two
/// others or more count for the first two. O(sides log sides at a vertex), about 150 bytes a
/// tetrahedron meanwhile.
[[nodiscard]] VolumeComplex analyse_volume(const Mesh& mesh, int threads = 1);

/// By vertex id: whether a region uses it. O(regions).
[[nodiscard]] std::vector<bool> used_by_regions(const Mesh& mesh);

}  // namespace aomd::measure
