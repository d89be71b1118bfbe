#pragma once
// The printed strategy among tetrahedra: E_3Dcollapse_ in the place of E_2Dcollapse_, edges removed
// in the place of swaps.

#include <optional>

#include "core/decimate/paper/paper_loop.h"

namespace aomd {

class VolumePaperLoop final : public PaperLoop {
 public:
  /// T(1,0), T(0,1), T(0,3), T(3,0), T(2,0) and T(0,2) must be stored, faces as listed or complete.
  /// Vertices of regions that are no tetrahedra stay.
  VolumePaperLoop(Mesh& mesh, const DecimationOptions& options);

  [[nodiscard]] std::optional<SwapOutlook> swap_outlook(Edge edge) override;
  [[nodiscard]] std::optional<MoveOutlook> move_outlook(Vertex v) override;

 private:
  void set_rules() override;
  [[nodiscard]] Limits limits(ModelRef edge) const override;
  [[nodiscard]] Verdict judge_collapse(Edge edge, std::array<bool, 2> may_go, const Hand& hand,
                                       Plan& plan) override;
  [[nodiscard]] Verdict judge_removing(Edge edge, Plan& plan);
  [[nodiscard]] Verdict judge_moving(Vertex v, Plan& plan);
  EntityRef collapse(Edge edge, Hand& hand) override;
  EntityRef swap(Edge edge, Hand& hand) override;
  bool smooth(Vertex v, Hand& hand) override;

  VolumeRules rules_;
  RemovalRules removal_;
  MoveRules moves_;
  RegionCollapser collapser_;
  RegionMover mover_;
};

}  // namespace aomd
