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
  corners_.resize(begin_.back());
  std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
  surface.each_corner([&](std::uint32_t c) { corners_[at[surface.vertex(c)]++] = c; });
}

std::span<const std::uint32_t> Around::corners(std::uint32_t v) const {
  if (changed_at_.empty() || changed_at_[v] == no_index)
    return std::span(corners_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  Row& row = rows_[changed_at_[v]];
  if (row.gaps > 0) close_gaps(row);
  return row.corners;
}

std::size_t Around::count(std::uint32_t v) const {
  if (changed_at_.empty() || changed_at_[v] == no_index) return begin_[v + 1] - begin_[v];
  const Row& row = rows_[changed_at_[v]];
  return row.corners.size() - row.gaps;
}

void Around::add(std::uint32_t corner) {
  Row& row = changed(surface_.vertex(corner));
  place_[corner] = static_cast<std::uint32_t>(row.corners.size());
  row.corners.push_back(corner);
}

void Around::remove(std::uint32_t corner) {
  Row& row = changed(surface_.vertex(corner));
  row.corners[place_[corner]] = no_index;
  ++row.gaps;
}

void Around::close_gaps(Row& row) const {
  std::erase(row.corners, no_index);
  row.gaps = 0;
  for (std::uint32_t i = 0; i < row.corners.size(); ++i) place_[row.corners[i]] = i;
}

Around::Row& Around::changed(std::uint32_t v) {
  if (changed_at_.empty()) {
    changed_at_.assign(surface_.vertex_count(), no_index);
    place_.assign(surface_.corner_count(), no_index);
  }
  if (changed_at_[v] == no_index) {
    changed_at_[v] = static_cast<std::uint32_t>(rows_.size());
    rows_.push_back({{corners_.begin() + begin_[v], corners_.begin() + begin_[v + 1]}});
    close_gaps(rows_.back());
  }
  return rows_[changed_at_[v]];
}

template <typename Visit>
void Around::each_face(std::uint32_t a, std::uint32_t b, Visit&& visit) const {
  if (count(b) < count(a)) std::swap(a, b);
  for (const std::uint32_t c : corners(a)) {
    const std::uint32_t f = surface_.face_of(c);
    if (const auto v = surface_.vertices(f); std::find(v.begin(), v.end(), b) != v.end()) visit(f);
  }
}

std::vector<std::uint32_t> Around::faces(std::uint32_t a, std::uint32_t b) const {
  std::vector<std::uint32_t> both;
  each_face(a, b, [&](std::uint32_t f) { both.push_back(f); });
  return both;
}

bool Around::meet(std::uint32_t a, std::uint32_t b) const {
  if (count(b) < count(a)) std::swap(a, b);
  const auto at_a = corners(a);
  return std::any_of(at_a.begin(), at_a.end(), [&](std::uint32_t c) {
    const auto v = surface_.vertices(surface_.face_of(c));
    return std::find(v.begin(), v.end(), b) != v.end();
  });
}

AtSide Around::at_side(std::uint32_t a, std::uint32_t b) const {
  AtSide side;
  each_face(a, b, [&](std::uint32_t f) {
    const auto v = surface_.vertices(f);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (edge_key(v[k], v[(k + 1) % v.size()]) == edge_key(a, b)) return side.add(f);
  });
  return side;
}

// Both neighbours in each face at v: one that is met once only lies at the border.
std::vector<std::uint32_t> Around::met(std::uint32_t v) const {
  std::vector<std::uint32_t> result;
  result.reserve(2 * count(v));
  for (const std::uint32_t c : corners(v)) {
    const std::uint32_t f = surface_.face_of(c);
    const auto u = surface_.vertices(f);
    const std::size_t at = c - surface_.first_corner(f);
    result.push_back(u[at + 1 < u.size() ? at + 1 : 0]);
    result.push_back(u[at > 0 ? at - 1 : u.size() - 1]);
  }
  return result;
}

std::vector<std::uint32_t> Around::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> result = met(v);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool Around::at_border(std::uint32_t v) const {
  std::vector<std::uint32_t> all = met(v);
  std::sort(all.begin(), all.end());
  for (auto i = all.begin(), j = i; i != all.end(); i = j) {
    j = std::find_if(i, all.end(), [&](std::uint32_t u) { return u != *i; });
    if (j - i == 1) return true;
  }
  return false;
}

}  // namespace aomd::repair_detail
