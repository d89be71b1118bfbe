#pragma once
// The printed strategy (paper, section 3 and figure 7): sweeps over all edges in the order of their
// ids, swaps and smoothing after the first sweeps, until nothing more collapses. What surfaces and
// volumes have in common; "This algorithm can decimate both volume and surface meshes."

#include <array>

#include "core/decimate/loop.h"

namespace aomd {

class PaperLoop : public Loop {
 public:
  static constexpr const char* name = "the paper's loop";  ///< of its requests

  bool advance() override;
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
  /// For meshes whose highest entities, those that a target counts, have this dimension. T(1,0)
  /// must be stored.
  PaperLoop(Mesh& mesh, const DecimationOptions& options, int dimension);
  /// What the constructor of a derived class ends with.
  void start();
  /// Something around a vertex is about to have changed.
  void touch(Vertex v) { changed_[v] = now_ + 1; }

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
                                               Plan& plan) = 0;
  /// Makes what plan_ holds and touches what is around it. Returns what Operation::entity says.
  virtual EntityRef collapse(Edge edge) = 0;
  /// The same for a swap; invalid where it was refused. For smoothing, whether it was made.
  virtual EntityRef swap(Edge edge) = 0;
  virtual bool smooth(Vertex v) = 0;

 private:
  [[nodiscard]] Verdict judge(Edge edge, std::array<bool, 2> may_go, Plan& plan);
  [[nodiscard]] double first_reach() const;
  bool try_collapse(Edge edge);
  bool try_swap(Edge edge);
  bool try_smooth(Vertex v);
  [[nodiscard]] bool unchanged_since(Edge e) const;
  /// A number of faces or regions is the aim, and the spacing may grow on the way there.
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

  int dimension_;
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
