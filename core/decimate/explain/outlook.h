#pragma once
// What a decimation says about one operation that it has not made: the verdict, and what it would
// come to.

#include <optional>

#include <glm/vec3.hpp>

#include "core/operators/collapse.h"
#include "core/operators/swap.h"
#include "core/operators/verdict.h"

#pragma GCC visibility push(default)

namespace aomd {

/// What verdicts are held against, degrees and lengths; 0 where there is no such limit.
struct Limits {
  double turn_deg = 0;          ///< of a face's normal in one operation
  double away_deg = 0;          ///< of a face from what the original looked like there
  double curve_deg = 0;         ///< of a model edge in one collapse along itself
  double curve_sum_deg = 0;     ///< of a model edge in all operations together
  double min_angle_deg = 0;     ///< of a face, unless it had a smaller one
  double min_dihedral_deg = 0;  ///< between faces of a tetrahedron, unless one there was smaller
  double distance = 0;          ///< from the original
  double volume_pct = 0;        ///< by which a model region may change in all, of its volume
  bool regions = false;         ///< tetrahedra are held to be upright and of some shape
};

/// A collapse of an edge: who would go, who would stay and where that one would be then.
struct CollapseOutlook {
  Contraction contraction;
  Verdict verdict;
  Limits limits;
  double length = 0;   ///< of the edge
  double longest = 0;  ///< an edge must be shorter to go: half the spacing; infinite: any may
  std::optional<double>
      cost;  ///< Quality: what orders collapses; none where it is out of the question
};

struct SwapOutlook {
  EdgePair pair;
  Verdict verdict;
  Limits limits;
};

/// A vertex that would be smoothed, and where it would go (where it is, if that is not known).
struct MoveOutlook {
  Vertex vertex;
  glm::dvec3 target;
  Verdict verdict;
  Limits limits;
};

}  // namespace aomd

#pragma GCC visibility pop
