#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <span>
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
constexpr std::uint8_t most_tries = 64;

// Faces around a vertex of more than these come up again together, when nothing else is left to do,
// and it becomes one with no other until it has fewer: looked at for each change there, they would
// take the square of their number.
constexpr std::size_t crowd = 512;

bool is_flat(const Surface& surface, std::uint32_t f) {
  const auto v = surface.vertices(f);
  return v.size() == 3 &&
         collinear(surface.position(v[0]), surface.position(v[1]), surface.position(v[2]));
}

class ZeroAreaMender {
 public:
  ZeroAreaMender(Surface& surface, std::vector<std::uint32_t> flat)
      : surface_(surface),
        around_(surface),
        queue_(flat.begin(), flat.end()),
        waiting_(surface.face_count(), 0),
        tries_(surface.face_count(), 0),
        flat_(surface.face_count(), 0) {
    for (const std::uint32_t f : flat) waiting_[f] = flat_[f] = 1;
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
      waiting_[f] = 0;
      if (tries_[f] == most_tries || !is_flat_face(f)) continue;
      ++tries_[f];
      static_cast<void>(collapse(f) || swap_side(f) || remove(f));
    }
    for (const std::uint32_t f : flat)
      if (is_flat_face(f)) result_.left.add(f);
    rename_listed();
    return std::move(result_);
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  // Known of each face: it changes where corners go to other places alone (`put`), and merged
  // vertices lie at one.
  [[nodiscard]] bool is_flat_face(std::uint32_t f) const {
    return surface_.alive(f) && flat_[f] != 0;
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
    const auto before = [&](std::size_t i, std::size_t j) {  // i < j
      const glm::dvec3 &p = surface_.position(v[i]), &q = surface_.position(v[j]);
      return std::tie(p.x, p.y, p.z) <= std::tie(q.x, q.y, q.z);
    };
    const bool b01 = before(0, 1), b02 = before(0, 2), b12 = before(1, 2);
    const std::size_t middle = b01 != b02 ? 0 : b01 == b12 ? 1 : 2;
    return {v[(middle + 2) % 3], v[middle], v[(middle + 1) % 3]};
  }

  // Whether a face, if it is flat, is to wait for another try.
  [[nodiscard]] bool comes_up(std::uint32_t f) const {
    return waiting_[f] == 0 && tries_[f] < most_tries;
  }

  [[nodiscard]] bool any_comes_up(std::uint32_t v) const {
    const auto at_v = around_.corners(v);
    return std::any_of(at_v.begin(), at_v.end(),
                       [&](std::uint32_t c) { return comes_up(surface_.face_of(c)); });
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
    for (const std::uint32_t c : around_.corners(v)) {
      const std::uint32_t f = surface_.face_of(c);
      if (!comes_up(f) || !is_flat_face(f)) continue;
      waiting_[f] = 1;
      queue_.push_back(f);
    }
  }

  void take_out(std::uint32_t f) {
    for (std::uint32_t k = 0; k < 3; ++k) around_.remove(surface_.first_corner(f) + k);
    surface_.remove(f);
  }

