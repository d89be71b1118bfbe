#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/repair/around.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// A face around which everything goes on changing is left in the end: keeps huge fans of flat faces
// linear.
constexpr int most_tries = 64;

// Faces around a vertex of more than these come up again together, when nothing else is left to do,
// and it becomes one with no other until it has fewer: looked at for each change there, they would
// take the square of their number.
constexpr std::size_t crowd = 512;

class ZeroAreaMender {
 public:
  ZeroAreaMender(Surface& surface, std::vector<std::uint32_t> flat)
      : surface_(surface), around_(surface), queue_(flat.begin(), flat.end()) {
    waiting_.insert(flat.begin(), flat.end());
    const EntityList& edges = surface.data().edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
      listed_.insert(edge_key(edges.vertices[2 * e], edges.vertices[2 * e + 1]));
  }

  // Every face whose surroundings change comes up again, so that what is left is left for good.
  // Each step makes fewer flat faces, or a shorter longest side between two: it ends.
  ZeroArea run(const std::vector<std::uint32_t>& flat) {
    for (; !queue_.empty(); look_at_crowds()) {
      const std::uint32_t f = queue_.front();
      queue_.pop_front();
      waiting_.erase(f);
      if (is_flat_face(f) && ++tries_[f] <= most_tries)
        static_cast<void>(collapse(f) || swap_side(f) || remove(f));
    }
    for (const std::uint32_t f : flat)
      if (is_flat_face(f)) result_.left.add(f);
    rename_listed();
    return std::move(result_);
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  [[nodiscard]] bool is_flat_face(std::uint32_t f) const {
    const auto v = std::as_const(surface_).vertices(f);
    return surface_.alive(f) && v.size() == 3 &&
           collinear(surface_.position(v[0]), surface_.position(v[1]), surface_.position(v[2]));
  }
  [[nodiscard]] bool coincide(std::uint32_t a, std::uint32_t b) const {
    return surface_.position(a) == surface_.position(b);
  }
  [[nodiscard]] bool listed(std::uint32_t a, std::uint32_t b) const {
    return listed_.contains(edge_key(a, b));
  }

  // The corners of a flat face turned so that the second lies between the others: points on a line
  // are in the order of their coordinates.
  [[nodiscard]] Corners round_middle(std::uint32_t f) const {
    const auto v = std::as_const(surface_).vertices(f);
    std::array<int, 3> order{0, 1, 2};
    const auto key = [&](int k) {
      const glm::dvec3& p = surface_.position(v[static_cast<std::size_t>(k)]);
      return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });
    const auto middle = static_cast<std::size_t>(order[1]);
    return {v[(middle + 2) % 3], v[middle], v[(middle + 1) % 3]};
  }

  void touch(std::uint32_t v) {
    if (crowded(v))
      crowded_.insert(v);
    else
      touch_all(v);
  }

  void look_at_crowds() {
    if (!queue_.empty()) return;
    for (const std::uint32_t v : std::exchange(crowded_, {})) touch_all(v);
  }

  void touch_all(std::uint32_t v) {
    for (const std::uint32_t f : around_.faces(v))
      if (is_flat_face(f) && waiting_.insert(f).second) queue_.push_back(f);
  }

  void take_out(std::uint32_t f) {
    for (const std::uint32_t v : std::as_const(surface_).vertices(f)) around_.remove(v, f);
    surface_.remove(f);
  }

  void put(std::uint32_t f, const Corners& corners) {
    for (const std::uint32_t v : std::as_const(surface_).vertices(f)) around_.remove(v, f);
    std::copy(corners.begin(), corners.end(), surface_.vertices(f).begin());
    for (const std::uint32_t v : corners) around_.add(v, f);
  }

  // A side without length: its ends become one.
  bool collapse(std::uint32_t f) {
    const auto v = std::as_const(surface_).vertices(f);
    const Corners corners{v[0], v[1], v[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t stays = corners[k], goes = corners[(k + 1) % 3];
      if (!coincide(stays, goes) || crowded(stays) || crowded(goes)) continue;
      if (surface_.vertex_class(goes) < surface_.vertex_class(stays)) std::swap(stays, goes);
      if (!model_allows(stays, goes) || !link_allows(stays, goes)) continue;
      merge(stays, goes);
      result_.collapsed.add(f);
      return true;
    }
    return false;
  }

  // What goes lies inside a model face or on the model edge of the side, or both are one to the
  // model.
  [[nodiscard]] bool model_allows(std::uint32_t stays, std::uint32_t goes) const {
    const ModelRef s = surface_.vertex_class(stays), g = surface_.vertex_class(goes);
    return s == g || g.dimension() >= 2 || (g.dimension() == 1 && listed(stays, goes));
  }

  [[nodiscard]] bool crowded(std::uint32_t v) const { return around_.faces(v).size() > crowd; }

  // The link condition: nothing but the faces at the side becomes one with something else.
  [[nodiscard]] bool link_allows(std::uint32_t a, std::uint32_t b) const {
    const auto at_side = around_.at_side(a, b);
    std::vector<std::uint32_t> apexes;
    for (const std::uint32_t f : at_side) {
      const auto v = std::as_const(surface_).vertices(f);
      if (v.size() != 3) return false;
      apexes.push_back(v[0] ^ v[1] ^ v[2] ^ a ^ b);
    }
    std::sort(apexes.begin(), apexes.end());
    const auto of_a = around_.neighbours(a), of_b = around_.neighbours(b);
    std::vector<std::uint32_t> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                          std::back_inserter(common));
    if (at_side.empty() || at_side.size() > 2 || around_.faces(a, b).size() != at_side.size() ||
        common != apexes)
      return false;
    return border_allows(a, b, apexes) && !second_face(a, b);
  }

