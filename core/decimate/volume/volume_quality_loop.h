#pragma once
// The quality strategy for volumes of tetrahedra: one queue for model faces and what lies between
// them, the kept vertex placed where no region's volume changes, and tetrahedra that are improved
// whenever collapses alone lead no further (docs/VOLUMES.md).

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/decimate/loop.h"
#include "core/decimate/parts_at_once.h"
#include "core/decimate/quadric.h"
#include "core/decimate/quality/cheapest.h"
#include "core/decimate/quality/collapse_rounds.h"
#include "core/decimate/quality/vertex_queue.h"
#include "core/decimate/volume/improvement.h"
#include "core/decimate/volume/region_balance.h"
#include "core/decimate/volume/vertex_relaxation.h"
#include "core/decimate/volume/volume_placement.h"
#include "core/operators/region_collapse.h"
#include "core/parts/partition.h"
#include "core/parts/pass_turns.h"

namespace aomd {

class VolumeQualityLoop final : public Loop, private ImprovementWatch {
 public:
  static constexpr const char* name = "the quality loop";  ///< of its requests

  /// T(3,0), T(0,3), T(2,0), T(0,2) and T(0,1) must be stored, as listed or complete.
  VolumeQualityLoop(Mesh& mesh, const DecimationOptions& options);

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

 private:
  static constexpr float unlimited = Cheapest::unlimited;
  static constexpr std::size_t vertices_a_piece = 1024;  ///< where threads share them out

  /// What the strategy knows of a vertex; one cache line, because looking at neighbours waits for
  /// memory.
  struct alignas(64) State : Cheapest {
    LocalQuadric quadric;  ///< about the vertex, in units; 0 inside regions
    ModelRef model;        ///< what the vertex lies on
    float size = 0;        ///< the mean length of the edges here, at the start, in units
    float reach = 0;       ///< edges shorter than it may go, in units
  };
  struct Candidate {
    Vertex other;
    float cost = 0;
  };
  /// A way to collapse an edge, and what it costs the surface.
  struct Place {
    Contraction contraction;
    float cost = 0;
  };
  /// What a judgement needs, so that nothing is allocated for it.
  struct Scratch {
    std::array<Ball, 2> balls;
    Star star;
    std::vector<Vertex> neighbours;
    LocalQuadric quadric;  ///< in units
    ModelPlanes planes;
    RegionBalance balance;
    std::vector<Place> places;
    VertexRelaxation relaxation;
  };
  /// What one thread needs to judge and to make collapses and moves.
  struct Hand : PartHand {
    explicit Hand(const Mesh& mesh) : collapser(mesh) {}
    RegionCollapser collapser;
    Scratch scratch;
    Plan plan;
    std::vector<Candidate> found;
    bool waits = false;  ///< something costs more than patience allows
  };

  // Single precision holds the fourth power of a length only where it is near 1: what it holds is
  // in units that edges are about as long as.
  [[nodiscard]] glm::vec3 in_units(const glm::dvec3& x) const { return glm::vec3(unit_ * x); }
  [[nodiscard]] double size_of(Vertex v) const { return double(state_[v].size) / unit_; }
  [[nodiscard]] double reach_of(Vertex v) const { return double(state_[v].reach) / unit_; }
  [[nodiscard]] Quadric of_positions(const LocalQuadric& quadric) const {
    return Quadric(quadric).stretched(unit_);
  }

  // The queue (volume_queue.cpp)
  [[nodiscard]] std::span<const Vertex> neighbours_of(Vertex v, Scratch& scratch) const;
  template <typename Visit>
  void look_around(Vertex v, Scratch& scratch, Visit&& visit) const;
  [[nodiscard]] float cost(Vertex v, Vertex w) const;
  [[nodiscard]] bool may_collapse(Vertex v, Vertex w, float length2) const;
  void update(Vertex v, Vertex kept, float cost);
  void dequeue(Vertex v);
  void refresh_around(Vertex kept, Hand& hand);
  void fill_queue();
  void put(Vertex v, float cost) { queue_.put(v, cost, partition_.part_of(v)); }
  [[nodiscard]] bool is_there(Vertex partner, Vertex of) const;
  bool advance_collapse();
  bool advance_collapse_in_turn();
  bool try_vertex(Vertex v, Hand& hand);
  bool try_others(Vertex v, Hand& hand);
  void find_candidates(Vertex v, Hand& hand);
  void know(Vertex v, std::size_t i, const Hand& hand);

