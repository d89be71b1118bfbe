#include <algorithm>

#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// The round of vertices without sides of no length (a a) and sides gone forth and back (a b a):
// neither bounds anything, so that the neighbours fit the rest as they fitted the whole.
std::vector<std::uint32_t> reduced(std::span<const std::uint32_t> round) {
  std::vector<std::uint32_t> v(round.begin(), round.end());
  for (std::size_t k = 0; v.size() > 2 && k < v.size();) {
    const std::size_t n = v.size();
    if (v[k] == v[(k + 1) % n] || v[k] == v[(k + 2) % n]) {
      v.erase(v.begin() + static_cast<std::ptrdiff_t>((k + 1) % n));
      k = 0;
    } else {
      ++k;
    }
  }
  return v;
}

bool repeats(std::span<const std::uint32_t> v) {
  for (std::size_t k = 1; k < v.size(); ++k)
    if (std::find(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(k), v[k]) !=
        v.begin() + static_cast<std::ptrdiff_t>(k))
      return true;
  return false;
}

}  // namespace

RepeatedVertices mend_repeated_vertices(Surface& surface) {
  RepeatedVertices result;
  surface.each_face([&](std::uint32_t f) {
    if (!repeats(surface.vertices(f))) return;
    const auto rest = reduced(surface.vertices(f));
    if (rest.size() < 3) {
      surface.remove(f);
      result.removed.add(f);
    } else if (rest.size() <= 4) {
      surface.shrink(f, rest);
      result.shrunk.add(f);
    } else {
      result.left.add(f);  // two rounds on one vertex, or a polygon without a template
    }
  });
  return result;
}

}  // namespace aomd::repair_detail
