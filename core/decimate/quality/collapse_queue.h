#pragma once
// Which collapse is next: what each vertex stands for, what the collapses of its edges cost, and
// the vertices in the order of the cheapest of these.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/decimate/curves/original_curves.h"
#include "core/decimate/options.h"
#include "core/decimate/quadric.h"
#include "core/decimate/quality/attribute_quadrics.h"
#include "core/decimate/quality/cheapest.h"
#include "core/decimate/quality/edge_cost.h"
#include "core/decimate/quality/original_surface.h"
#include "core/decimate/quality/original_values.h"
#include "core/decimate/quality/vertex_queue.h"
#include "core/mesh/column.h"
#include "core/operators/collapse.h"
#include "core/operators/star.h"
#include "core/parts/partition.h"

namespace aomd {

/// Judges nothing but costs: whether a collapse is allowed is for others to say. All that it refers
/// to must outlive it; T(2,0) and T(0,2) must be stored. Each part has a queue of its vertices.
/// Several threads may take vertices of different parts at once, each with a Turn of its own, as
/// long as none looks at a vertex of another part.
class CollapseQueue {
 public:
  static constexpr float unlimited = Cheapest::unlimited;
  /// An edge that could collapse: what would go where, and at what cost.
  struct Candidate {
    Contraction contraction;
    float cost = 0;
  };

  /// What a thread knows of the vertex that it has taken.
  struct Turn {
    std::vector<Candidate> found;  ///< all its candidates
    float known = 0;               ///< the cost by which it stood in the queue
    Star star;                     ///< scratch
  };

  CollapseQueue(const Mesh& mesh, const OriginalSurface& original, const OriginalCurves& curves,
                const DecimationOptions& options, const Partition& parts)
      : mesh_(mesh), original_(original), curves_(curves), options_(options), parts_(parts) {}
  /// From the next measure() on these numbers count too. They must outlive it.
  void count(const OriginalValues& values) { values_ = &values; }

  /// Knows nothing of any vertex any more.
  void reset(const CostRules& rules);
  /// Edges shorter than the reach of one of their ends may go; 0 where none was set.
  void set_reach(Vertex v, float reach) { state_[v].reach = reach; }
  [[nodiscard]] float reach(Vertex v) const {
    return v.index < state_.size() ? state_[v].reach : 0.0f;
  }
  /// What each vertex stands for: by the faces around it, or by the points of the original that lie
  /// on them now. Fills the queue. O(n log n).
  void measure(bool by_points);
  /// Fills the queue anew.
  void refill();
  /// Of the original faces that a vertex took in, times their areas; 0 on model edges.
  [[nodiscard]] const Column<Vertex, glm::vec3>& normals() const { return normal_; }

  /// What the collapse of an edge costs, and which end goes where; infinite where it is out of the
  /// question.
  [[nodiscard]] float cost(Vertex v, Vertex w, Contraction& contraction) const;

  /// The vertex of a part whose cheapest candidate is next, which leaves; an invalid one when there
  /// is none up to a bucket.
  [[nodiscard]] Vertex pop(std::size_t part = 0, std::uint32_t last = VertexQueue::no_bucket);
  /// The highest cost at which a vertex of a part has left since the queue was filled.
  [[nodiscard]] float level(std::size_t part) const { return levels_[part]; }
  /// The level of all parts becomes that of the highest.
  void even_out_levels();
  /// The lowest bucket of a part, VertexQueue::no_bucket where it is empty.
  [[nodiscard]] std::uint32_t lowest(std::size_t part) { return order_.lowest(part); }
  /// How many vertices of a part wait in these buckets, the last one included.
  [[nodiscard]] std::uint64_t waiting(std::size_t part, std::uint32_t first,
                                      std::uint32_t last) const {
    return order_.waiting(part, first, last);
  }
  /// The next to leave a part is of its lowest bucket.
  void leave_bucket(std::size_t part) { order_.leave_bucket(part); }
  /// Whether a vertex waits for its turn.
  [[nodiscard]] bool holds(Vertex v) const { return order_.holds(v); }
  /// Its cheapest candidate, where that is known and still possible.
  [[nodiscard]] bool cheapest(Vertex v, Candidate& candidate) const;
  /// Finds all candidates of a vertex, cheapest first. The vertex leaves.
  void take_all(Vertex v, Turn& turn);
  /// Whether the i-th of those has become so dear that others come first: then the vertex is back
  /// in the queue with it. `bound` is one from below for what those before it cost now.
  [[nodiscard]] bool put_off(Vertex v, std::size_t i, float bound, const Turn& turn);
  /// The vertex is known by the i-th of those again, though it stays out of the queue.
  void remember(Vertex v, std::size_t i, float bound, const Turn& turn);
  /// A vertex that has left comes back when the level is as high as this.
  void wait(Vertex v, float cost);

