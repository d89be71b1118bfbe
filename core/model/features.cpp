#include "core/model/features.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "core/mesh/geometry.h"
#include "core/model/facets.h"
#include "core/model/some_edges.h"

namespace aomd {
namespace {

constexpr std::size_t shortest_open_chain = 8;
constexpr std::size_t smallest_set = 6;
constexpr double smallest_extent = 0.02;
constexpr double most_hair = 0.15;
constexpr double most_rough = 2.0 / 3.0;
constexpr double sharp_on_coarse = 0.1;

enum Mark : std::uint8_t { None = 0, Border = 1, Sharp = 2, Hair = 3, Step = 4 };

class FeatureFinder {
 public:
  FeatureFinder(const Mesh& mesh, const EdgeFaces& faces, Column<Edge, std::uint8_t>& mark)
      : mesh_(mesh), faces_(faces), mark_(mark) {}

  void mark_borders(const FeatureOptions& options) {
    mesh_.edges().each([&](Edge e) {
      const int faces = faces_.count(e);
      const bool given = !options.ignore_classes &&
                         (mesh_.classification(e).dimension() == 1 || !same_model_face(e, faces));
      const bool border = faces < 2 || (faces > 2 && options.nonmanifold_edges) || given;
      if (border) mark_[e] = Border;
    });
    for (const auto& [a, b] : options.seams)
      if (const Edge e = mesh_.find_edge(Vertex(a), Vertex(b)); e.valid()) mark_[e] = Border;
  }

