#include "core/fields/same_place.h"

#include <algorithm>
#include <bit>

#include "core/base/buckets.h"

namespace aomd::fields {
namespace {

bool before(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Tells most places that are not among some from those that are.
class PlaceFilter {
 public:
  explicit PlaceFilter(const std::vector<glm::dvec3>& places) : marked_(16 * places.size() + 1) {
    for (const glm::dvec3& p : places) marked_[slot_of(p)] = true;
  }
  [[nodiscard]] bool may_hold(const glm::dvec3& p) const { return marked_[slot_of(p)]; }

 private:
  // Adding 0 makes both zeros one.
  [[nodiscard]] std::size_t slot_of(const glm::dvec3& p) const {
    std::uint64_t mixed = 0;
    for (const double x : {p.x, p.y, p.z})
      mixed = (mixed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;
    return (mixed >> 20) % marked_.size();
  }

  std::vector<bool> marked_;
};

using Row = std::vector<std::uint32_t>;

/// Cells by their smallest vertex.
Buckets<std::uint32_t> by_smallest(const Cells& cells) {
  return {cells.mesh().positions.size(), [&](auto&& file) {
            for (std::uint32_t i = 0; i < cells.size(); ++i)
              file(std::ranges::min(cells.vertices(i)), i);
          }};
}

}  // namespace

// Most vertices of an original are gone from its result: those are not sorted.
SameVertices::SameVertices(const MeshData& original, const MeshData& result) {
  const std::vector<glm::dvec3>& places = original.positions;
  const PlaceFilter stays(result.positions);
  for (std::uint32_t v = 0; v < places.size(); ++v)
    if (stays.may_hold(places[v])) sorted_.push_back(v);
  std::sort(sorted_.begin(), sorted_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return places[a] == places[b] ? a < b : before(places[a], places[b]);
  });
  first_.reserve(result.positions.size());
  count_.reserve(result.positions.size());
  for (const glm::dvec3& p : result.positions) {
    const auto from = std::lower_bound(
        sorted_.begin(), sorted_.end(), p,
        [&](std::uint32_t v, const glm::dvec3& q) { return before(places[v], q); });
    auto to = from;
    while (to != sorted_.end() && places[*to] == p) ++to;
    first_.push_back(static_cast<std::uint32_t>(from - sorted_.begin()));
    count_.push_back(static_cast<std::uint32_t>(to - from));
  }
}

std::vector<std::uint32_t> same_cells(const Cells& original, const Cells& result,
                                      const SameVertices& vertices) {
  const Buckets<std::uint32_t> known = by_smallest(original);
  std::vector<std::uint32_t> same(result.size(), no_index);
  Row wanted, found;
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    wanted.clear();
    for (const std::uint32_t v : result.vertices(i)) wanted.push_back(vertices.only(v));
    std::sort(wanted.begin(), wanted.end());
    if (wanted.back() == no_index) continue;
    for (const std::uint32_t k : known[wanted.front()]) {
      const auto corners = original.vertices(k);
      found.assign(corners.begin(), corners.end());
      std::sort(found.begin(), found.end());
      if (found != wanted || original.shape(k) != result.shape(i)) continue;
      same[i] = k;
      break;
    }
  }
  return same;
}

}  // namespace aomd::fields
