#pragma once
// Verdicts on collapses among tetrahedra, in words, where they say more than on surfaces.

#include <string>

#include "core/decimate/explain/outlook.h"

namespace aomd::words {

/// Classification: "Vertex 12 lies on model face 7 and the edge inside model region 2: the face
/// would be dented." T(0,3), T(3,0), T(0,2), T(2,0) and T(0,1) must be stored.
[[nodiscard]] std::string volume_model_words(const Mesh& mesh, const Contraction& contraction);

/// Topology, by what both ends share beside the edge.
[[nodiscard]] std::string volume_topology_words(const Mesh& mesh, const CollapseOutlook& outlook);

/// Inverted, Overshoot, and Kept and Shape of a region; empty for other verdicts.
[[nodiscard]] std::string region_words(const Mesh& mesh, const Verdict& verdict);

/// What removing an edge would come to, beside Flat, Angle, Shape and the guarantees, of which
/// surfaces say the same; empty for those.
[[nodiscard]] std::string removal_words(const Mesh& mesh, Edge edge, const Verdict& verdict);

}  // namespace aomd::words
