#pragma once
// The printed strategy on surfaces.

#include <memory>
#include <optional>
#include <vector>

#include "core/decimate/curves/original_curves.h"
#include "core/decimate/paper/paper_loop.h"
#include "core/decimate/paper/surface_edges.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"

namespace aomd {

class SurfacePaperLoop final : public PaperLoop {
 public:
  /// T(0,1), T(0,2) and T(2,0) must be stored; where they are exchanged, T(1,0) and T(2,0). Without
  /// T(0,1) where the mesh lists model edges only: then the loop numbers all edges itself. The
  /// result is the same.
  SurfacePaperLoop(Mesh& mesh, const DecimationOptions& options);
  ~SurfacePaperLoop() override;

  void restart(const DecimationOptions& options) override;
  [[nodiscard]] std::optional<SwapOutlook> swap_outlook(Edge edge) override;
  [[nodiscard]] std::optional<MoveOutlook> move_outlook(Vertex v) override;

 private:
  [[nodiscard]] const IdPool& edges() const override;
  [[nodiscard]] EdgeEnds ends(Edge edge) const override;
  [[nodiscard]] Edge between(Vertex a, Vertex b) const override;
  [[nodiscard]] Edge edge_of(Edge entity) const override;
  [[nodiscard]] Column<Vertex, double> average_lengths() const override;
  void set_rules() override;
  [[nodiscard]] Limits limits(ModelRef edge) const override;
  [[nodiscard]] Verdict judge_collapse(Edge edge, std::array<bool, 2> may_go, const Hand& hand,
                                       Plan& plan) override;
  [[nodiscard]] Verdict judge_curve(const Contraction& contraction) const;
  [[nodiscard]] bool turns_too_far(const CurvePlace& place, const glm::dvec3& x,
                                   double& cosine) const;
  [[nodiscard]] Verdict judge_smoothing(Vertex v, const Hand& hand, Plan& plan);
  [[nodiscard]] Verdict judge_average(Vertex v, const Hand& hand, glm::dvec3& target);
  [[nodiscard]] Verdict judge_swapping(Edge edge, Plan& plan);
  EntityRef collapse(Edge edge, Hand& hand) override;
  EntityRef swap(Edge edge, Hand& hand) override;
  bool smooth(Vertex v, Hand& hand) override;
  bool ready_for(std::size_t hands) override;
  void settle() override;
  void hold(bool collapses);
  /// What one thread needs to judge and to make operations.
  struct Tools {
    explicit Tools(const Mesh& mesh) : collapser(mesh) {}
    Collapser collapser;
    SurfaceEdges::Scratch edges;
  };
  [[nodiscard]] Tools& tools(const Hand& hand) { return *tools_[hand.number]; }

  std::optional<SurfaceEdges> edges_;  ///< where they are no entities
  std::vector<Request> needs_;         ///< of the present phase, where relations are exchanged
  std::optional<bool> collapsing_;     ///< which ones needs_ are for
  bool built_hash_ = false;
  bool wires_ = false;  ///< some edges have no face: T(0,1) alone finds them
  CollapseRules rules_;
  SmoothRules smooth_{TurnLimit(0)};
  std::vector<std::unique_ptr<Tools>> tools_;  ///< by number of hand
  OriginalCurves curves_;
};

}  // namespace aomd
