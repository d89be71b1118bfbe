#include "core/model/feature_preview.h"

#include "core/model/curve_corners.h"

namespace aomd {
namespace {

class CurveCounter {
 public:
  CurveCounter(const Mesh& mesh, const ClassifyOptions& options)
      : mesh_(mesh),
        corner_(options.corner_angle_deg),
        seen_(mesh.capacity(1), 0),
        ends_(mesh.capacity(0), 0) {
    find_features(mesh, {options.feature_angle_deg, options.nonmanifold_edges, true}, feature_);
  }

  FeaturePreview run() {
    FeaturePreview preview;
    for (const Vertex v : mesh_.vertices()) preview.model_vertices += ends_[v] = is_model_vertex(v);
    for (const Edge e : mesh_.edges()) {
      if (!feature_[e]) continue;
      preview.edges.push_back(e);
      preview.model_edges += follow(e);
    }
    return preview;
  }

 private:
  bool is_model_vertex(Vertex v) const {
    const auto is_feature = [&](Edge e) { return feature_[e] != 0; };
    const CurveEnds ends = curve_at(mesh_, v, is_feature);
    return ends.count != 0 && (ends.count != 2 || curve_turns(mesh_, v, ends, corner_, is_feature));
  }

  /// Whether the edge begins a model edge that has not been seen.
  bool follow(Edge seed) {
    if (seen_[seed]) return false;
    seen_[seed] = 1;
    stack_.assign(1, seed);
    while (!stack_.empty()) {
      const auto ends = mesh_.edge_vertices(stack_.back());
      stack_.pop_back();
      for (const Vertex v : ends) {
        if (ends_[v]) continue;
        for (const Edge e : mesh_.row<1>(v))
          if (feature_[e] && !seen_[e]) seen_[e] = 1, stack_.push_back(e);
      }
    }
    return true;
  }

  const Mesh& mesh_;
  TurnLimit corner_;
  Column<Edge, std::uint8_t> feature_, seen_;
  Column<Vertex, std::uint8_t> ends_;
  std::vector<Edge> stack_;
};

}  // namespace

FeaturePreview preview_features(const Mesh& mesh, const ClassifyOptions& options) {
  return CurveCounter(mesh, options).run();
}

}  // namespace aomd
