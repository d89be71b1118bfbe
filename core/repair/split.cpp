#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "core/mesh/geometry.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

using Use = EdgeUses::Use;

// Matching is quadratic; an edge of more faces than this is cut open.
constexpr std::size_t most_matched = 64;
// Pairing one edge another way may make another fail; cutting never does.
constexpr int most_rounds = 4;

// How the faces at an edge of three or more are held together, from what is tried first to what
// never fails.
enum class Hold : std::uint8_t { Pairs, OtherPairs, Open, All };

struct CrowdedEdge {
  std::uint32_t low;
  std::vector<Use> uses;
  Hold hold = Hold::Pairs;
  std::vector<std::array<Use, 2>> pairs{};  ///< that are held together
};

class FanSplitter {
 public:
  FanSplitter(Surface& surface, const Weld& weld, bool split)
      : surface_(surface), weld_(weld), split_(split) {}

  Split run() {
    sort_edges();
    do {
      join();
    } while (change_what_fails());
    name_fans();
    return std::move(result_);
  }

 private:
  void sort_edges() {
    const EdgeUses uses(surface_);
    const auto model_edges = listed_model_edges();
    uses.each([&](std::span<const Use> at) {
      if (at.size() < 2) return;
      if (at.size() == 2) return void(pairs_.push_back({at[0].place, at[1].place}));
      const std::uint32_t low = low_of(at[0]);
      const bool meant =
          std::binary_search(model_edges.begin(), model_edges.end(), edge_key(low, at[0].high));
      const Hold hold = meant ? Hold::All : at.size() > most_matched ? Hold::Open : Hold::Pairs;
      crowded_.push_back({low, {at.begin(), at.end()}, hold});
      if (hold == Hold::Pairs) crowded_.back().pairs = matched(crowded_.back());
    });
  }

