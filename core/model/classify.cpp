#include "core/model/classify.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/journal_scope.h"
#include "core/model/classify_volume.h"
#include "core/model/curve_corners.h"

namespace aomd {
namespace {

// Tags of one model dimension that are not taken yet.
class FreshTags {
 public:
  void taken(ModelRef model) { next_ = std::max(next_, model.tag() + 1); }
  std::int32_t take() { return next_++; }

 private:
  std::int32_t next_ = 1;
};

class Classifier {
 public:
  Classifier(Mesh& mesh, const ClassifyOptions& options)
      : mesh_(mesh),
        options_(options),
        corner_(options.corner_angle_deg),
        needs_{mesh.request(2, 0, "classification"), mesh.request(0, 1, "classification"),
               mesh.request(2, 1, "classification"), mesh.request(1, 2, "classification")} {}

  ClassifyResult run() {
    if (!options_.keep_present) forget();
    note_present();
    find_features();
    flood_faces();
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

  void note_present() {
    for (const Face f : mesh_.faces()) {
      const ModelRef m = mesh_.classification(f);
      if (m.dimension() == 2) tags_[2].taken(m), faces_given_ = true;
    }
    for (const Edge e : mesh_.edges())
      if (const ModelRef m = mesh_.classification(e); m.dimension() == 1)
        tags_[1].taken(m), edges_given_ = true;
    for (const Vertex v : mesh_.vertices()) {
      const ModelRef m = mesh_.classification(v);
      if (m.dimension() <= 1) tags_[static_cast<std::size_t>(m.dimension())].taken(m);
    }
  }

  // What the file classifies wins: then the angle has no say.
  void find_features() {
    const bool given = faces_given_ || edges_given_;
    const auto angle = given ? std::nullopt : options_.feature_angle_deg;
    features_ = aomd::find_features(mesh_, {angle, options_.nonmanifold_edges}, feature_);
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
          for (const Face g : mesh_.row<2>(e))
            if (!mesh_.classification(g).valid())
              mesh_.set_classification(g, model), stack.push_back(g);
        }
      }
    }
  }

  void find_model_vertices() {
    const auto is_feature = [&](Edge e) { return feature_[e] != 0; };
    std::vector<std::pair<Vertex, ModelRef>> found;
    for (const Vertex v : mesh_.vertices()) {
      if (mesh_.classification(v).valid()) continue;
      const CurveEnds ends = curve_at(mesh_, v, is_feature);
      if (ends.count == 0) continue;
      const ModelRef first = mesh_.classification(ends.edges[0]),
                     second = ends.count > 1 ? mesh_.classification(ends.edges[1]) : first;
      const bool split = (first.dimension() == 1 || second.dimension() == 1) && first != second;
      if (ends.count == 2 && !split && !curve_turns(mesh_, v, ends, corner_, is_feature)) continue;
      found.emplace_back(v, ModelRef(0, tags_[0].take()));
    }
    for (const auto& [v, model] : found) mesh_.set_classification(v, model);
  }

  bool ends_curve(Vertex v) const { return mesh_.classification(v).dimension() == 0; }

  void chain_edges() {
    std::vector<Edge> stack;
    for (const Edge seed : mesh_.edges()) {
      if (!feature_[seed] || mesh_.classification(seed).dimension() == 1) continue;
      const ModelRef model(1, tags_[1].take());
      mesh_.set_classification(seed, model);
      stack.push_back(seed);
      while (!stack.empty()) {
        const auto ends = mesh_.edge_vertices(stack.back());
        stack.pop_back();
        for (const Vertex v : ends) {
          if (ends_curve(v)) continue;
          for (const Edge e : mesh_.row<1>(v))
            if (feature_[e] && mesh_.classification(e).dimension() != 1)
              mesh_.set_classification(e, model), stack.push_back(e);
        }
      }
    }
  }

  void classify_rest() {
    for (const Edge e : mesh_.edges())
      if (!feature_[e]) mesh_.set_classification(e, mesh_.classification(mesh_.row<2>(e)[0]));
    for (const Vertex v : mesh_.vertices()) {
      if (mesh_.classification(v).valid()) continue;
      ModelRef lowest;
      for (const Edge e : mesh_.row<1>(v)) lowest = std::min(lowest, mesh_.classification(e));
      mesh_.set_classification(v, lowest);
    }
  }

  template <typename Range>
  int distinct(const Range& range, int dim) const {
    std::vector<std::int32_t> tags;
    for (const auto e : range)
      if (const ModelRef m = mesh_.classification(e);
          m.dimension() == dim && (tags.empty() || tags.back() != m.tag()))
        tags.push_back(m.tag());
    std::sort(tags.begin(), tags.end());
    return static_cast<int>(std::unique(tags.begin(), tags.end()) - tags.begin());
  }

  ClassifyResult count() const {
    return {distinct(mesh_.vertices(), 0), distinct(mesh_.edges(), 1), distinct(mesh_.faces(), 2),
            features_};
  }

  Mesh& mesh_;
  ClassifyOptions options_;
  TurnLimit corner_;
  std::array<Request, 4> needs_;
  Column<Edge, std::uint8_t> feature_;
  std::array<FreshTags, 3> tags_;
  FeatureCount features_;
  bool faces_given_ = false, edges_given_ = false;
};

}  // namespace

ClassifyResult classify(Mesh& mesh, const ClassifyOptions& options) {
  const JournalScope step(mesh, StepKind::Classify, {});
  return mesh.count(3) > 0 ? classify_volume(mesh, options) : Classifier(mesh, options).run();
}

}  // namespace aomd
