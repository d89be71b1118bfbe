#pragma once
// The cheapest candidate of a vertex, while what the edges around it cost changes.

#include <algorithm>
#include <limits>

#include "core/mesh/handle.h"

namespace aomd {

/// What a queue of vertices knows of the edges at one of them. Exact as long as the partner is
/// known; bounds from below after that, until all edges are looked at again.
struct Cheapest {
  static constexpr float unlimited = std::numeric_limits<float>::infinity();

  Vertex partner;            ///< the other end of its cheapest candidate; invalid: not known
  float cost = unlimited;    ///< of that; where not known, a bound from below
  float second = unlimited;  ///< a bound from below for all its others

  void forget() { *this = {}; }

  /// One more candidate.
  void offer(Vertex other, float its_cost) {
    if (its_cost < cost) {
      second = cost;
      cost = its_cost;
      partner = other;
    } else {
      second = std::min(second, its_cost);
    }
  }

  /// The edge to a vertex that has taken another in has a new cost; others have not become cheaper.
  /// `alive` says whether the partner still exists. False where the cheapest one stays as it was.
  [[nodiscard]] bool update(Vertex kept, float its_cost, bool alive) {
    const bool known = partner != kept && alive;
    if (known || its_cost < cost) {
      const bool cheaper = its_cost < cost;
      offer(kept, its_cost);
      return cheaper;
    }
    const bool still_least = its_cost <= second;
    partner = still_least ? kept : Vertex();
    cost = still_least ? its_cost : second;
    return true;
  }
};

}  // namespace aomd