  // Where a file puts an edge on a model edge, several faces are meant to meet.
  [[nodiscard]] std::vector<std::uint64_t> listed_model_edges() const {
    const EntityList& edges = surface_.data().edges;
    std::vector<std::uint64_t> keys;
    for (std::size_t e = 0; e < edges.classes.size(); ++e)
      if (edges.classes[e].dimension() <= 1)
        keys.push_back(
            edge_key(weld_.base(edges.vertices[2 * e]), weld_.base(edges.vertices[2 * e + 1])));
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  [[nodiscard]] std::uint32_t low_corner(Use use) const {
    return use.forward() ? use.corner() : surface_.next(use.corner());
  }
  [[nodiscard]] std::uint32_t high_corner(Use use) const {
    return use.forward() ? surface_.next(use.corner()) : use.corner();
  }
  [[nodiscard]] std::uint32_t low_of(Use use) const { return surface_.vertex(low_corner(use)); }
  [[nodiscard]] std::uint32_t face(Use use) const { return surface_.face_of(use.corner()); }

  void unite(Use a, Use b) {
    fans_.unite(low_corner(a), low_corner(b));
    fans_.unite(high_corner(a), high_corner(b));
  }

  // Corners that one vertex can hold: those that the edges between them connect.
  void join() {
    fans_ = DisjointSets(surface_.corner_count());
    for (const auto& [a, b] : pairs_) unite({0, a}, {0, b});
    for (const CrowdedEdge& edge : crowded_) {
      if (edge.hold == Hold::Pairs || edge.hold == Hold::OtherPairs)
        for (const auto& [a, b] : edge.pairs) unite(a, b);
      else if (edge.hold == Hold::All)
        for (const Use use : edge.uses) unite(edge.uses[0], use);
    }
    join_whole_vertices();
  }

  void join_whole_vertices() {
    std::vector<std::uint32_t> first(surface_.vertex_count(), no_index);
    surface_.each_corner([&](std::uint32_t c) {
      const std::uint32_t v = surface_.vertex(c);
      if (split_ && surface_.vertex_class(v).dimension() != 0) return;
      if (first[v] == no_index) first[v] = c;
      fans_.unite(first[v], c);
    });
  }

  // Pairs of opposite sides, those that bend least first; of equal ones those that enclose the
  // inside. Never the pairs that the edge has.
  [[nodiscard]] std::vector<std::array<Use, 2>> matched(const CrowdedEdge& edge) const {
    struct Candidate {
      double bend;  // 1 - cosine, in steps that rounding does not reach
      bool hollow;
      Use a, b;
    };
    std::vector<Candidate> candidates;
    for (const Use a : edge.uses)
      for (const Use b : edge.uses) {
        if (!a.forward() || b.forward() || paired(edge, a, b)) continue;
        const glm::dvec3 n = surface_.normal(face(a)), m = surface_.normal(face(b));
        candidates.push_back(
            {std::round((1 - cosine_between(n, m)) * 1e6), hollow(edge, a, b), a, b});
      }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) {
                       return x.bend != y.bend ? x.bend < y.bend : x.hollow < y.hollow;
                     });
    std::vector<std::array<Use, 2>> pairs;
    std::vector<std::uint32_t> taken;
    const auto free = [&](Use use) {
      return std::find(taken.begin(), taken.end(), use.place) == taken.end();
    };
    for (const Candidate& c : candidates) {
      if (!free(c.a) || !free(c.b)) continue;
      taken.insert(taken.end(), {c.a.place, c.b.place});
      pairs.push_back({c.a, c.b});
    }
    return pairs;
  }

  [[nodiscard]] static bool paired(const CrowdedEdge& edge, Use a, Use b) {
    return std::any_of(edge.pairs.begin(), edge.pairs.end(), [&](const auto& pair) {
      return pair[0].place == a.place && pair[1].place == b.place;
    });
  }

  // True where the second face rises towards the side that the first one looks at.
  [[nodiscard]] bool hollow(const CrowdedEdge& edge, Use a, Use b) const {
    glm::dvec3 middle(0);
    const auto v = surface_.vertices(face(b));
    for (const std::uint32_t u : v) middle += surface_.position(u) / static_cast<double>(v.size());
    return glm::dot(surface_.normal(face(a)), middle - surface_.position(edge.low)) > 0;
  }

  // Two pairs that are held together elsewhere at both ends would be four faces at one edge again:
  // it is paired the other way, which closes the passage between the two, or, where that fails too,
  // cut open.
  bool change_what_fails() {
    bool changed = false;
    ++rounds_;
    for (CrowdedEdge& edge : crowded_) {
      if (edge.hold >= Hold::Open || fits(edge)) continue;
      const bool again = edge.hold == Hold::Pairs && rounds_ <= most_rounds;
      edge.hold = again ? Hold::OtherPairs : Hold::Open;
      edge.pairs = again ? matched(edge) : std::vector<std::array<Use, 2>>();
      changed = true;
    }
    return changed;
  }

  // Whether at most two faces at the edge are on the same two of the vertices that `vertex_of`
  // names.
  template <typename VertexOf>
  [[nodiscard]] bool at_most_two(const CrowdedEdge& edge, VertexOf&& vertex_of) const {
    std::map<std::array<std::uint32_t, 2>, int> faces;
    for (const Use use : edge.uses)
      if (++faces[{vertex_of(low_corner(use)), vertex_of(high_corner(use))}] > 2) return false;
    return true;
  }
  [[nodiscard]] bool fits(const CrowdedEdge& edge) {
    return at_most_two(edge, [&](std::uint32_t c) { return fans_.find(c); });
  }
  // Whether a weld alone brought its faces together.
  [[nodiscard]] bool fitted(const CrowdedEdge& edge) const {
    return at_most_two(edge, [&](std::uint32_t c) { return weld_.given_at(surface_, c); });
  }

  // The first fan at a vertex keeps it, the others get copies; after a weld each the vertex it had,
  // if free.
  void name_fans() {
    std::vector<std::uint32_t>& corners = surface_.data().faces.vertices;
    const std::vector<std::uint32_t> before = corners;
    tell_edges();
    std::vector<std::uint32_t> name(corners.size(), no_index);
    std::vector<std::uint8_t> taken(surface_.vertex_count(), 0);
    surface_.each_corner([&](std::uint32_t c) {
      const std::uint32_t given = weld_.given_at(surface_, c);
      std::uint32_t& own = name[fans_.find(c)];
      if (own == no_index) own = name_of_fan(given, taken);
      if (own != given) lower_class(own, given);
      if (weld_.moves() && origin(own) != given) to_the_rest(own, given);
      if (weld_.on() && !taken[given]) vanished_.push_back(given);
      corners[c] = own;
    });
    tell_welded(taken);
    if (corners != before || weld_.on()) follow_faces(surface_, before, weld_);
  }

  std::uint32_t name_of_fan(std::uint32_t given, std::vector<std::uint8_t>& taken) {
    const std::uint8_t fans = taken[given];
    taken[given] = std::min(fans + 1, 2);
    if (fans == 0) return given;
    ++result_.copies;
    if (fans == 1) result_.vertices.add(given);
    copied_.push_back(given);
    return surface_.copy_vertex(given);
  }

  // The vertex that another was copied from, or that other itself.
  [[nodiscard]] std::uint32_t origin(std::uint32_t name) const {
    return name < given_count_ ? name : copied_[name - given_count_];
  }

  // Vertices that become one lie where the one lies that stands for them.
  void to_the_rest(std::uint32_t own, std::uint32_t given) {
    surface_.move_vertex(own, glm::dvec3(surface_.position(weld_.base(given))));
  }

  // Of vertices that become one, the class of the lowest dimension holds.
  void lower_class(std::uint32_t v, std::uint32_t other) {
    if (!weld_.on() || surface_.data().vertex_classes.empty()) return;
    ModelRef& own = surface_.data().vertex_classes[v];
    if (surface_.vertex_class(other) < own) own = surface_.vertex_class(other);
  }

  void tell_edges() {
    for (CrowdedEdge& edge : crowded_) {
      if (!split_) continue;
      if (edge.hold == Hold::All || !fits(edge)) {
        result_.kept_edges.add(face(edge.uses[0]));
      } else if (!fitted(edge)) {
        result_.edges.add(face(edge.uses[0]));
        result_.cut += edge.hold == Hold::Open;
      }
    }
  }

  void tell_welded(const std::vector<std::uint8_t>& taken) {
    std::sort(vanished_.begin(), vanished_.end());
    vanished_.erase(std::unique(vanished_.begin(), vanished_.end()), vanished_.end());
    for (const std::uint32_t v : vanished_)
      if (!taken[v]) result_.welded.add(v);
  }

  Surface& surface_;
  const Weld& weld_;
  bool split_;
  std::vector<std::array<std::uint32_t, 2>> pairs_;
  std::vector<CrowdedEdge> crowded_;
  DisjointSets fans_{0};
  int rounds_ = 0;
  std::uint32_t given_count_ = surface_.vertex_count();
  std::vector<std::uint32_t> copied_;  ///< what each vertex that was added is a copy of
  std::vector<std::uint32_t>
      vanished_;  ///< vertices whose corners went to others, some of them taken later
  Split result_;
};

}  // namespace

Split mend_fans(Surface& surface, const Weld& weld, bool split) {
  return FanSplitter(surface, weld, split).run();
}

}  // namespace aomd::repair_detail
