#include "core/io/weld.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/box.h"
#include "core/repair/around.h"
#include "core/repair/near_points.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// Border vertices within a tolerance of one that stands for them.
class BorderWeld {
 public:
  BorderWeld(const Surface& surface, double tolerance)
      : surface_(surface), around_(surface), tolerance_(tolerance), standing_(tolerance) {
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) stands_for_.push_back(v);
  }

  // In ascending order: a vertex goes to the nearest that stands within the tolerance, of equally
  // near ones to the first, and else stands itself. So none moves further than the tolerance, and
  // nothing is passed on from one to the next.
  void run() {
    for (const std::uint32_t v : border_vertices(surface_)) {
      const std::uint32_t other = nearest(v);
      if (other == no_index)
        standing_.add(v, surface_.position(v));
      else
        stands_for_[v] = other;
    }
  }
  [[nodiscard]] std::uint32_t stands_for(std::uint32_t v) const { return stands_for_[v]; }
  [[nodiscard]] const Tally& refused() const { return refused_; }

 private:
  // Never one that stands for another corner of a face at v: the face would lose a corner.
  [[nodiscard]] std::uint32_t nearest(std::uint32_t v) {
    const std::vector<std::uint32_t> taboo = in_its_faces(v);
    std::uint32_t best = no_index;
    double least = tolerance_;
    bool refused = false;
    standing_.each_near(surface_.position(v), [&](std::uint32_t other) {
      const double d = glm::distance(surface_.position(v), surface_.position(other));
      if (!(d <= least) || (d == least && best != no_index && other > best)) return;
      if (std::binary_search(taboo.begin(), taboo.end(), other)) return void(refused = true);
      best = other;
      least = d;
    });
    if (refused && best == no_index) refused_.add(v);
    return best;
  }

  [[nodiscard]] std::vector<std::uint32_t> in_its_faces(std::uint32_t v) const {
    std::vector<std::uint32_t> others;
    for (const std::uint32_t c : around_.corners(v))
      for (const std::uint32_t u : surface_.vertices(surface_.face_of(c)))
        others.push_back(stands_for_[u]);
    std::sort(others.begin(), others.end());
    return others;
  }

  const Surface& surface_;
  Around around_;
  double tolerance_;
  NearPoints standing_;
  std::vector<std::uint32_t> stands_for_;
  Tally refused_;
};

}  // namespace

std::vector<std::uint32_t> border_vertices(const Surface& surface) {
  std::vector<std::uint32_t> result;
  EdgeUses(surface).each([&](std::span<const EdgeUses::Use> uses) {
    const std::uint32_t c = uses[0].corner();
    if (uses.size() == 1)
      result.insert(result.end(), {surface.vertex(c), surface.vertex(surface.next(c))});
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Weld::Weld(Surface& surface, double tolerance) : given_(surface.data().faces.vertices) {
  io::detail::Welder welder;
  std::vector<std::uint32_t> first;
  merged_.resize(surface.vertex_count());
  for (std::uint32_t v = 0; v < merged_.size(); ++v) {
    const std::uint32_t point = welder.add(surface.position(v));
    if (point == first.size()) first.push_back(v);
    merged_[v] = first[point];
  }
  rename_corners(surface);
  Box box;
  surface.each_corner([&](std::uint32_t c) { box.add(surface.position(surface.vertex(c))); });
  if (!(tolerance > least_tolerance * box.diagonal())) return;  // equal points are all there is
  BorderWeld near(surface, tolerance);
  near.run();
  for (std::uint32_t& v : merged_) v = near.stands_for(v);
  refused_ = near.refused();
  moves_ = true;
  rename_corners(surface);
}

void Weld::rename_corners(Surface& surface) const {
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