  // With the border as one more vertex that all its sides are joined to.
  [[nodiscard]] bool border_allows(std::uint32_t a, std::uint32_t b,
                                   const std::vector<std::uint32_t>& apexes) const {
    if (apexes.size() == 2) return !(around_.at_border(a) && around_.at_border(b));
    return around_.at_side(a, apexes[0]).size() == 2 || around_.at_side(b, apexes[0]).size() == 2;
  }

  // Whether a face at b would lie on one at a.
  [[nodiscard]] bool second_face(std::uint32_t a, std::uint32_t b) const {
    const auto key = [&](std::uint32_t f) {
      std::vector<std::uint32_t> v(std::as_const(surface_).vertices(f).begin(),
                                   std::as_const(surface_).vertices(f).end());
      std::replace(v.begin(), v.end(), b, a);
      std::sort(v.begin(), v.end());
      return v;
    };
    std::set<std::vector<std::uint32_t>> at_a;
    for (const std::uint32_t f : around_.faces(a)) at_a.insert(key(f));
    const auto at_b = around_.faces(b);
    const auto both = around_.at_side(a, b);
    return std::any_of(at_b.begin(), at_b.end(), [&](std::uint32_t g) {
      return std::find(both.begin(), both.end(), g) == both.end() && at_a.contains(key(g));
    });
  }

  void merge(std::uint32_t stays, std::uint32_t goes) {
    for (const std::uint32_t f : around_.at_side(stays, goes)) take_out(f);
    const auto at_goes = around_.faces(goes);
    for (const std::uint32_t f : std::vector(at_goes.begin(), at_goes.end())) {
      const auto v = surface_.vertices(f);
      std::replace(v.begin(), v.end(), goes, stays);
      around_.remove(goes, f);
      around_.add(stays, f);
    }
    renamed_.emplace_back(goes, stays);
    for (const std::uint32_t v : around_.neighbours(stays))
      if (listed(goes, v)) listed_.insert(edge_key(stays, v));
    for (const std::uint32_t v : around_.neighbours(stays)) touch(v);
  }

  // The neighbour's longest side and ours are one, and the vertex between its ends divides it:
  //      d             d
  //     / \           /|\      .
  //    /   \   ->    / | \     .
  //   a--b--c       a--b--c
  bool swap_side(std::uint32_t f) {
    const auto [a, b, c] = round_middle(f);
    const auto at_side = around_.at_side(a, c);
    if (at_side.size() != 2 || listed(a, c) || coincide(a, b) || coincide(b, c)) return false;
    const std::uint32_t g = at_side[0] == f ? at_side[1] : at_side[0];
    const auto v = std::as_const(surface_).vertices(g);
    if (v.size() != 3) return false;
    const std::uint32_t d = v[0] ^ v[1] ^ v[2] ^ a ^ c;
    const auto from = static_cast<std::size_t>(std::find(v.begin(), v.end(), a) - v.begin());
    if (v[(from + 1) % 3] != c || d == b || !around_.faces(b, d).empty()) return false;
    if (is_flat_face(g) && (round_middle(g)[1] != d || coincide(a, d) || coincide(c, d)))
      return false;
    put(f, {a, b, d});
    put(g, {b, c, d});
    surface_.take_properties(f, g);
    result_.swapped.add(f);
    for (const std::uint32_t u : {a, b, c, d}) touch(u);
    return true;
  }

  // At the border nothing is left open by a face without area, as long as it does not hold two fans
  // together.
  bool remove(std::uint32_t f) {
    const auto [a, b, c] = round_middle(f);
    const auto alone = [&](std::uint32_t u, std::uint32_t w) {
      return around_.at_side(u, w).size() == 1;
    };
    if (!alone(a, c) || (!alone(a, b) && !alone(b, c) && around_.at_border(b))) return false;
    for (const auto& [u, w] : {std::pair(a, b), {b, c}, {c, a}})
      if (alone(u, w) && listed(u, w)) return false;
    take_out(f);
    result_.removed.add(f);
    for (const std::uint32_t u : {a, b, c}) touch(u);
    return true;
  }

  void rename_listed() {
    EntityList& edges = surface_.data().edges;
    if (renamed_.empty() || edges.empty()) return;
    std::unordered_map<std::uint32_t, std::uint32_t> name(renamed_.begin(), renamed_.end());
    for (std::uint32_t& v : edges.vertices)
      for (auto it = name.find(v); it != name.end(); it = name.find(v)) v = it->second;
    std::vector<std::uint8_t> keep(edges.size());
    std::vector<std::uint32_t> begin(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      begin[e] = 2 * e;
      keep[e] = edges.vertices[begin[e]] != edges.vertices[begin[e] + 1];
    }
    keep_entities(surface_.data(), 1, keep, begin);
  }

  Surface& surface_;
  Around around_;
  std::deque<std::uint32_t> queue_;
  std::unordered_set<std::uint32_t> waiting_;
  std::set<std::uint32_t> crowded_;  ///< vertices with something changed around them
  std::unordered_map<std::uint32_t, int> tries_;
  std::unordered_set<std::uint64_t> listed_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      renamed_;  ///< gone vertex, the one that stands for it
  ZeroArea result_;
};

}  // namespace

ZeroArea mend_zero_area(Surface& surface) {
  std::vector<std::uint32_t> flat;
  surface.each_face([&](std::uint32_t f) {
    const auto v = std::as_const(surface).vertices(f);
    if (v.size() == 3 &&
        collinear(surface.position(v[0]), surface.position(v[1]), surface.position(v[2])))
      flat.push_back(f);
  });
  if (flat.empty()) return {};
  return ZeroAreaMender(surface, flat).run(flat);
}

}  // namespace aomd::repair_detail
