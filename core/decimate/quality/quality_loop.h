#pragma once
// The quality strategy: collapses in the order of the error they make, the kept vertex placed where
// that error is least, improvement against the original surface, and a second approach to the
// target with the errors measured anew (docs/QUALITY.md has each idea with its source and its
// effect).

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/decimate/curves/original_curves.h"
#include "core/decimate/loop.h"
#include "core/decimate/parts_at_once.h"
#include "core/decimate/quality/collapse_queue.h"
#include "core/decimate/quality/collapse_rounds.h"
#include "core/decimate/quality/original_surface.h"
#include "core/decimate/quality/point_fit.h"
#include "core/parts/partition.h"
#include "core/parts/pass_turns.h"

namespace aomd {

class QualityLoop final : public Loop {
 public:
  static constexpr const char* name = "the quality loop";  ///< of its requests

  /// T(2,0) and T(0,2) must be stored; T(0,1) too unless the edges of the mesh are those on model
  /// edges only.
  QualityLoop(Mesh& mesh, DecimationOptions options);

  bool advance() override;
  bool advance_parts(const std::function<bool()>& cancelled) override;
  void restart(const DecimationOptions& options) override;
  std::uint32_t swap_pass() override;
  std::uint32_t smooth_pass() override;
  [[nodiscard]] Verdict judge(Edge edge, Vertex& deleted) override;
  [[nodiscard]] Verdict judge(Vertex a, Vertex b) override;
  [[nodiscard]] std::vector<CollapseOutlook> outlook(Edge edge) override;
  [[nodiscard]] std::optional<SwapOutlook> swap_outlook(Edge edge) override;
  [[nodiscard]] std::optional<MoveOutlook> move_outlook(Vertex v) override;
  [[nodiscard]] Reason last_refusal(Edge e) const override;
  [[nodiscard]] double spacing(Vertex v) const override;
  [[nodiscard]] double progress() const override;
  [[nodiscard]] OriginalSamples original() override;

 private:
  // Collapses (quality_loop.cpp)
  /// What one thread needs to judge and to make collapses.
  struct Hand : PartHand {
    explicit Hand(const Mesh& mesh) : collapser(mesh) {}
    Collapser collapser;
    Plan plan;
    CollapseQueue::Turn turn;
  };
  bool advance_collapse();
  bool relax();
  /// A candidate that was judged, and what came of it.
  struct Trial {
    CollapseQueue::Candidate candidate;
    Reason reason = Reason::None;
    [[nodiscard]] bool is_of(const CollapseQueue::Candidate& other) const {
      return candidate.contraction.deleted == other.contraction.deleted &&
             candidate.contraction.kept == other.contraction.kept;
    }
  };
  bool try_vertex(Vertex v, Hand& hand);
  bool try_others(Vertex v, const Trial& cheapest, Hand& hand);
  /// None where it was made.
  Reason try_collapse(const CollapseQueue::Candidate& candidate, Hand& hand);
  void collapse(const Contraction& contraction, Hand& hand);
  void refused(const Contraction& contraction, Reason reason, Hand& hand);
  void count(const Contraction& contraction, Hand& hand);
  /// Those that bind a collapse while others have become as dear as they have.
  [[nodiscard]] const CollapseRules& rules_for(const CollapseQueue::Candidate& candidate,
                                               const Hand& hand) const {
    const float level = queue_.level(hand.part);
    if (away_price_ * candidate.cost <= level) return away_rules_;
    return sliver_price_ * candidate.cost <= level ? sliver_rules_ : rules_;
  }
  /// How many times dearer others must be before what was refused may be allowed; 0: it never is.
  [[nodiscard]] float price_after(Reason reason) const {
    const bool yields = rules_.original_normals && !away_rules_.original_normals;
    if (reason == Reason::Shape) return sliver_price_;
    return reason == Reason::Angle && yields ? away_price_ : 0;
  }
  [[nodiscard]] Verdict judge(const Contraction& contraction, const CollapseRules& rules,
                              Collapser& collapser, Plan& plan);

  // Parts at work at the same time (parts_at_once.cpp)
  /// Whether a vertex, or a collapse, is for the part alone: away from the seam, and from model
  /// edges, whose collapses change more than the faces around them.
  [[nodiscard]] bool is_inside(Vertex v) const {
    return !partition_.on_seam(v) && mesh_.classification(v).dimension() == 2;
  }
  [[nodiscard]] bool must_wait(const Contraction& c, const Hand& hand) const {
    return hand.within_part && !(is_inside(c.deleted) && is_inside(c.kept));
  }
  [[nodiscard]] bool parts_are_ready();
  /// One candidate of the hand's part; false where it has none any more.
  bool advance_part(Hand& hand);
  void end_parts();

