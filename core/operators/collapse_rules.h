#pragma once
// What limits a collapse, and what it says of itself.

#include <array>
#include <cstdint>

#include "core/mesh/column.h"
#include "core/mesh/geometry.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Safe: a collapse must keep the topology (link condition). Paper: as printed, without that check.
enum class TopologyRule : std::uint8_t { Safe, Paper };

struct CollapseRules {
  TurnLimit max_turn{10.0};  ///< how far the normal of a stretched face may turn
  TopologyRule topology = TopologyRule::Safe;
  /// How far a model edge may turn where it is collapsed along itself; no part of the paper's loop,
  /// so for Safe only. On a flat sheet no normal would ever stop a round hole from becoming a
  /// triangle.
  TurnLimit max_curve_turn{45.0};
  /// By vertex, what the original surface around it looked like, any length, or 0; where given,
  /// contractions hold the faces that they stretch against the sum at their corners too: small
  /// turns add up.
  const Column<Vertex, glm::vec3>* original_normals = nullptr;
  TurnLimit max_away{60.0};   ///< from that sum
  LeastAngle least_angle{0};  ///< no stretched face gets a smaller one, unless it had one
  /// No stretched face gets a smaller angle than this, unless some face around the same end had
  /// one: slivers may go by way of others.
  LeastAngle least_around{0};
};

/// The two ends of an edge.
using EdgeEnds = std::array<Vertex, 2>;

/// A collapse that may also move the vertex it keeps.
struct Contraction {
  Vertex deleted, kept;
  glm::dvec3 position;  ///< where the kept one goes
};

/// One end of an edge on its way; what also uses the other end falls away.
struct EndMove {
  Vertex vertex, other;
  glm::dvec3 to;
};

}  // namespace aomd

#pragma GCC visibility pop
