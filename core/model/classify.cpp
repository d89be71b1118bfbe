#include "core/model/classify.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/buckets.h"
#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/journal_scope.h"
#include "core/model/classify_volume.h"
#include "core/model/curve_corners.h"
#include "core/model/edge_faces.h"
#include "core/model/some_edges.h"

namespace aomd {
namespace {

// Tags of one model dimension that are not taken yet: above the largest one, then the gaps.
class FreshTags {
 public:
  void taken(ModelRef model) {
    if (model.tag() >= next_) next_ = model.tag() + 1;
    if (model.tag() > 0 && (taken_.empty() || taken_.back() != model.tag()))
      taken_.push_back(model.tag());
  }
  std::int32_t take() {
    if (next_ <= ModelRef::max_tag) return next_++;
    if (gap_ == 0) std::sort(taken_.begin(), taken_.end());
    do ++gap_;
    while (std::binary_search(taken_.begin(), taken_.end(), gap_));
    return gap_;
  }

 private:
  std::int32_t next_ = 1, gap_ = 0;
  std::vector<std::int32_t> taken_;
};

class Classifier {
 public:
  Classifier(Mesh& mesh, const ClassifyOptions& options)
      : mesh_(mesh),
        options_(options),
        corner_(options.corner_angle_deg),
        needs_{mesh.request(2, 0, name), mesh.request(2, 1, name)},
        faces_(mesh),
        listed_(mesh.capacity(1)) {}

  ClassifyResult run() {
    if (!options_.keep_present) forget();
    note_present();
    if (curves_given_by_vertices_ || !options_.seams.empty()) around_ = mesh_.request(0, 1, name);
    find_features();
    if (curves_given_by_vertices_) find_curves_of_vertices();
    list_curves();
    flood_faces();
    find_touching();
    find_model_vertices();
    chain_edges();
    classify_rest();
    return count();
  }

 private:
  void forget() {
    for (const Vertex v : mesh_.vertices()) mesh_.set_classification(v, {});
    for (const Edge e : mesh_.edges()) mesh_.set_classification(e, {});
    for (const Face f : mesh_.faces()) mesh_.set_classification(f, {});
  }

  // Faces of a surface lie in no model region, whatever the file says.
  void note_present() {
    mesh_.faces().each([&](Face f) {
      if (mesh_.classification(f).dimension() == 3) mesh_.set_classification(f, {});
      const ModelRef m = mesh_.classification(f);
      if (m.dimension() == 2) tags_[2].taken(m);
      note_face(m);
    });
    mesh_.edges().each([&](Edge e) {
      if (const ModelRef m = mesh_.classification(e); m.dimension() == 1)
        tags_[1].taken(m), edges_given_ = true, listed_[e] = 1;
    });
    mesh_.vertices().each([&](Vertex v) {
      const ModelRef m = mesh_.classification(v);
      if (m.dimension() <= 1) tags_[static_cast<std::size_t>(m.dimension())].taken(m);
      curves_given_by_vertices_ |= m.dimension() == 1;
    });
  }

  void note_face(ModelRef model) {
    if (!model.valid()) faces_left_out_ = true;
    if (model.valid() && !some_face_.valid()) some_face_ = model;
    faces_differ_ |= model.valid() && model != some_face_;
  }

  // What the file classifies wins: then the angle has no say. One model face for all of a surface
  // says nothing of its edges, and faces that are left out are not said to be smooth.
  void find_features() {
    const auto angle = given() ? std::nullopt : options_.feature_angle_deg;
    features_ = aomd::find_features(
        mesh_, faces_, {angle, options_.nonmanifold_edges, false, options_.seams}, feature_);
  }

  void flood_faces() {
    std::vector<Face> stack;
    for (const Face seed : mesh_.faces()) {
      if (mesh_.classification(seed).valid()) continue;
      const ModelRef model(2, tags_[2].take());
      mesh_.set_classification(seed, model);
      stack.push_back(seed);
      while (!stack.empty()) {
        const Face f = stack.back();
        stack.pop_back();
        for (const Edge e : mesh_.row<1>(f)) {
          if (feature_[e]) continue;
          faces_.each_other(e, f, [&](Face g) {
            if (!mesh_.classification(g).valid())
              mesh_.set_classification(g, model), stack.push_back(g);
          });
        }
      }
    }
  }