  /// A collapse is about to be made: the kept vertex takes in what the other one stands for.
  void merge(const Contraction& contraction);
  /// It has been made: what the edges of the kept vertex cost now.
  void refresh_around(const Contraction& made, Turn& turn);
  /// Without the link condition a third vertex of the faces that went may have no face with the
  /// kept one any more: then their edge is no candidate.
  void forget_lost_edges(const CollapsePlan& made, Turn& turn);

 private:
  static constexpr std::size_t vertices_a_piece = 2048;  ///< where threads share them out
  /// What is known of a vertex; one cache line, because looking at neighbours waits for memory.
  struct alignas(64) State : Cheapest {
    LocalQuadric quadric;  ///< about the vertex
    ModelRef model;        ///< what the vertex lies on
    float area = 0;        ///< of the surface that it took in
    float reach = 0;       ///< edges shorter than it may go
  };
  enum class Freedom { None, OntoFirst, OntoSecond, Any };

  using FourCosts = std::array<float, Lanes::count>;
  using FourStates = std::array<const State*, Lanes::count>;

  template <typename Visit>
  void look_around(Vertex v, Star& star, Visit&& visit) const;
  template <typename Wanted, typename Visit>
  void for_costs(Vertex v, Star& star, const Wanted& wanted, Visit&& visit) const;
  [[nodiscard]] FourCosts costs(Vertex v, std::span<const Vertex> others) const;
  /// Edges from one vertex, as seen from the others.
  [[nodiscard]] static EdgeView<Lanes> view_of_four(
      const State& at_v, const FourStates& others,
      const std::array<glm::vec3, Lanes::count>& along);
  [[nodiscard]] Lanes costs_with_values(Vertex v, std::span<const Vertex> others,
                                        const EdgeView<Lanes>& edges) const;
  [[nodiscard]] glm::vec3 place(Vertex v, Vertex w, Freedom freedom, const EdgeView<float>& edge,
                                Contraction& contraction) const;
  [[nodiscard]] bool roams(Vertex v) const;
  void find_candidates(Vertex v, Turn& turn) const;
  [[nodiscard]] bool may_collapse(Vertex v, Vertex w, double length2) const;
  [[nodiscard]] Freedom freedom_of(Vertex v, Vertex w) const;
  [[nodiscard]] bool on_curves(Vertex v, Vertex w) const {
    return state_[v].model.dimension() <= 1 && state_[w].model.dimension() <= 1;
  }
  [[nodiscard]] float cost_along_curve(Vertex v, Vertex w, Contraction& contraction) const;
  [[nodiscard]] glm::dvec3 least_on_curve(const CurvePlace& place, const Quadric& quadric,
                                          const glm::dvec3& from, const glm::dvec3& to) const;
  void refresh_curve(const Contraction& made);
  void update(Vertex v, const Contraction& made, float cost) { update(v, made.kept, made, cost); }
  void update(Vertex v, Vertex other, const Contraction& made, float cost);
  void put(Vertex v, float cost) { order_.put(v, cost, parts_.part_of(v)); }
  void dequeue(Vertex v);
  void fill();

  // Quadrics (quadrics.cpp)
  void add_normal(Vertex v, const glm::vec3& normal);
  void quadrics_of_faces();
  void quadrics_of_points();
  void add_values(bool by_points);
  void add_values_of_faces();
  void add_values_of_points();

  const Mesh& mesh_;
  const OriginalSurface& original_;
  const OriginalCurves& curves_;
  const DecimationOptions& options_;
  const Partition& parts_;
  const OriginalValues* values_ = nullptr;  ///< none: the shape alone counts
  CostRules rules_;
  Column<Vertex, State> state_;
  AttributeQuadrics attributes_;
  Column<Vertex, glm::vec3> normal_;
  VertexQueue order_;
  std::vector<float> levels_;  ///< see level()
};

}  // namespace aomd