  // What is said without being done (outlook.cpp)
  /// With what would go where, and at what cost: infinite where it is out of the question.
  [[nodiscard]] Verdict judge(Edge edge, CollapseQueue::Candidate& candidate);
  [[nodiscard]] Verdict judge(Vertex a, Vertex b, CollapseQueue::Candidate& candidate);
  [[nodiscard]] Limits limits(const TurnLimit& turn, double least_angle_deg) const;

  // Stages (stages.cpp)
  void start(const DecimationOptions& options);
  void begin_stage();
  void locate();
  void measure_energy();
  void begin_improvement();
  void enter(Phase phase);
  void end_phase();
  void end_round();
  [[nodiscard]] bool last_stage() const { return stage_ + 1 == goals_.size(); }
  [[nodiscard]] int rounds() const { return last_stage() ? 3 : 1; }
  void set_goals();
  void set_rules();
  [[nodiscard]] CostRules cost_rules() const;
  void fill_spacing();

  // Passes of swaps and of smoothing (improvement.cpp)
  /// Part of a pass of swaps: its edges are judged ahead, on all threads, and then have their turn
  /// one by one.
  struct SwapBatch {
    std::vector<Face> faces;
    /// By face and corner: the face across the edge from there, where swapping the two was refused
    /// for what they are.
    std::vector<std::array<Face, 3>> refused;
    std::size_t turn = 0;      ///< the face that is next
    std::uint32_t corner = 0;  ///< of that face
    std::uint32_t after = 0;   ///< where the next batch begins
  };
  bool next_swap(SwapBatch& batch, bool& made);
  bool fill(SwapBatch& batch);
  void judge_ahead(SwapBatch& batch) const;
  [[nodiscard]] Face refused_across(Vertex a, Vertex b) const;
  [[nodiscard]] bool still_refused(const SwapBatch& batch) const;
  std::uint32_t pass_done(std::uint32_t made);
  bool advance_swap();
  bool advance_smooth();
  /// The same where there are several parts.
  bool advance_swap_in_turn();
  bool advance_smooth_in_turn();
  bool swap_across(Face f, std::uint32_t corner, Hand& hand);
  bool try_swap(Vertex a, Vertex b, Hand& hand);
  bool try_smooth(Vertex v, Hand& hand);

  bool from_samples_;  ///< the original's points were given: the mesh stands for it already
  OriginalSurface original_;
  OriginalCurves curves_;
  std::unique_ptr<AttributeFit> values_;  ///< null: the shape alone counts
  Fitter fitter_;
  CollapseRules rules_;
  CollapseRules sliver_rules_;  ///< what binds a collapse that may leave a sliver
  CollapseRules away_rules_;    ///< and one that may make a face look away from the original too
  FitRules fit_;
  /// How many times dearer others must be before one is made; the second is not the lower one.
  float sliver_price_ = 1, away_price_ = 1;
  std::size_t part_count_ = 1;
  Partition partition_;  ///< for the present stage
  CollapseQueue queue_;
  CollapseRounds<CollapseQueue> rounds_;
  Hand alone_;                 ///< of who works alone
  PartsAtOnce<Hand> at_once_;  ///< and of those who work at the same time
  Column<Edge, Reason> refusal_;

  std::vector<std::uint32_t>
      goals_;  ///< faces at which each stage ends; 0: when nothing more collapses
  std::size_t stage_ = 0;
  Column<Vertex, double>
      average_length_;  ///< of the edges at a vertex, at the start; empty until it is asked for
  int round_ = 0;
  std::uint32_t start_faces_ = 0;

  std::uint32_t cursor_ = 0;             ///< of a pass of smoothing
  SwapBatch swaps_;                      ///< of a pass of swaps
  PassTurns turns_;                      ///< of either pass, where there are several parts
  Face face_;                            ///< whose edges have their turn there
  std::uint32_t corner_ = 0;             ///< of that face
  Column<Face, std::uint32_t> swapped_;  ///< == swap_stamp_: since the last batch was judged
  std::uint32_t swap_stamp_ = 0;
};

}  // namespace aomd