  // The model edge on which both ends of an edge lie, where the file says so of at least one.
  [[nodiscard]] ModelRef curve_of_ends(Edge e) const {
    const auto ends = mesh_.edge_vertices(e);
    const ModelRef a = mesh_.classification(ends[0]), b = mesh_.classification(ends[1]);
    if (a.dimension() == 1 && (b == a || b.dimension() == 0)) return a;
    return b.dimension() == 1 && a.dimension() == 0 ? b : ModelRef();
  }

  // Files may put vertices on model edges and list no edges. Borders take their model edge from
  // them. Inside a model face, a curve is where each of its vertices has two neighbours on it;
  // elsewhere the vertices alone cannot tell (paper, figure 4).
  void find_curves_of_vertices() {
    for (const Edge e : mesh_.edges())
      if (feature_[e] && mesh_.classification(e).dimension() != 1)
        if (const ModelRef model = curve_of_ends(e); model.valid())
          mesh_.set_classification(e, model);
    std::vector<Edge> found;
    for (const Edge e : mesh_.edges())
      if (!feature_[e] && curve_of_ends(e).valid() && is_between_two(e)) found.push_back(e);
    for (const Edge e : found) {
      feature_[e] = 1;
      mesh_.set_classification(e, curve_of_ends(e));
    }
    features_.borders += static_cast<std::uint32_t>(found.size());
  }

  [[nodiscard]] bool is_between_two(Edge e) const {
    for (const Vertex v : mesh_.edge_vertices(e)) {
      if (mesh_.classification(v).dimension() == 0) continue;
      int neighbours = 0;
      for (const Edge other : mesh_.row<1>(v)) {
        if (feature_[other]) return false;
        neighbours += curve_of_ends(other).valid();
      }
      if (neighbours != 2) return false;
    }
    return true;
  }

  void list_curves() {
    std::vector<Edge> curves;
    mesh_.edges().each([&](Edge e) {
      if (feature_[e]) curves.push_back(e);
    });
    curves_.emplace(mesh_, std::move(curves));
  }

  CurveEnds curve(Vertex v) const { return curve_at(*curves_, v, any_edge); }

  void find_model_vertices() {
    std::vector<std::pair<Vertex, ModelRef>> found;
    mesh_.vertices().each([&](Vertex v) {
      if (mesh_.classification(v).dimension() != 0 && is_model_vertex(v))
        found.emplace_back(v, ModelRef(0, tags_[0].take()));
    });
    for (const auto& [v, model] : found) mesh_.set_classification(v, model);
  }

  // What the file says of a vertex is believed as far as model edges pass through it: between two
  // edges that the file lists on one model edge it is no corner, and on a model edge that is
  // nowhere to be found it stays where it is.
  [[nodiscard]] bool is_model_vertex(Vertex v) const {
    const bool on_curve = mesh_.classification(v).dimension() == 1;
    const CurveEnds ends = curve(v);
    if (ends.count == 0) return on_curve && !mesh_.row<1>(v).empty();
    if (ends.count != 2) return true;
    const ModelRef first = mesh_.classification(ends.edges[0]),
                   second = mesh_.classification(ends.edges[1]);
    if ((first.dimension() == 1 || second.dimension() == 1) && first != second) return true;
    if (touches_other_faces_[v]) return true;
    const bool listed = on_curve && listed_[ends.edges[0]] && listed_[ends.edges[1]];
    return !listed && curve_turns(*curves_, v, ends, corner_, any_edge);
  }

  // Marks the vertices inside a curve with a face on a model face that the curve does not bound:
  // surfaces that touch in a single point.
  void find_touching() {
    Column<Vertex, std::uint8_t> inside(mesh_.capacity(0));
    touches_other_faces_.assign(mesh_.capacity(0), 0);
    for (const Edge e : curves_->edges())
      for (const Vertex v : mesh_.edge_vertices(e)) inside[v] = curve(v).count == 2;
    Buckets<ModelRef> bounded(mesh_.capacity(0), [&](auto&& file) {
      for (const Edge e : curves_->edges())
        for (const Vertex v : mesh_.edge_vertices(e))
          if (inside[v]) faces_.each(e, [&](Face f) { file(v.index, mesh_.classification(f)); });
    });
    for (std::size_t v = 0; v < bounded.count(); ++v) std::ranges::sort(bounded[v], std::less<>());
    mesh_.faces().each([&](Face f) {
      for (const Vertex v : mesh_.row<0>(f))
        if (inside[v] &&
            !std::ranges::binary_search(bounded[v.index], mesh_.classification(f), std::less<>()))
          touches_other_faces_[v] = 1;
    });
  }

