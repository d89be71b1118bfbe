#pragma once
// Why an entity is as it is: what decimation says about it now, in words, and what that would look
// like.

#include <optional>
#include <string>
#include <vector>

#include "core/decimate/decimation.h"
#include "core/decimate/explain/explanation.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// One way in which an edge could be collapsed.
struct CollapseWay {
  CollapseOutlook outlook;
  std::string words;
  std::vector<CheckResult> checks;
};

/// What is said about one entity: collapses and swap of an edge, smoothing of a vertex.
struct EntityVerdict {
  EntityRef entity;
  std::vector<CollapseWay> ways;
  std::size_t best = 0;  ///< the way that is allowed, else the one that got furthest
  std::optional<SwapOutlook> swap;
  std::optional<MoveOutlook> move;
  std::string swap_words, move_words;  ///< also where the strategy cannot tell now
};

/// O(faces around it). Nothing for faces and regions.
[[nodiscard]] std::optional<EntityVerdict> judge(Decimation& decimation, const Mesh& mesh,
                                                 EntityRef e);

/// One line for what the mouse points at: the best way of an edge.
[[nodiscard]] std::string short_words(const EntityVerdict& judgement);
/// "Vertex 12 into vertex 13"
[[nodiscard]] std::string way_title(const CollapseWay& way);

/// Colours of previews: what would be there afterwards, and of volumes what would be gone.
[[nodiscard]] constexpr Color ghost_color() { return rgb(0x22d3ee); }
[[nodiscard]] constexpr Color vanishing_color() { return rgb(0x4f7df0); }

/// The new faces of a way, of tetrahedra also those that vanish and the edges that stretch, where
/// its kept vertex would be, and what decided against it.
void draw_preview(const Mesh& mesh, const CollapseWay& way, const glm::dvec3& origin,
                  Overlay& overlay);
/// The two faces that a swap would make; nothing where there are not two.
void draw_preview(const Mesh& mesh, const SwapOutlook& swap, const glm::dvec3& origin,
                  Overlay& overlay);
/// Where smoothing would put a vertex, and the faces around it then.
void draw_preview(const Mesh& mesh, const MoveOutlook& move, const glm::dvec3& origin,
                  Overlay& overlay);

}  // namespace aomd::scene
