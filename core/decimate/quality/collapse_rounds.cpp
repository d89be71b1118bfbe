#include "core/decimate/quality/collapse_rounds.h"

#include <algorithm>
#include <limits>

#include "core/decimate/quality/collapse_queue.h"
#include "core/decimate/quality/vertex_queue.h"

namespace aomd {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
// Of collapses to go, or of vertices that wait, for each part: fewer are not worth sharing out.
constexpr std::uint64_t few = 8;
// More times what is to be left: there a part may go through many buckets at once.
constexpr std::uint64_t far_above = 3;

}  // namespace

template <typename Queue>
void CollapseRounds<Queue>::begin(std::uint32_t goal, std::size_t parts) {
  goal_ = goal;
  parts_.clear();
  if (parts > 1) parts_.resize(parts);
  turn_ = parts_.size();
  left_.clear();
  next_left_ = 0;
}

template <typename Queue>
Vertex CollapseRounds<Queue>::next() {
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

template <typename Queue>
bool CollapseRounds<Queue>::ready() {
  if (parts_.empty()) return false;
  if (in_part()) return true;
  return next_left_ == left_.size() && begin_round() && in_part();
}

// The vertices that are left to who comes after will take away as much each as the others have: so
// both go equally far through the bucket where the target ends it.
template <typename Queue>
Vertex CollapseRounds<Queue>::next_of(std::size_t part) {
  Part& p = parts_[part];
  const std::uint64_t made = p.seen - std::min<std::uint64_t>(p.seen, p.left.size());
  const double all = made > 0 ? double(p.taken) * double(p.seen) / double(made) : 0;
  if (all + double(rules_.most_each) > double(p.share)) return {};
  ++p.seen;
  return queue_.pop(part, bucket_);
}

// A vertex may have been left more than once, have gone meanwhile, or be back in the queue.
template <typename Queue>
Vertex CollapseRounds<Queue>::next_left() {
  while (next_left_ < left_.size() && !reached()) {
    const Vertex v = left_[next_left_++];
    if (mesh_.alive(v) && !queue_.holds(v)) return v;
  }
  return {};
}

template <typename Queue>
void CollapseRounds<Queue>::end_parts() {
  left_.clear();
  next_left_ = 0;
  for (Part& p : parts_) {
    left_.insert(left_.end(), p.left.begin(), p.left.end());
    p.left.clear();
  }
  std::sort(left_.begin(), left_.end());
  left_.erase(std::unique(left_.begin(), left_.end()), left_.end());
  if constexpr (requires { queue_.even_out_levels(); }) queue_.even_out_levels();
  turn_ = parts_.size();
}

template <typename Queue>
std::uint32_t CollapseRounds<Queue>::lowest_bucket() {
  std::uint32_t lowest = VertexQueue::no_bucket;
  for (std::size_t i = 0; i < parts_.size(); ++i) lowest = std::min(lowest, queue_.lowest(i));
  return lowest;
}

template <typename Queue>
bool CollapseRounds<Queue>::begin_round() {
  const std::uint32_t lowest = lowest_bucket();
  if (reached() || lowest == VertexQueue::no_bucket) return false;
  bucket_ = lowest;
  const std::uint64_t most = may_go();
  std::uint64_t waiting = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    queue_.leave_bucket(i);
    parts_[i].taken = parts_[i].seen = 0;
    parts_[i].share = queue_.waiting(i, lowest, bucket_);
    waiting += parts_[i].share;
  }
  share_out(most, waiting);
  return true;
}

// How many faces or regions the round may take away; where that is many, it goes through more
// buckets. Far above the goal costs are far below those at the end, and which of them comes first
// does not matter.
template <typename Queue>
std::uint64_t CollapseRounds<Queue>::may_go() {
  if (goal_ == 0) return unlimited;
  const std::uint64_t count = mesh_.count(rules_.dimension), far = far_above * goal_;
  if (rules_.buckets_far_off == 1 || count <= far + few * parts_.size()) return count - goal_;
  bucket_ = std::min(bucket_ + rules_.buckets_far_off, VertexQueue::no_bucket) - 1;
  return count - far;
}

template <typename Queue>
void CollapseRounds<Queue>::share_out(std::uint64_t most, std::uint64_t waiting) {
  turn_ = 0;
  if (std::min(most / rules_.most_each, waiting) >= few * parts_.size()) {
    for (Part& p : parts_) p.share = goal_ > 0 ? most * p.share / waiting : unlimited;
    return;
  }
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (Vertex v = queue_.pop(i, bucket_); v.valid(); v = queue_.pop(i, bucket_)) leave(i, v);
  end_parts();
}

template class CollapseRounds<VertexQueue>;
template class CollapseRounds<CollapseQueue>;

}  // namespace aomd