  // Contractions (volume_contraction.cpp)
  enum class Freedom { None, OntoFirst, OntoSecond, Any };
  [[nodiscard]] Freedom freedom_of(Vertex v, Vertex w) const;
  [[nodiscard]] float surface_cost(const LocalQuadric& quadric, const glm::vec3& x,
                                   float size2) const;
  void find_places(Vertex v, Vertex w, Scratch& scratch) const;
  void places_inside(Vertex v, Vertex w, Scratch& scratch) const;
  void places_on_model(Vertex v, Vertex w, Scratch& scratch) const;
  void add_place(const Contraction& c, Scratch& scratch) const;
  void places_along(Vertex v, Vertex w, Scratch& scratch) const;
  void places_between(Vertex v, Vertex w, Scratch& scratch) const;
  void find_planes(Vertex v, Vertex w, Scratch& scratch) const;
  [[nodiscard]] bool straight_curve(Vertex v, Vertex w, Star& star) const;
  [[nodiscard]] double worst_shape(const Contraction& c, const Scratch& scratch,
                                   double enough) const;
  void keep_best_shape(Scratch& scratch) const;
  [[nodiscard]] static float worst_cost(float best);
  [[nodiscard]] Verdict judge(Vertex v, Vertex w, Scratch& scratch, Plan& plan,
                              RegionCollapser& collapser);
  bool collapse(Vertex v, Vertex w, Hand& hand);
  void note_refusal(Vertex v, Vertex w, const Verdict& verdict, Hand& hand);
  void take_over(const Contraction& c, const glm::dvec3& origin, const Scratch& scratch);
  void count(const Contraction& c, Hand& hand);

  // What is said without being done (volume_outlook.cpp)
  [[nodiscard]] Verdict judge_edge(Vertex a, Vertex b, Scratch& scratch, Plan& plan);
  [[nodiscard]] Limits limits() const;

  // Stages (volume_stages.cpp)
  void start(const DecimationOptions& options);
  [[nodiscard]] double stretch() const;
  void set_rules();
  void limit_dihedrals(double deg);
  void find_unit();
  void measure_vertices();
  void measure(Vertex v, Scratch& scratch);
  void quadric_of_faces(Vertex v, Star& star);
  void quadrics_of_model_edges();
  void begin_descent();
  void begin_improvement();
  void enter(Phase phase);
  void end_phase();
  void end_round();
  void end_settling();
  bool relax();
  [[nodiscard]] int rounds() const;
  /// False where other shapes than tetrahedra are around a vertex, or nothing: it stays.
  [[nodiscard]] bool among_tets(Vertex v) const { return state_[v].size > 0; }
  [[nodiscard]] bool reached() const { return target_ > 0 && mesh_.count(3) <= goal_; }
  [[nodiscard]] bool last_descent() const;
  void lose_patience();

  // Passes over tetrahedra and vertices (volume_passes.cpp)
  bool advance_swap();
  bool advance_smooth();
  [[nodiscard]] bool looks_at(Region poor) override;
  [[nodiscard]] bool allows(const EdgeRemoval& plan) override;
  [[nodiscard]] bool allows(const FaceRemoval& plan) override;
  void made(const EdgeRemoval& plan) override;
  void made(const FaceRemoval& plan) override;
  void stir(Vertex v) { stir_[v] = stir_now_; }
  [[nodiscard]] Verdict judge_removal(const EdgeRemoval& plan, Change& change);
  [[nodiscard]] double diagonals_apart(const EdgeRing& ring) const;
  [[nodiscard]] bool keeps_close(const EdgeRing& ring) const;
  bool smooth_in_turn(Vertex v, Hand& hand);
  bool try_move(Vertex v, Hand& hand);
  [[nodiscard]] Verdict judge_move(Vertex v, const glm::dvec3& x, const Scratch& scratch,
                                   Change& change);
  bool move(Vertex v, const glm::dvec3& x, Hand& hand);
  void begin_relaxation(Vertex v, Scratch& scratch) const;
  bool find_target(Vertex v, Scratch& scratch, glm::dvec3& x);
  bool end_on_model(Vertex v, const VertexRelaxation& relaxation, glm::dvec3& x);
  bool fix_ways(Vertex v, Scratch& scratch, FixedDirections& fixed, glm::dvec3& x);
  [[nodiscard]] bool tangent(Vertex v, const Star& star, glm::dvec3& along) const;
  [[nodiscard]] bool keeps_faces(Vertex v, const Star& star, const glm::dvec3& to) const;
  std::uint32_t pass_done(std::uint32_t made);

