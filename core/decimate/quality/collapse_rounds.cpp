#include "core/decimate/quality/collapse_rounds.h"

#include <algorithm>
#include <limits>

namespace aomd {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
// Of faces to go, or of vertices that wait, for each part: fewer are not worth sharing out.
constexpr std::uint64_t few = 8;
// More times the faces that are to be left: there a part may go through many buckets at once.
constexpr std::uint64_t far_above = 3;
constexpr std::uint32_t buckets_at_once = 16;  // eight octaves

}  // namespace

void CollapseRounds::begin(std::uint32_t goal) {
  goal_ = goal;
  parts_.clear();
  if (partition_.count() > 1) parts_.resize(partition_.count());
  turn_ = parts_.size();
  left_.clear();
  next_left_ = 0;
}

Vertex CollapseRounds::next() {
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

bool CollapseRounds::ready() {
  if (parts_.empty()) return false;
  if (in_part()) return true;
  return next_left_ == left_.size() && begin_round() && in_part();
}

// Two faces go with most collapses, and some with each vertex that is left to the seam.
Vertex CollapseRounds::next_of(std::size_t part) {
  constexpr std::uint64_t faces_each = 2;
  const Part& p = parts_[part];
  const bool done = p.taken + faces_each * (p.left.size() + 1) > p.share;
  return done ? Vertex() : queue_.pop(part, bucket_);
}

// A vertex may have been left more than once, have gone meanwhile, or be back in the queue.
Vertex CollapseRounds::next_left() {
  while (next_left_ < left_.size() && !reached()) {
    const Vertex v = left_[next_left_++];
    if (mesh_.alive(v) && !queue_.holds(v)) return v;
  }
  return {};
}

void CollapseRounds::end_parts() {
  left_.clear();
  next_left_ = 0;
  for (Part& p : parts_) {
    left_.insert(left_.end(), p.left.begin(), p.left.end());
    p.left.clear();
  }
  std::sort(left_.begin(), left_.end());
  left_.erase(std::unique(left_.begin(), left_.end()), left_.end());
  queue_.even_out_levels();
  turn_ = parts_.size();
}

std::uint32_t CollapseRounds::lowest_bucket() {
  std::uint32_t lowest = VertexQueue::no_bucket;
  for (std::size_t i = 0; i < parts_.size(); ++i) lowest = std::min(lowest, queue_.lowest(i));
  return lowest;
}

// Far above the goal costs are far below those at the end, and which of them comes first does not
// matter.
bool CollapseRounds::begin_round() {
  const std::uint32_t lowest = lowest_bucket();
  if (reached() || lowest == VertexQueue::no_bucket) return false;
  const std::uint64_t far = far_above * goal_;
  const bool is_far = goal_ > 0 && mesh_.count(2) > far + few * parts_.size();
  bucket_ = is_far ? std::min(lowest + buckets_at_once, VertexQueue::no_bucket) - 1 : lowest;
  std::uint64_t waiting = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    queue_.leave_bucket(i);
    parts_[i].taken = 0;
    parts_[i].share = queue_.waiting(i, lowest, bucket_);
    waiting += parts_[i].share;
  }
  share_out(goal_ > 0 ? mesh_.count(2) - (is_far ? far : goal_) : unlimited, waiting);
  return true;
}

void CollapseRounds::share_out(std::uint64_t faces, std::uint64_t waiting) {
  turn_ = 0;
  if (std::min(faces, waiting) >= few * parts_.size()) {
    for (Part& p : parts_) p.share = goal_ > 0 ? faces * p.share / waiting : unlimited;
    return;
  }
  for (std::size_t i = 0; i < parts_.size(); ++i)
    for (Vertex v = queue_.pop(i, bucket_); v.valid(); v = queue_.pop(i, bucket_)) leave(i, v);
  end_parts();
}

}  // namespace aomd
