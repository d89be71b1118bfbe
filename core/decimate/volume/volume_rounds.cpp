#include "core/decimate/volume/volume_rounds.h"

#include <algorithm>
#include <limits>

namespace aomd {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
// Of collapses to go, or of vertices that wait, for each part: fewer are not worth sharing out.
constexpr std::uint64_t fewest_each = 8;
// More tetrahedra than go with a collapse.
constexpr std::uint64_t most_regions_each = 32;

}  // namespace

void VolumeRounds::begin(std::uint32_t goal, std::size_t parts) {
  goal_ = goal;
  parts_.clear();
  if (parts > 1) parts_.resize(parts);
  turn_ = parts_.size();
  left_.clear();
  next_left_ = 0;
}

Vertex VolumeRounds::next() {
  if (parts_.empty()) return reached() ? Vertex() : queue_.pop();
  do {
    for (; in_part(); ++turn_) {
      if (const Vertex v = next_of(turn_); v.valid()) return v;
      if (turn_ + 1 == parts_.size()) end_parts();
    }
    if (const Vertex v = next_left(); v.valid()) return v;
  } while (begin_round());
  return {};
}

bool VolumeRounds::ready() {
  if (parts_.empty()) return false;
  if (in_part()) return true;
  return next_left_ == left_.size() && begin_round() && in_part();
}

// The vertices that are left to who comes after will take away as many regions each as the others
// have: so both go equally far through the bucket where the target ends it.
Vertex VolumeRounds::next_of(std::size_t part) {
  Part& p = parts_[part];
  const std::uint64_t made = p.seen - std::min<std::uint64_t>(p.seen, p.left.size());
  const double all = made > 0 ? double(p.taken) * double(p.seen) / double(made) : 0;
  if (all + most_regions_each > double(p.share)) return {};
  ++p.seen;
  return queue_.pop(part, bucket_);
}

// A vertex may have been left more than once, have gone meanwhile, or be back in the queue.
Vertex VolumeRounds::next_left() {
  while (next_left_ < left_.size() && !reached()) {
    const Vertex v = left_[next_left_++];
    if (mesh_.alive(v) && !queue_.holds(v)) return v;
  }
  return {};
}

void VolumeRounds::end_parts() {
  left_.clear();
  next_left_ = 0;
  for (Part& p : parts_) {
    left_.insert(left_.end(), p.left.begin(), p.left.end());
    p.left.clear();
  }
  std::sort(left_.begin(), left_.end());
  left_.erase(std::unique(left_.begin(), left_.end()), left_.end());
  turn_ = parts_.size();
}

bool VolumeRounds::begin_round() {
  std::uint32_t lowest = VertexQueue::no_bucket;
  for (std::size_t i = 0; i < parts_.size(); ++i) lowest = std::min(lowest, queue_.lowest(i));
  if (reached() || lowest == VertexQueue::no_bucket) return false;
  bucket_ = lowest;
  std::uint64_t waiting = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    queue_.leave_bucket(i);
    parts_[i].taken = parts_[i].seen = 0;
    parts_[i].share = queue_.waiting(i, lowest, lowest);
    waiting += parts_[i].share;
  }
  share_out(goal_ > 0 ? mesh_.count(3) - goal_ : no_limit, waiting);
  return true;
}

void VolumeRounds::share_out(std::uint64_t regions, std::uint64_t waiting) {
  turn_ = 0;
  if (std::min(regions / most_regions_each, waiting) >= fewest_each * parts_.size()) {
    for (Part& p : parts_) p.share = goal_ > 0 ? regions * p.share / waiting : no_limit;
    return;
  }
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (Vertex v = queue_.pop(i, bucket_); v.valid(); v = queue_.pop(i, bucket_)) leave(i, v);
  end_parts();
}

}  // namespace aomd