  // Parts at work at the same time (volume_parts.cpp)
  /// Whether a vertex, or a collapse, is for the part alone: away from the seam, and from the
  /// model, where volumes are owed.
  [[nodiscard]] bool is_inside(Vertex v) const {
    return !partition_.on_seam(v) && state_[v].model.dimension() == 3;
  }
  [[nodiscard]] bool must_wait(Vertex v, Vertex w, const Hand& hand) const {
    return hand.within_part && !(is_inside(v) && is_inside(w));
  }
  [[nodiscard]] std::size_t parts_now() const;
  [[nodiscard]] bool parts_are_ready();
  void end_parts();
  /// One candidate of the hand's part; false where it has none any more.
  bool advance_part(Hand& hand);

  // Debts (volume_settling.cpp)
  void limit_debts();
  [[nodiscard]] Verdict judge_debt(Region in, double change) const;
  [[nodiscard]] Verdict judge_debts(const glm::dvec3& x, const Scratch& scratch) const;
  [[nodiscard]] Verdict judge_debts(const EdgeRemoval& plan) const;
  void note_gains(const EdgeRemoval& plan);
  void draw_debts(Vertex v, const Scratch& scratch);
  bool settle(Vertex v);
  [[nodiscard]] bool owes(Vertex v) const;
  void spread(Vertex v);

  static constexpr double curve_weight = 3;  ///< of the planes along model edges
  /// By how much regions may change where nobody can pay.
  static constexpr double most_owed = 1e-3;
  /// Debts are paid by moving by this part of a size, or of an edge, at a time.
  static constexpr double paid_at_once = 0.03;

  VolumeRules rules_;
  ImprovementRules improving_;
  VolumeImprovement improvement_;
  double unit_ = 1;       ///< lengths times it are in units; a power of two, which rounds nothing
  double floor_ = 0.3;    ///< no tetrahedron gets a poorer shape, if it can be helped
  float surface_ = 0;     ///< what squared distances cost collapses, in sizes
  double hold_ = 0;       ///< the same of moves
  float patience_ = 0;    ///< collapses that cost more wait until improvement helps no cheaper one
  bool waiting_ = false;  ///< the last descent ended before some of those
  Column<Vertex, State> state_;
  Column<Vertex, double> size_;  ///< the mean length of the edges at a vertex, at the start
  Partition partition_;          ///< for the present descent
  VertexQueue queue_;
  // More tetrahedra than go with a collapse are not to be missed at the target.
  CollapseRounds<VertexQueue> rounds_{mesh_, queue_, {.dimension = 3, .most_each = 32}};
  VolumeDebts debts_;
  double reach_of_payment_ = 0;  ///< how far a vertex goes for debts at a time, by its size
  Hand alone_;                   ///< of who works alone
  PartsAtOnce<Hand> at_once_;    ///< and of those who work at the same time
  std::size_t part_count_ = 1;   ///< in the present phase
  PassTurns turns_;              ///< of a pass of moves in several parts
  Change allowed_;               ///< by the removal that is to be made
  Column<Edge, Reason> refusal_;
  Column<Vertex, std::uint32_t> stir_;  ///< the pass in which something around changed last
  std::uint32_t stir_now_ = 0, stir_limit_ = 0;

  std::uint32_t target_ = 0, goal_ = 0;
  std::uint32_t start_regions_ = 0;
  int round_ = 0;     ///< of improvement, since the last descent
  int settling_ = 0;  ///< passes in which debts are paid, at the end
  int descents_ = 0;
  std::uint32_t before_descent_ = 0, freed_ = 0;
  std::uint32_t cursor_ = 0;  ///< of a pass
};

}  // namespace aomd
