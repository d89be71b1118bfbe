#include "core/io/weld.h"

#include "core/repair/stages.h"

namespace aomd::repair_detail {

Weld::Weld(Surface& surface) : given_(surface.data().faces.vertices) {
  io::detail::Welder welder;
  std::vector<std::uint32_t> first;
  merged_.resize(surface.vertex_count());
  for (std::uint32_t v = 0; v < merged_.size(); ++v) {
    const std::uint32_t point = welder.add(surface.position(v));
    if (point == first.size()) first.push_back(v);
    merged_[v] = first[point];
  }
  for (std::uint32_t& v : surface.data().faces.vertices) v = merged_[v];
}

// Corners may have changed places in their face since.
std::uint32_t Weld::given_at(const Surface& surface, std::uint32_t corner) const {
  const std::uint32_t v = surface.vertex(corner);
  if (!on()) return v;
  std::uint32_t c = surface.first_corner(surface.face_of(corner));
  while (merged_[given_[c]] != v) ++c;
  return given_[c];
}

}  // namespace aomd::repair_detail