  void mark_sharp(double angle_deg) {
    const TurnLimit limit(angle_deg);
    normals_.assign(mesh_.capacity(2), glm::dvec3(0.0));
    mesh_.faces().each([&](Face f) {
      const auto t = mesh_.triangle(f);
      normals_[f] = area_normal(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
    });
    mesh_.edges().each([&](Edge e) {
      if (mark_[e] == None && faces_.count(e) == 2 && past(e, limit))
        mark_[e] = Sharp, sharp_.push_back(e);
    });
    count_meetings();
  }

  // The steps of rounds make real curves look hairy: without them all others are judged again. A
  // fine mesh that was taken for a scan stays one.
  void drop_steps() {
    if (is_scan()) return;
    const FacetJudge judge(mesh_, faces_);
    std::vector<Edge> steps;
    for (const Edge e : sharp_)
      if (judge.is_step(e)) steps.push_back(e);
    if (steps.empty()) return;
    for (const Edge e : sharp_) set_mark(e, Sharp), seen_[e] = 0;
    for (const Edge e : steps) set_mark(e, Step);
    for (const Edge e : steps)
      for (const Vertex v : mesh_.edge_vertices(e)) carry_on(v);
    drop_roughness();
  }

  // Hairs first, all of them, so that shaving one may bare the next; then each set by its share of
  // hair.
  void drop_roughness() {
    grown_.assign(mesh_.capacity(0), 0);
    mesh_.vertices().each([&](Vertex v) {
      if (meeting_[v].features == 1) shave(v);
    });
    for (const Edge e : sharp_)
      if (in_set(e) && !seen_[e]) judge_set(e);
    drop_all_on_scans();
  }

 private:
  bool same_model_face(Edge e, int faces) const {
    if (faces < 2) return true;
    const ModelRef first = mesh_.classification(faces_.first(e));
    if (faces == 2) return mesh_.classification(faces_.second(e)) == first;
    bool same = true;
    faces_.each(e, [&](Face f) { same = same && mesh_.classification(f) == first; });
    return same;
  }

  // Edges with a mark, as they are met from their vertices.
  void count_meetings() {
    std::vector<Edge> marked;
    mesh_.edges().each([&](Edge e) {
      if (mark_[e] != None) marked.push_back(e);
    });
    meeting_.assign(mesh_.capacity(0), {});
    for (const Edge e : marked)
      for (const Vertex v : mesh_.edge_vertices(e)) ++meeting_[v].features;
    seen_.assign(mesh_.capacity(1), 0);
    marked_.emplace(mesh_, std::move(marked));
  }

  bool meets_step(Edge e) const {
    const auto [a, b] = mesh_.edge_vertices(e);
    return meeting_[a].steps > 0 || meeting_[b].steps > 0;
  }

  // Without the steps that joined them, curves beside a round may be short or have open ends.
  bool stands_by_itself(const std::vector<Edge>& edges) const {
    const auto corner = [&](Edge e) { return past(e, corner_); };
    const auto corners = std::count_if(edges.begin(), edges.end(), corner);
    return 2 * static_cast<std::size_t>(corners) > edges.size() &&
           std::any_of(edges.begin(), edges.end(), [&](Edge e) { return meets_step(e); });
  }

  bool in_set(Edge e) const { return mark_[e] == Sharp || mark_[e] == Hair; }

  bool is_scan() const {
    const auto sharp = [&](Edge e) { return mark_[e] == Sharp; };
    return std::none_of(sharp_.begin(), sharp_.end(), sharp) &&
           static_cast<double>(sharp_.size()) < sharp_on_coarse * mesh_.count(1);
  }

  bool past(Edge e, const TurnLimit& limit) const {
    const glm::dvec3 n = normals_[faces_.first(e)];
    glm::dvec3 m = normals_[faces_.second(e)];
    if (faces_.same_direction(e)) m = -m;
    const bool flat = glm::dot(n, n) == 0 || glm::dot(m, m) == 0;
    return !flat && !limit.allows(n, m);
  }

  static bool is_feature(std::uint8_t mark) { return mark == Border || mark == Sharp; }

  void set_mark(Edge e, Mark mark) {
    const std::uint8_t before = std::exchange(mark_[e], mark);
    for (const Vertex v : mesh_.edge_vertices(e)) {
      meeting_[v].features += is_feature(mark) - is_feature(before);
      meeting_[v].steps += (mark == Step) - (before == Step);
    }
  }

  // How many features other than hairs meet here; where they are one or two, `next` is one of them
  // that differs from `from`.
  int meeting(Vertex v, Edge from, Edge& next) const {
    const int count = meeting_[v].features;
    if (count != 1 && count != 2) return count;
    for (const Edge e : marked_->row<1>(v))
      if (is_feature(mark_[e]) && e != from) next = e;
    return count;
  }

  // Fills chain_ with an open chain from its tip, or as much of it as makes a curve. Returns where
  // that ends.
  Vertex follow(Vertex tip) {
    Edge next;
    Vertex at = tip;
    chain_.clear();
    if (meeting(at, {}, next) != 1) return tip;
    while (mark_[next] == Sharp && chain_.size() < shortest_open_chain) {
      const Edge e = next;
      chain_.push_back(e);
      at = mesh_.other_end(e, at);
      if (meeting(at, e, next) != 2) break;
    }
    return at;
  }

  // An open chain that is shorter than a curve is a hair.
  void shave(Vertex tip) {
    const Vertex at = follow(tip);
    if (chain_.size() >= shortest_open_chain || stands_by_itself(chain_)) return;
    for (const Edge e : chain_) set_mark(e, Hair);
    if (!chain_.empty() && at != tip) shave(at);
  }

  // A curve that breaks off and goes on behind a few steps in line with it is joined.
  void carry_on(Vertex tip) {
    follow(tip);
    if (chain_.size() < shortest_open_chain) return;
    Edge last = chain_.front(), other;
    Vertex at = tip;
    chain_.clear();
    do {
      last = straight_on(at, last);
      if (!last.valid() || chain_.size() == shortest_open_chain) return;
      chain_.push_back(last);
      at = mesh_.other_end(last, at);
    } while (meeting(at, {}, other) == 0);
    for (const Edge e : chain_) set_mark(e, Sharp);
  }

  // The step that turns least from an edge, by less than 45 degrees; none: invalid.
  Edge straight_on(Vertex at, Edge from) const {
    const glm::dvec3 p = mesh_.position(at), in = p - mesh_.position(mesh_.other_end(from, at));
    Edge best;
    double most = std::sqrt(0.5);
    for (const Edge e : marked_->row<1>(at)) {
      if (mark_[e] != Step) continue;
      const double cosine = cosine_between(in, mesh_.position(mesh_.other_end(e, at)) - p);
      if (cosine > most) most = cosine, best = e;
    }
    return best;
  }

  void judge_set(Edge seed) {
    set_.assign(1, seed);
    seen_[seed] = 1;
    std::size_t hairs = 0;
    glm::dvec3 low = mesh_.position(mesh_.edge_vertices(seed)[0]), high = low;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      hairs += mark_[set_[i]] == Hair;
      for (const Vertex v : mesh_.edge_vertices(set_[i])) {
        low = glm::min(low, mesh_.position(v));
        high = glm::max(high, mesh_.position(v));
        if (std::exchange(grown_[v], char{1}) != 0) continue;
        for (const Edge e : marked_->row<1>(v))
          if (in_set(e) && !seen_[e]) seen_[e] = 1, set_.push_back(e);
      }
    }
    const bool tiny =
        set_.size() < smallest_set && glm::length(high - low) < smallest_extent * diagonal();
    const bool rough =
        tiny || static_cast<double>(hairs) > most_hair * static_cast<double>(set_.size());
    if (!rough || stands_by_itself(set_)) return;
    for (const Edge e : set_) set_mark(e, Hair);
  }

