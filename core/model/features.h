#pragma once
// Which edges of a mesh are features: curves of the model that the mesh implies.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

class EdgeFaces;

/// What find_features() saw.
struct FeatureCount {
  std::uint32_t borders =
      0;  ///< boundary and non-manifold edges, borders between model faces, edges given as features
  std::uint32_t sharp = 0;  ///< edges past the angle that were kept
  std::uint32_t rough = 0;  ///< edges past the angle that were taken for roughness
  std::uint32_t steps = 0;  ///< edges past the angle that are steps of a round drawn in facets
};

struct FeatureOptions {
  std::optional<double> angle_deg = 20.0;  ///< none: borders only
  bool nonmanifold_edges = true;           ///< edges with more than two faces are borders
  bool ignore_classes = false;             ///< as if nothing were classified
  std::span<const std::array<std::uint32_t, 2>> seams{};  ///< edges, by vertices, that are borders
};

/// Marks the edges that lie on model edges. Besides borders these are the edges whose faces meet at
/// more than the angle, except roughness and the steps of rounds.
///
/// Roughness: on a scan many edges are past any useful angle but lead nowhere. A connected set of
/// sharp edges is roughness when more than 15 % of it are hairs (open chains of fewer than 8
/// edges), or when it has fewer than 6 edges and spans less than 2 % of the mesh's diagonal. Hairs
/// of the sets that stay are dropped too. Where more than two thirds of the sharp edges fell so,
/// the mesh is a scan and the rest falls as well.
///
/// Steps: between facets that stand for a smooth surface every edge is sharp (see FacetJudge).
/// Where there are some, roughness is judged again without them, and a curve of at least 8 edges
/// that breaks off at steps in line with it is carried on over at most 8 of them. A fine mesh (less
/// than a tenth of its edges sharp) that was taken for a scan stays one.
///
/// docs/CLASSIFICATION.md has the measurements behind the numbers. The mesh must store T(2,0) and
/// T(2,1); with T(0,1) seams are found sooner. O(entities).
FeatureCount find_features(const Mesh& mesh, const FeatureOptions& options,
                           Column<Edge, std::uint8_t>& feature);
/// The same where the faces of each edge are known.
FeatureCount find_features(const Mesh& mesh, const EdgeFaces& faces, const FeatureOptions& options,
                           Column<Edge, std::uint8_t>& feature);

}  // namespace aomd

#pragma GCC visibility pop
