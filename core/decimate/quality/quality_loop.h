#pragma once
// The quality strategy: collapses in the order of the error they make, the kept vertex placed where
// that error is least, improvement against the original surface, and a second approach to the
// target with the errors measured anew (docs/QUALITY.md has each idea with its source and its
// effect).

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/decimate/loop.h"
#include "core/decimate/quality/original_surface.h"
#include "core/decimate/quality/point_fit.h"
#include "core/decimate/quality/quadric.h"
#include "core/decimate/quality/vertex_queue.h"

namespace aomd {

class QualityLoop final : public Loop {
 public:
  static constexpr const char* name = "the quality loop";  ///< of its requests

  /// T(2,0) and T(0,2) must be stored; T(0,1) too unless the edges of the mesh are those on model
  /// edges only.
  QualityLoop(Mesh& mesh, const DecimationOptions& options);

  bool advance() override;
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

 private:
  /// An edge that could collapse: what would go where, and at what cost.
  struct Candidate {
    Contraction contraction;
    float cost = 0;
  };

  static constexpr float unlimited = std::numeric_limits<float>::infinity();
  static constexpr std::size_t vertices_a_piece = 2048;  ///< where threads share them out
  /// What the strategy knows of a vertex; one cache line, because looking at neighbours waits for
  /// memory.
  struct alignas(64) State {
    LocalQuadric quadric;      ///< about the vertex
    ModelRef model;            ///< what the vertex lies on
    float area = 0;            ///< of the surface that it took in
    float reach = 0;           ///< edges shorter than it may go
    Vertex partner;            ///< the other end of its cheapest candidate; invalid: not known
    float cost = unlimited;    ///< of that; where not known, a bound from below
    float second = unlimited;  ///< a bound from below for all its others
  };

  // Collapses (quality_loop.cpp)
  bool advance_collapse();
  template <typename Visit>
  void look_around(Vertex v, Star& star, Visit&& visit) const;
  void find_candidates(Vertex v);
  [[nodiscard]] bool may_collapse(Vertex v, Vertex w, double length2) const;
  enum class Freedom { None, OntoFirst, OntoSecond, Any };
  [[nodiscard]] Freedom freedom_of(Vertex v, Vertex w) const;
  [[nodiscard]] float cost(Vertex v, Vertex w, Contraction& contraction) const;
  bool relax();
  bool try_others(Vertex v);
  bool collapse(const Contraction& contraction);
  static void offer(State& state, Vertex partner, float cost);
  void update(Vertex v, Vertex kept, float cost);
  void dequeue(Vertex v);
  void refresh_around(Vertex kept);
  void forget_lost_edges(const CollapsePlan& made);
  void fill_queue();
  [[nodiscard]] Verdict judge(const Contraction& contraction, Plan& plan);

  // What is said without being done (quality_outlook.cpp)
  /// With what would go where, and at what cost: infinite where it is out of the question.
  [[nodiscard]] Verdict judge(Edge edge, Candidate& candidate);
  [[nodiscard]] Verdict judge(Vertex a, Vertex b, Candidate& candidate);
  [[nodiscard]] Limits limits(const TurnLimit& turn, double least_angle_deg) const;

  // Stages (quality_stages.cpp)
  void start(const DecimationOptions& options);
  void begin_stage();
  void measure_vertices(bool by_points);
  void measure_energy();
  void begin_improvement();
  void enter(Phase phase);
  void end_phase();
  void end_round();
  [[nodiscard]] bool last_stage() const { return stage_ + 1 == goals_.size(); }
  [[nodiscard]] int rounds() const { return last_stage() ? 3 : 1; }
  void set_goals();
  void set_rules();
  void fill_spacing();

  // Passes of swaps and of smoothing (quality_improvement.cpp)
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
  bool try_swap(Vertex a, Vertex b);
  bool try_smooth(Vertex v);

  // Quadrics (quality_quadrics.cpp)
  void add_normal(Vertex v, const glm::vec3& normal);
  void quadric_of_faces(Vertex v);
  void quadrics_of_points();
  void quadrics_of_model_edges();

  OriginalSurface original_;
  Collapser collapser_;
  Fitter fitter_;
  CollapseRules rules_;
  FitRules fit_;
  float edge_weight_ = 0;  ///< what a squared edge length costs, by the area it stands for
  float scale_ = 1;        ///< makes costs independent of the mesh's units
  bool cubes_ = true, places_ = true;  ///< the ideas of these names are in force
  double unit_area_ = 1;               ///< areas are counted in it: numbers stay near 1

  Column<Vertex, State> state_;
  /// Of the original faces that a vertex took in, times their areas; 0 on model edges.
  Column<Vertex, glm::vec3> normal_;
  VertexQueue queue_;
  std::vector<Candidate> found_;  ///< scratch: the candidates at one vertex, cheapest first
  Star star_;
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
  Column<Face, std::uint32_t> swapped_;  ///< == swap_stamp_: since the last batch was judged
  std::uint32_t swap_stamp_ = 0;
};

}  // namespace aomd
