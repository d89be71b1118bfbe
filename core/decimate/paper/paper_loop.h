#pragma once
// The printed strategy (paper, section 3 and figure 7): sweeps over all edges in the order of their
// ids, swaps and smoothing after the first sweeps, until nothing more collapses.

#include <array>

#include "core/decimate/loop.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"

namespace aomd {

class PaperLoop final : public Loop {
 public:
  static constexpr const char* name = "the paper's loop";  ///< of its requests

  /// T(0,1), T(0,2) and T(2,0) must be stored; where they are exchanged, T(1,0) and T(2,0).
  PaperLoop(Mesh& mesh, const DecimationOptions& options);
  ~PaperLoop() override;

  bool advance() override;
  void restart(const DecimationOptions& options) override;
  std::uint32_t swap_pass() override;
  std::uint32_t smooth_pass() override;
  [[nodiscard]] Verdict judge(Edge edge, Vertex& deleted) override;
  [[nodiscard]] Verdict judge(Vertex a, Vertex b) override;
  [[nodiscard]] std::vector<CollapseOutlook> outlook(Edge edge) override;
  [[nodiscard]] std::optional<SwapOutlook> swap_outlook(Edge edge) override;
  [[nodiscard]] std::optional<MoveOutlook> move_outlook(Vertex v) override;
  [[nodiscard]] Reason last_refusal(Edge e) const override {
    return e.index < refusal_.size() ? refusal_[e] : Reason::None;
  }
  [[nodiscard]] double spacing(Vertex v) const override;
  [[nodiscard]] double progress() const override;

 private:
  void set_rules();
  [[nodiscard]] Limits limits(ModelRef edge) const;
  [[nodiscard]] Verdict judge(Edge edge, std::array<bool, 2> may_go, Plan& plan);
  [[nodiscard]] Verdict judge_smoothing(Vertex v, Plan& plan);
  [[nodiscard]] Verdict judge_swapping(Edge edge, Plan& plan);
  [[nodiscard]] double first_reach() const;
  void hold(bool collapses);
  void fill_spacing();
  bool try_collapse(Edge edge);
  bool try_swap(Edge edge);
  bool try_smooth(Vertex v);
  void touch(Vertex v) { changed_[v] = now_; }
  [[nodiscard]] bool unchanged_since(Edge e) const;
  /// A number of faces is the aim, and the spacing may grow on the way there.
  [[nodiscard]] bool aims() const {
    return options_.target_faces > 0 && !options_.coarsest && !options_.spacing;
  }
  [[nodiscard]] bool at_target() const;
  void forget();
  void begin_sweep();
  void end_sweep();
  bool grow();
  [[nodiscard]] double needed_reach() const;
  void next_phase();
  [[nodiscard]] std::uint32_t end_of_phase() const;

  std::vector<Request> needs_;      ///< of the present phase, where relations are exchanged
  std::optional<bool> collapsing_;  ///< which ones needs_ are for
  bool built_hash_ = false;
  bool wires_ = false;  ///< some edges have no face: T(0,1) alone finds them
  CollapseRules rules_;
  SmoothRules smooth_{TurnLimit(0)};
  Collapser collapser_;
  Column<Vertex, double> average_length_;  ///< of the edges at a vertex, at the start
  double reach_ = 1;  ///< how many times longer edges become; grows towards a target
  Column<Vertex, std::uint32_t>
      changed_;  ///< value of now_ when the vertex's surroundings last changed
  Column<Edge, std::uint32_t> judged_;  ///< value of now_ when the edge was last refused
  Column<Edge, Reason> refusal_;
  std::uint32_t now_ = 1;
  std::uint32_t cursor_ = 0;
  int improved_ = 0;
};

}  // namespace aomd