  bool ends_curve(Vertex v) const { return mesh_.classification(v).dimension() == 0; }

  void chain_edges() {
    std::vector<Edge> stack;
    for (const Edge seed : curves_->edges()) {
      if (mesh_.classification(seed).dimension() == 1) continue;
      const ModelRef model(1, tags_[1].take());
      mesh_.set_classification(seed, model);
      stack.push_back(seed);
      while (!stack.empty()) {
        const auto ends = mesh_.edge_vertices(stack.back());
        stack.pop_back();
        for (const Vertex v : ends) {
          if (ends_curve(v)) continue;
          for (const Edge e : curves_->row<1>(v))
            if (mesh_.classification(e).dimension() != 1)
              mesh_.set_classification(e, model), stack.push_back(e);
        }
      }
    }
  }

  // A vertex that is no model vertex so far lies on what all its edges but those of a curve lie on,
  // or on the curve. Model faces that touch in a single point do so in a model vertex.
  void classify_rest() {
    Column<Vertex, Span> around(mesh_.capacity(0));
    mesh_.edges().each([&](Edge e) {
      if (!feature_[e]) mesh_.set_classification(e, mesh_.classification(faces_.first(e)));
      for (const Vertex v : mesh_.edge_vertices(e)) around[v].add(mesh_.classification(e));
    });
    mesh_.vertices().each([&](Vertex v) {
      const auto [lowest, highest] = around[v];
      if (ends_curve(v) || !lowest.valid()) return;
      const bool one = lowest.dimension() == 1 || lowest == highest;
      mesh_.set_classification(v, one ? lowest : ModelRef(0, tags_[0].take()));
    });
  }

  // The classes of the edges at a vertex.
  struct Span {
    ModelRef lowest, highest{0, 0};
    void add(ModelRef model) {
      if (model == lowest && model == highest) return;
      lowest = std::min(lowest, model);
      highest = std::max(highest, model);
    }
  };

  template <typename Range>
  int distinct(const Range& range, int dim) const {
    std::vector<std::int32_t> tags;
    ModelRef last;
    for (const auto e : range) {
      const ModelRef m = mesh_.classification(e);
      if (m == last || m.dimension() != dim) continue;
      tags.push_back(m.tag());
      last = m;
    }
    std::sort(tags.begin(), tags.end());
    return static_cast<int>(std::unique(tags.begin(), tags.end()) - tags.begin());
  }

  ClassifyResult count() const {
    return {distinct(mesh_.vertices(), 0), distinct(curves_->edges(), 1),
            distinct(mesh_.faces(), 2), features_, given()};
  }

  [[nodiscard]] bool given() const {
    return (faces_differ_ && !faces_left_out_) || edges_given_ || curves_given_by_vertices_;
  }

  static constexpr const char* name = "classification";
  static constexpr auto any_edge = [](Edge) { return true; };

  Mesh& mesh_;
  ClassifyOptions options_;
  TurnLimit corner_;
  std::array<Request, 2> needs_;
  Request around_;
  EdgeFaces faces_;
  Column<Edge, std::uint8_t> feature_;
  std::optional<SomeEdges> curves_;                   ///< those that are features
  Column<Vertex, std::uint8_t> touches_other_faces_;  ///< those inside a curve
  Column<Edge, std::uint8_t> listed_;                 ///< by the file, on a model edge
  std::array<FreshTags, 3> tags_;
  FeatureCount features_;
  ModelRef some_face_;
  bool faces_differ_ = false, faces_left_out_ = false, edges_given_ = false,
       curves_given_by_vertices_ = false;
};

}  // namespace

ClassifyResult classify(Mesh& mesh, const ClassifyOptions& options) {
  const JournalScope step(mesh, StepKind::Classify, {});
  return mesh.count(3) > 0 ? classify_volume(mesh, options) : Classifier(mesh, options).run();
}

}  // namespace aomd
