#include "core/repair/around.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/repair/connectivity.h"

namespace aomd::repair_detail {

Around::Around(const Surface& surface)
    : surface_(surface), begin_(surface.vertex_count() + std::size_t{1}, 0) {
  surface.each_corner([&](std::uint32_t c) { ++begin_[surface.vertex(c) + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  faces_.resize(begin_.back());
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  surface.each_corner(
      [&](std::uint32_t c) { faces_[at[surface.vertex(c)]++] = surface.face_of(c); });
}

std::span<const std::uint32_t> Around::faces(std::uint32_t v) const {
  const auto it = changed_.find(v);
  if (it != changed_.end()) return it->second;
  return std::span(faces_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
}

std::vector<std::uint32_t>& Around::changed(std::uint32_t v) {
  const auto [it, fresh] = changed_.try_emplace(v);
  if (fresh) it->second.assign(faces_.begin() + begin_[v], faces_.begin() + begin_[v + 1]);
  return it->second;
}

std::vector<std::uint32_t> Around::faces(std::uint32_t a, std::uint32_t b) const {
  if (faces(b).size() < faces(a).size()) std::swap(a, b);
  std::vector<std::uint32_t> both;
  for (const std::uint32_t f : faces(a))
    if (const auto v = surface_.vertices(f); std::find(v.begin(), v.end(), b) != v.end())
      both.push_back(f);
  return both;
}

std::vector<std::uint32_t> Around::at_side(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> both = faces(a, b);
  std::erase_if(both, [&](std::uint32_t f) {
    const auto v = surface_.vertices(f);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (edge_key(v[k], v[(k + 1) % v.size()]) == edge_key(a, b)) return false;
    return true;
  });
  return both;
}

// Both neighbours in each face at v: one that is met once only lies at the border.
std::vector<std::uint32_t> Around::met(std::uint32_t v) const {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t f : faces(v)) {
    const auto u = surface_.vertices(f);
    const auto at = static_cast<std::size_t>(std::find(u.begin(), u.end(), v) - u.begin());
    result.push_back(u[(at + 1) % u.size()]);
    result.push_back(u[(at + u.size() - 1) % u.size()]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::uint32_t> Around::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> result = met(v);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool Around::at_border(std::uint32_t v) const {
  const std::vector<std::uint32_t> all = met(v);
  for (auto i = all.begin(), j = i; i != all.end(); i = j) {
    j = std::find_if(i, all.end(), [&](std::uint32_t u) { return u != *i; });
    if (j - i == 1) return true;
  }
  return false;
}

}  // namespace aomd::repair_detail
