#pragma once
// The printed strategy (paper, section 3 and figure 7): sweeps over all edges in the order of their
// ids, swaps and smoothing after the first sweeps, until nothing more collapses. What surfaces and
// volumes have in common; "This algorithm can decimate both volume and surface meshes." A large
// surface goes through its sweeps in parts (docs/PARTS.md).

#include <array>
#include <functional>

#include "core/decimate/loop.h"
#include "core/decimate/parts_at_once.h"
#include "core/parts/pass_turns.h"

namespace aomd {

class PaperLoop : public Loop {
 public:
  static constexpr const char* name = "the paper's loop";  ///< of its requests

  bool advance() override;
  bool advance_parts(const std::function<bool()>& cancelled) override;
  void restart(const DecimationOptions& options) override;
  std::uint32_t swap_pass() override;
  std::uint32_t smooth_pass() override;
  [[nodiscard]] Verdict judge(Edge edge, Vertex& deleted) override;
  [[nodiscard]] Verdict judge(Vertex a, Vertex b) override;
  [[nodiscard]] std::vector<CollapseOutlook> outlook(Edge entity) override;
  [[nodiscard]] Reason last_refusal(Edge e) const override;
  [[nodiscard]] double spacing(Vertex v) const override;
  [[nodiscard]] double progress() const override;

 protected:
  /// What one thread needs beside what a derived class keeps for each.
  struct Hand : PartHand {
    explicit Hand(std::size_t n) : number(n) {}
    std::size_t number;  ///< 0: of who works alone
    Plan plan;           ///< of the operation that is judged to be made; who only looks has another
    std::uint32_t now = 1;  ///< goes up with each operation
  };

  /// For meshes whose highest entities, those that a target counts, have this dimension. T(1,0)
  /// must be stored.
  PaperLoop(Mesh& mesh, const DecimationOptions& options, int dimension);
  /// What the constructor of a derived class ends with.
  void start();
  [[nodiscard]] const Hand& alone() const { return alone_; }
  /// Something around a vertex is about to have changed.
  void touch(Vertex v, const Hand& hand) { changed_[v] = hand.now + 1; }

  // The edges that are gone over: entities, unless a derived class numbers them itself
  [[nodiscard]] virtual const IdPool& edges() const { return mesh_.ids(1); }
  [[nodiscard]] virtual EdgeEnds ends(Edge edge) const { return mesh_.edge_vertices(edge); }
  [[nodiscard]] virtual Edge between(Vertex a, Vertex b) const { return mesh_.find_edge(a, b); }
  /// The one that is this entity, which is what those who look from outside name.
  [[nodiscard]] virtual Edge edge_of(Edge entity) const { return entity; }
  /// The mean length of the edges at each vertex.
  [[nodiscard]] virtual Column<Vertex, double> average_lengths() const;

  // What an operation is, by derived class
  virtual void set_rules() = 0;
  [[nodiscard]] virtual Limits limits(ModelRef edge) const = 0;
  /// Where length allows it: the operator's and the guards' say on deleting one of these ends.
  [[nodiscard]] virtual Verdict judge_collapse(Edge edge, std::array<bool, 2> may_go,
                                               const Hand& hand, Plan& plan) = 0;
  /// Makes what the hand's plan holds and touches what is around it. Returns what
  /// Operation::entity says.
  virtual EntityRef collapse(Edge edge, Hand& hand) = 0;
  /// The same for a swap; invalid where it was refused. For smoothing, whether it was made.
  virtual EntityRef swap(Edge edge, Hand& hand) = 0;
  virtual bool smooth(Vertex v, Hand& hand) = 0;

  // Where several threads work at the same time
  /// Whether what a derived class keeps can follow that; if so, it is ready for so many hands.
  virtual bool ready_for(std::size_t hands) { return (void)hands, false; }
  /// They are done.
  virtual void settle() {}
  /// A part leaves an edge to who comes after.
  void leave(Edge edge, const Hand& hand) { turns_.leave(hand.part, edge.index); }

 private:
  [[nodiscard]] Verdict judge(Edge edge, std::array<bool, 2> may_go, const Hand& hand, Plan& plan);
  [[nodiscard]] double first_reach() const;
  bool try_collapse(Edge edge, Hand& hand);
  bool try_swap(Edge edge, Hand& hand);
  bool try_smooth(Vertex v, Hand& hand);
  void refused(Reason reason, Hand& hand);
  void made_by(Hand& hand, StepKind kind, EntityRef entity);
  [[nodiscard]] bool unchanged_since(Edge e) const;
  [[nodiscard]] bool must_wait(Edge edge) const;
  /// A number of faces or regions is the aim, and the spacing may grow on the way there.
  [[nodiscard]] bool aims() const {
    return options_.target_faces > 0 && !options_.coarsest && !options_.spacing;
  }
  [[nodiscard]] bool at_target() const;
  [[nodiscard]] bool has_gone(Edge edge) const {
    return !edges().alive(edge.index) || !ends(edge)[0].valid();
  }
  void begin();
  [[nodiscard]] std::size_t parts() const;
  void forget();
  void begin_sweep();
  void enter(Phase phase);
  void begin_turns();
  std::uint32_t next();
  bool try_one(std::uint32_t id, Hand& hand);
  bool advance_part(Hand& hand);
  void agree_on_now();
  void end_sweep();
  bool grow();
  [[nodiscard]] double needed_reach() const;
  void next_phase();
  [[nodiscard]] std::uint32_t end_of_phase() const;

  int dimension_;
  Column<Vertex, double> average_length_;  ///< of the edges at a vertex, at the start
  double reach_ = 1;  ///< how many times longer edges become; grows towards a target
  // Where parts work at the same time, each of these belongs to one part.
  Column<Vertex, std::uint32_t>
      changed_;  ///< value of Hand::now when the vertex's surroundings last changed
  Column<Edge, std::uint32_t> judged_;  ///< value of Hand::now when the edge was last refused
  Column<Edge, Reason> refusal_;
  Hand alone_{0};
  int improved_ = 0;

  std::uint32_t cursor_ = 0;    ///< of a phase of a mesh that is one part
  std::size_t part_count_ = 1;  ///< of a surface
  bool in_parts_ = false;       ///< the present phase goes by turns_
  bool many_ = true;            ///< edges may have another verdict than before
  PassTurns turns_;
  PartsAtOnce<Hand> at_once_;
};

}  // namespace aomd
