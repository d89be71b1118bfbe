// The parts of a volume at work at the same time, each on a thread.

#include <algorithm>
#include <utility>

#include "core/decimate/volume/volume_quality_loop.h"
#include "core/parts/partition.h"

namespace aomd {

// A large volume stays in parts when it has become smaller: they are what threads share.
std::size_t VolumeQualityLoop::parts_now() const {
  constexpr std::uint32_t fewest_regions = 200'000, regions_a_part = 50'000;
  constexpr std::size_t fewest_parts = 4;
  if (options_.parts > 0)
    return std::min<std::size_t>(std::size_t(options_.parts), Partition::most_parts);
  if (start_regions_ < fewest_regions) return 1;
  return std::clamp<std::size_t>(mesh_.count(3) / regions_a_part, fewest_parts,
                                 Partition::most_parts);
}

bool VolumeQualityLoop::parts_are_ready() {
  if (phase_ == Phase::Collapse) return rounds_.ready();
  return phase_ == Phase::Smooth && settling_ == 0 && turns_.in_part();
}

void VolumeQualityLoop::end_parts() {
  if (phase_ == Phase::Collapse)
    rounds_.end_parts();
  else
    turns_.end_parts();
}

bool VolumeQualityLoop::advance_parts(const std::function<bool()>& cancelled) {
  if (done() || part_count_ == 1 || !parts_may_share(mesh_, options_, guards_) ||
      !parts_are_ready())
    return false;
  const std::size_t first = phase_ == Phase::Collapse ? rounds_.part() : turns_.part();
  const PartsAtOnce<Hand>::Work work{part_count_, first, options_.threads, cancelled};
  at_once_.need_hands(work, [&] { return std::make_unique<Hand>(mesh_); });
  const bool all_done = at_once_.run(
      mesh_, work, sweeps_.back(), [] {}, [&](Hand& hand) { return advance_part(hand); });
  for (const auto& hand : at_once_.hands())
    waiting_ = std::exchange(hand->waits, false) || waiting_;
  if (all_done) end_parts();
  return true;
}

bool VolumeQualityLoop::advance_part(Hand& hand) {
  if (phase_ == Phase::Collapse) {
    const Vertex v = rounds_.next_of(hand.part);
    if (v.valid()) try_vertex(v, hand);
    return v.valid();
  }
  const std::uint32_t id = turns_.next_of(hand.part);
  if (id == no_index) return false;
  smooth_in_turn(Vertex(id), hand);
  return true;
}

}  // namespace aomd