  void drop_all_on_scans() {
    std::size_t sharp = 0, hair = 0;
    for (const Edge e : sharp_) sharp += mark_[e] == Sharp, hair += mark_[e] == Hair;
    if (static_cast<double>(hair) <= most_rough * static_cast<double>(sharp + hair)) return;
    for (const Edge e : sharp_)
      if (mark_[e] == Sharp) set_mark(e, Hair);
  }

  double diagonal() {
    if (diagonal_ < 0) {
      Column<Vertex, std::uint8_t> used(mesh_.capacity(0));
      mesh_.faces().each([&](Face f) {
        for (const Vertex v : mesh_.triangle(f)) used[v] = 1;
      });
      glm::dvec3 low(1e300), high(-1e300);
      mesh_.vertices().each([&](Vertex v) {
        if (!used[v]) return;
        low = glm::min(low, mesh_.position(v));
        high = glm::max(high, mesh_.position(v));
      });
      diagonal_ = glm::length(high - low);
    }
    return diagonal_;
  }

  struct Meeting {
    int features = 0, steps = 0;
  };

  const Mesh& mesh_;
  const EdgeFaces& faces_;
  Column<Edge, std::uint8_t>& mark_;
  const TurnLimit corner_{FacetJudge::corner_deg};
  Column<Edge, std::uint8_t> seen_;
  Column<Vertex, Meeting> meeting_;  ///< how many of a kind meet at each vertex
  std::optional<SomeEdges> marked_;
  Column<Vertex, char> grown_;  ///< set: all of a set around it are in
  Column<Face, glm::dvec3> normals_;
  std::vector<Edge> sharp_, chain_, set_;
  double diagonal_ = -1;
};

}  // namespace

FeatureCount find_features(const Mesh& mesh, const FeatureOptions& options,
                           Column<Edge, std::uint8_t>& feature) {
  return find_features(mesh, EdgeFaces(mesh), options, feature);
}

FeatureCount find_features(const Mesh& mesh, const EdgeFaces& faces, const FeatureOptions& options,
                           Column<Edge, std::uint8_t>& feature) {
  feature.assign(mesh.capacity(1), None);
  FeatureFinder finder(mesh, faces, feature);
  finder.mark_borders(options);
  if (options.angle_deg) {
    finder.mark_sharp(*options.angle_deg);
    finder.drop_roughness();
    finder.drop_steps();
  }
  constexpr std::array<std::uint8_t, 5> stays{0, 1, 1, 0, 0};  // by mark
  std::array<std::uint32_t, 5> count{};
  for (std::uint32_t id = 0; id < feature.size(); ++id) {
    std::uint8_t& mark = feature[Edge(id)];
    ++count[mark];
    mark = stays[mark];
  }
  return {count[Border], count[Sharp], count[Hair], count[Step]};
}

}  // namespace aomd
