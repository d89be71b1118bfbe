#pragma once
// Judge, then edit: what an operator says about a proposed edit before anything is changed.

#include <cstdint>

#include "core/mesh/handle.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Why an operator refused, as numbered in reports and recordings.
enum class Reason : std::uint8_t {
  None,            ///< accepted
  Spacing,         ///< the edge is not shorter than the spacing of either end; number: its length
  Classification,  ///< paper section 3: the deleted vertex must lie on what the edge lies on, and
                   ///< not on a model vertex
  Topology,        ///< the link condition: the mesh would be pinched, doubled or torn
  Flat,            ///< a face would have no area
  Angle,           ///< a face normal would turn too far; number: degrees
  Quality,   ///< the shape would not get better; number: the smallest angle that would result, in
             ///< degrees
  Kept,      ///< the user wants the vertex to stay where it is
  Shape,     ///< a face would get an angle below the limit, a tetrahedron too bad a shape; number:
             ///< the angle in degrees, of a tetrahedron the smallest between two of its faces
  Distance,  ///< the surface would leave the original by more than the limit; number: the distance
  Intersection,  ///< the surface would cut itself where it did not
  Inverted,      ///< a tetrahedron would have no volume, or be inside out
  Overshoot,     ///< an edge would become too long for the size there; number: its length
  Volume,        ///< a model region would gain or lose more than its limit in all; number: percent
                 ///< of its volume, negative where it would be smaller
};
inline constexpr int reason_count = 14;

/// Where the check stands in the order of those that a collapse passes; 0 for None.
[[nodiscard]] int check_order(Reason reason);

/// "Classification" and so on: the keys of reports.
[[nodiscard]] const char* reason_name(Reason reason);

/// Yes, or no with the reason, the number that decided and the entity that decided.
class Verdict {
 public:
  constexpr Verdict() = default;
  constexpr Verdict(Reason why, EntityRef who, double measure = 0)
      : reason(why), entity(who), measure_(measure) {}

  Reason reason = Reason::None;
  EntityRef entity;

  [[nodiscard]] bool accepted() const { return reason == Reason::None; }
  /// See Reason; computed when asked for, since a sweep refuses many edges and shows few.
  [[nodiscard]] double number() const;

 private:
  double measure_ = 0;  ///< a length, or the cosine of the angle in question
};

}  // namespace aomd

#pragma GCC visibility pop
