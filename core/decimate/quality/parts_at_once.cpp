// The parts of a surface at work at the same time, by the quality strategy.

#include "core/decimate/quality/quality_loop.h"

namespace aomd {

bool QualityLoop::parts_are_ready() {
  if (phase_ == Phase::Collapse) return rounds_.ready();
  return turns_.in_part() && corner_ == 0;
}

bool QualityLoop::advance_parts(const std::function<bool()>& cancelled) {
  using Outcome = PartsAtOnce<Hand>::Outcome;
  if (done() || part_count_ == 1 || values_ || !parts_may_share(mesh_, options_, guards_) ||
      !parts_are_ready())
    return false;
  if (phase_ == Phase::Swap) mesh_.build_hash(1);
  Outcome outcome{};
  do {
    at_once_.begin(mesh_, part_count_, options_.threads,
                   [&] { return std::make_unique<Hand>(mesh_); });
    outcome = at_once_.run(
        phase_ == Phase::Collapse ? rounds_.part() : turns_.part(),
        [&](Hand& hand) { return advance_part(hand); }, cancelled);
  } while (outcome == Outcome::WantsRoom);
  at_once_.settle(mesh_, sweeps_.back());
  if (outcome == Outcome::Done) end_parts();
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
