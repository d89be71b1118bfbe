// The parts of a volume at work at the same time, each on a thread.

#include <algorithm>

#include "core/base/parallel.h"
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

// What else would have to follow each operation at once: then the parts take their turns one by
// one.
bool VolumeQualityLoop::parts_may_share() const {
  return options_.threads > 1 && part_count_ > 1 && !guards_.any() && SharedEdits::possible(mesh_);
}

bool VolumeQualityLoop::parts_are_ready() {
  if (phase_ == Phase::Collapse) return rounds_.ready();
  return phase_ == Phase::Smooth && settling_ == 0 && turns_.in_part();
}

std::size_t VolumeQualityLoop::part_in_turn() const {
  return phase_ == Phase::Collapse ? rounds_.part() : turns_.part();
}

void VolumeQualityLoop::end_parts() {
  if (phase_ == Phase::Collapse)
    rounds_.end_parts();
  else
    turns_.end_parts();
}

// A part that has used up its room goes on when all have new room. Who is cancelled begins no other
// part, but ends those that were begun: regions that come later get the ids that went last, and so
// what follows does not depend on where it was cancelled.
bool VolumeQualityLoop::advance_parts(const std::function<bool()>& cancelled) {
  if (done() || !parts_may_share() || !parts_are_ready()) return false;
  const std::size_t hands = std::min(std::size_t(options_.threads), part_count_);
  while (hands_.size() < hands) hands_.push_back(std::make_unique<Hand>(mesh_));
  SharedParts shared{.cancelled = cancelled, .end = part_count_};
  for (bool first = true; first || shared.wants_room; first = false) {
    SharedEdits::begin(mesh_, part_count_, edits_);
    shared.next = part_in_turn();
    shared.wants_room = false;
    shared.may_stop = first;
    parallel_for(hands, options_.threads, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) work_on_parts(*hands_[i], i == 0, shared);
    });
    shared.end = std::min(shared.end, shared.next.load());
  }
  SharedEdits::settle(mesh_, edits_);
  for (const auto& hand : hands_) take_count(*hand);
  if (shared.end == part_count_) end_parts();
  return true;
}

void VolumeQualityLoop::work_on_parts(Hand& hand, bool may_ask, SharedParts& shared) {
  constexpr int candidates_between_checks = 64;
  hand.within_part = true;
  while (!(shared.may_stop && shared.stopped)) {
    hand.part = shared.next++;
    if (hand.part >= shared.end) return;
    hand.edits = &edits_[hand.part];
    bool goes_on = true;
    for (int i = 1; goes_on; ++i) {
      if (may_ask && i % candidates_between_checks == 0 && shared.cancelled && shared.cancelled())
        shared.stopped = true;
      goes_on = hand.edits->has_room();
      if (!goes_on) shared.wants_room = true;
      goes_on = goes_on && advance_part(hand);
    }
  }
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

void VolumeQualityLoop::take_count(Hand& hand) {
  SweepStatistics& sweep = sweeps_.back();
  sweep.collapses += hand.made.collapses;
  sweep.smooths += hand.made.smooths;
  for (std::size_t i = 0; i < sweep.refused.size(); ++i) sweep.refused[i] += hand.made.refused[i];
  waiting_ = waiting_ || hand.waits;
  hand.made = {};
  hand.waits = false;
}

}  // namespace aomd
