// The parts of a surface at work at the same time, each on a thread.

#include <algorithm>

#include "core/base/parallel.h"
#include "core/decimate/quality/quality_loop.h"

namespace aomd {

// What else would have to follow each operation at once: then the parts take their turns one by
// one.
bool QualityLoop::parts_may_share() const {
  return options_.threads > 1 && part_count_ > 1 && !guards_.any() && !options_.model && !values_ &&
         options_.topology == TopologyRule::Safe && SharedEdits::possible(mesh_);
}

bool QualityLoop::parts_are_ready() {
  if (phase_ == Phase::Collapse) return rounds_.ready();
  return turns_.in_part() && corner_ == 0;
}

// A part that has used up its room goes on when all have new room.
bool QualityLoop::advance_parts(const std::function<bool()>& cancelled) {
  if (done() || !parts_may_share() || !parts_are_ready()) return false;
  if (phase_ == Phase::Swap) mesh_.build_hash(1);
  const std::size_t hands = std::min(std::size_t(options_.threads), part_count_);
  while (hands_.size() < hands) hands_.push_back(std::make_unique<Hand>(mesh_));
  PartsWork work{.cancelled = cancelled};
  do {
    SharedEdits::begin(mesh_, part_count_, edits_);
    work.next = phase_ == Phase::Collapse ? rounds_.part() : turns_.part();
    work.wants_room = false;
    parallel_for(hands, options_.threads, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) work_on_parts(*hands_[i], i == 0, work);
    });
  } while (work.wants_room && !work.stopped);
  SharedEdits::settle(mesh_, edits_);
  for (const auto& hand : hands_) take_count(*hand);
  if (!work.stopped) end_parts();
  return true;
}

void QualityLoop::work_on_parts(Hand& hand, bool may_ask, PartsWork& work) {
  constexpr int candidates_between_checks = 64;
  hand.within_part = true;
  for (hand.part = work.next++; hand.part < part_count_; hand.part = work.next++) {
    hand.edits = &edits_[hand.part];
    bool goes_on = true;
    for (int i = 1; goes_on && !work.stopped; ++i) {
      if (may_ask && i % candidates_between_checks == 0 && work.cancelled && work.cancelled())
        work.stopped = true;
      goes_on = hand.edits->has_room();
      if (!goes_on) work.wants_room = true;
      goes_on = goes_on && advance_part(hand);
    }
  }
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

void QualityLoop::take_count(Hand& hand) {
  SweepStatistics& sweep = sweeps_.back();
  sweep.collapses += hand.made.collapses;
  sweep.swaps += hand.made.swaps;
  sweep.smooths += hand.made.smooths;
  for (std::size_t i = 0; i < sweep.refused.size(); ++i) sweep.refused[i] += hand.made.refused[i];
  hand.made = {};
}

}  // namespace aomd