  void put(std::uint32_t f, const Corners& corners) {
    const std::uint32_t first = surface_.first_corner(f);
    for (std::uint32_t k = 0; k < 3; ++k) around_.remove(first + k);
    std::copy(corners.begin(), corners.end(), surface_.vertices(f).begin());
    for (std::uint32_t k = 0; k < 3; ++k) around_.add(first + k);
    flat_[f] = is_flat(surface_, f);
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

  [[nodiscard]] bool crowded(std::uint32_t v) const { return around_.count(v) > crowd; }

  // The link condition: nothing but the faces at the side becomes one with something else.
  [[nodiscard]] bool link_allows(std::uint32_t a, std::uint32_t b) const {
    const AtSide at_side = around_.at_side(a, b);
    if (at_side.count() == 0 || at_side.count() > 2) return false;
    std::vector<std::uint32_t> apexes;
    for (const std::uint32_t f : at_side.first()) {
      const auto v = std::as_const(surface_).vertices(f);
      if (v.size() != 3) return false;
      apexes.push_back(v[0] ^ v[1] ^ v[2] ^ a ^ b);
    }
    std::sort(apexes.begin(), apexes.end());
    return around_.faces(a, b).size() == at_side.count() && common_neighbours(a, b) == apexes &&
           border_allows(a, b, apexes) && !second_face(a, b);
  }

  [[nodiscard]] std::vector<std::uint32_t> common_neighbours(std::uint32_t a,
                                                             std::uint32_t b) const {
    if (around_.count(a) < around_.count(b)) std::swap(a, b);
    std::vector<std::uint32_t> common = around_.neighbours(b);
    std::erase_if(common,
                  [&](std::uint32_t v) { return v == a || around_.at_side(a, v).count() == 0; });
    return common;
  }

  // With the border as one more vertex that all its sides are joined to.
  [[nodiscard]] bool border_allows(std::uint32_t a, std::uint32_t b,
                                   const std::vector<std::uint32_t>& apexes) const {
    if (around_.count(a) < around_.count(b)) std::swap(a, b);
    if (apexes.size() == 2) return !(around_.at_border(b) && around_.at_border(a));
    return around_.at_side(a, apexes[0]).count() == 2 || around_.at_side(b, apexes[0]).count() == 2;
  }

  // Whether a face at one of the two would lie on one at the other.
  [[nodiscard]] bool second_face(std::uint32_t a, std::uint32_t b) const {
    if (around_.count(a) < around_.count(b)) std::swap(a, b);
    const auto at_b = around_.corners(b);
    return std::any_of(at_b.begin(), at_b.end(), [&](std::uint32_t c) {
      const auto v = std::as_const(surface_).vertices(surface_.face_of(c));
      return std::find(v.begin(), v.end(), a) == v.end() && has_face(a, v, b);
    });
  }

  // Whether a face at a has the vertices of another at b, but for b itself.
  [[nodiscard]] bool has_face(std::uint32_t a, std::span<const std::uint32_t> v,
                              std::uint32_t b) const {
    const std::vector<std::uint32_t> others = around_.faces(a, v[0] == b ? v[1] : v[0]);
    return std::any_of(others.begin(), others.end(), [&](std::uint32_t g) {
      const auto u = std::as_const(surface_).vertices(g);
      return u.size() == v.size() && std::all_of(v.begin(), v.end(), [&](std::uint32_t w) {
               return w == b || std::find(u.begin(), u.end(), w) != u.end();
             });
    });
  }

  void merge(std::uint32_t stays, std::uint32_t goes) {
    const AtSide both = around_.at_side(stays, goes);
    for (const std::uint32_t f : both.first()) take_out(f);
    const auto at_goes = around_.corners(goes);
    for (const std::uint32_t c : std::vector(at_goes.begin(), at_goes.end())) {
      around_.remove(c);
      surface_.set_vertex(c, stays);
      around_.add(c);
    }
    renamed_.emplace_back(goes, stays);
    std::vector<std::uint32_t> near = around_.met(stays);
    if (!listed_.empty())
      for (const std::uint32_t v : near)
        if (listed(goes, v)) listed_.insert(edge_key(stays, v));
    std::erase_if(near, [&](std::uint32_t v) { return !crowded(v) && !any_comes_up(v); });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t v : near) touch(v);
  }

  // The neighbour's longest side and ours are one, and the vertex between its ends divides it:
  //      d             d
  //     / \           /|\      .
  //    /   \   ->    / | \     .
  //   a--b--c       a--b--c
  bool swap_side(std::uint32_t f) {
    const auto [a, b, c] = round_middle(f);
    const AtSide at_side = around_.at_side(a, c);
    if (at_side.count() != 2 || listed(a, c) || coincide(a, b) || coincide(b, c)) return false;
    const std::uint32_t g = at_side.first()[at_side.first()[0] == f ? 1 : 0];
    const auto v = std::as_const(surface_).vertices(g);
    if (v.size() != 3) return false;
    const std::uint32_t d = v[0] ^ v[1] ^ v[2] ^ a ^ c;
    const auto from = static_cast<std::size_t>(std::find(v.begin(), v.end(), a) - v.begin());
    if (v[(from + 1) % 3] != c || d == b || around_.meet(b, d)) return false;
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
      return around_.at_side(u, w).count() == 1;
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
  std::vector<std::uint8_t> waiting_;  ///< 1: in the queue
  std::set<std::uint32_t> crowded_;    ///< vertices with something changed around them
  std::vector<std::uint8_t> tries_;
  std::vector<std::uint8_t> flat_;  ///< 1: a triangle without area
  std::unordered_set<std::uint64_t> listed_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      renamed_;  ///< gone vertex, the one that stands for it
  ZeroArea result_;
};

}  // namespace

ZeroArea mend_zero_area(Surface& surface) {
  std::vector<std::uint32_t> flat;
  surface.each_face([&](std::uint32_t f) {
    if (is_flat(surface, f)) flat.push_back(f);
  });
  if (flat.empty()) return {};
  return ZeroAreaMender(surface, flat).run(flat);
}

}  // namespace aomd::repair_detail
