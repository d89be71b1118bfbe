// The parts of a surface at work at the same time, by the quality strategy.

#include "core/decimate/quality/quality_loop.h"

namespace aomd {

bool QualityLoop::parts_are_ready() {
  if (phase_ == Phase::Collapse) return rounds_.ready();
  return turns_.in_part() && corner_ == 0;
}

bool QualityLoop::advance_parts(const std::function<bool()>& cancelled) {
  if (done() || part_count_ == 1 || values_ || !surface_parts_may_share(mesh_, options_, guards_) ||
      !parts_are_ready())
    return false;
  if (phase_ == Phase::Swap) mesh_.build_hash(1);
  const std::size_t first = phase_ == Phase::Collapse ? rounds_.part() : turns_.part();
  const PartsAtOnce<Hand>::Work work{part_count_, first, options_.threads, cancelled};
  at_once_.need_hands(work, [&] { return std::make_unique<Hand>(mesh_); });
  const bool all_done = at_once_.run(
      mesh_, work, sweeps_.back(), [] {}, [&](Hand& hand) { return advance_part(hand); });
  if (all_done) end_parts();
  return true;
}

bool QualityLoop::advance_part(Hand& hand) {
  if (phase_ == Phase::Collapse) {
    const Vertex v = rounds_.next_of(hand.part);
    if (v.valid()) try_vertex(v, hand);
    return v.valid();
  }
  const std::uint32_t id = turns_.next_of(hand.part);
  if (id == no_index) return false;
  if (phase_ == Phase::Smooth)
    try_smooth(Vertex(id), hand);
  else
    for (const std::uint32_t corner : {0u, 1u, 2u}) swap_across(Face(id), corner, hand);
  return true;
}

void QualityLoop::end_parts() {
  if (phase_ == Phase::Collapse)
    rounds_.end_parts();
  else
    turns_.end_parts();
}

}  // namespace aomd
