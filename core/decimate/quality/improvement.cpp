// Passes of the quality strategy over edges and vertices: swaps and moves that bring the surface
// closer to the original.

#include <algorithm>

#include "core/base/parallel.h"
#include "core/decimate/quality/quality_loop.h"
#include "core/operators/smooth.h"

namespace aomd {

bool QualityLoop::advance_swap() {
  if (part_count_ > 1) return advance_swap_in_turn();
  bool made = false;
  if (!next_swap(swaps_, made)) end_phase();
  return made;
}

// The edge after the last one; false when there is none.
bool QualityLoop::next_swap(SwapBatch& batch, bool& made) {
  if (batch.turn == batch.faces.size() && !fill(batch)) return false;
  const auto t = mesh_.triangle(batch.faces[batch.turn]);
  const Vertex a = t[batch.corner], b = t[(batch.corner + 1) % 3];
  made = a < b && !still_refused(batch) && try_swap(a, b, alone_);
  batch.corner = (batch.corner + 1) % 3;
  batch.turn += batch.corner == 0;
  return true;
}

bool QualityLoop::fill(SwapBatch& batch) {
  constexpr std::size_t batch_size = 8192;  // 10 ms of work: others want to see something happen
  const IdPool& ids = mesh_.ids(2);
  batch.faces.clear();
  batch.turn = 0;
  for (batch.after = ids.next_alive(batch.after);
       batch.after < ids.capacity() && batch.faces.size() < batch_size;
       batch.after = ids.next_alive(batch.after + 1))
    batch.faces.emplace_back(batch.after);
  batch.refused.assign(batch.faces.size(), {});
  if (swapped_.size() != mesh_.capacity(2)) swapped_.assign(mesh_.capacity(2), swap_stamp_);
  ++swap_stamp_;
  if (options_.threads > 1)
    judge_ahead(batch);  // one thread has nothing to win: it judges at their turn
  return !batch.faces.empty();
}

void QualityLoop::judge_ahead(SwapBatch& batch) const {
  constexpr std::size_t faces_a_piece = 128;
  if (!mesh_.stored(0, 1)) mesh_.build_hash(1);
  parallel_for(batch.faces.size(), options_.threads, faces_a_piece,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; ++i) {
                   const auto t = mesh_.triangle(batch.faces[i]);
                   for (std::size_t k = 0; k < 3; ++k)
                     batch.refused[i][k] = refused_across(t[k], t[(k + 1) % 3]);
                 }
               });
}

// Whether there are two faces, and whether the other diagonal is free, depends on what happens
// around them. All else follows from the two faces and the points on them, which only a swap of one
// of them changes.
Face QualityLoop::refused_across(Vertex a, Vertex b) const {
  EdgePair pair;
  if (!(a < b)) return {};
  const Reason reason = fitter_.judge_swap(a, b, fit_, pair).reason;
  return reason == Reason::None || reason == Reason::Topology ? Face() : pair.g;
}

bool QualityLoop::still_refused(const SwapBatch& batch) const {
  const Face across = batch.refused[batch.turn][batch.corner];
  return across.valid() && swapped_[across] != swap_stamp_ &&
         swapped_[batch.faces[batch.turn]] != swap_stamp_;
}

bool QualityLoop::advance_swap_in_turn() {
  if (corner_ == 0) face_ = Face(turns_.next(mesh_, options_.threads));
  if (!face_.valid()) {
    end_phase();
    return false;
  }
  alone_.within_part = turns_.in_part();
  alone_.part = turns_.part();
  const bool made = swap_across(face_, corner_, alone_);
  corner_ = (corner_ + 1) % 3;
  return made;
}

bool QualityLoop::swap_across(Face f, std::uint32_t corner, Hand& hand) {
  const auto t = mesh_.triangle(f);
  const Vertex a = t[corner], b = t[(corner + 1) % 3];
  const Partition& parts = turns_.partition();
  if (!(a < b)) return false;
  if (!hand.within_part || !(parts.on_seam(a) || parts.on_seam(b))) return try_swap(a, b, hand);
  turns_.leave(hand.part, f.index);
  return false;
}

bool QualityLoop::try_swap(Vertex a, Vertex b, Hand& hand) {
  EdgePair& pair = hand.plan.pair;
  if (!fitter_.judge_swap(a, b, fit_, pair).accepted() || keeps_face_of(pair) ||
      !guards_.judge(mesh_, hand.plan.change, pair).accepted())
    return false;
  if (hand.within_part && (crowded(mesh_, pair.c) || crowded(mesh_, pair.d))) {
    turns_.leave(hand.part, pair.f.index);  // a part has no room for rows of any length
    return false;
  }
  fitter_.swapped(pair);
  if (hand.edits) {
    apply_swap(*hand.edits, mesh_, pair);
    ++hand.made.swaps;
    return true;
  }
  apply_swap(mesh_, pair);
  made(StepKind::Swap, pair.f, hand.plan.change);
  for (const Face f : {pair.f, pair.g})
    if (f.index < swapped_.size()) swapped_[f] = swap_stamp_;
  return true;
}

bool QualityLoop::advance_smooth() {
  if (part_count_ > 1) return advance_smooth_in_turn();
  const std::uint32_t id = mesh_.ids(0).next_alive(cursor_);
  if (id >= mesh_.capacity(0)) {
    end_phase();
    return false;
  }
  cursor_ = id + 1;
  return try_smooth(Vertex(id), alone_);
}

bool QualityLoop::advance_smooth_in_turn() {
  const Vertex v(turns_.next(mesh_, options_.threads));
  if (!v.valid()) {
    end_phase();
    return false;
  }
  return try_smooth(v, alone_);
}

bool QualityLoop::try_smooth(Vertex v, Hand& hand) {
  auto& [target, star] = hand.plan.move;
  if (!options_.smooth || options_.kept(v) || !fitter_.judge_move(v, fit_, star, target).accepted())
    return false;
  if (!guards_.judge(mesh_, hand.plan.change, v, star, target).accepted()) return false;
  if (values_) values_->move(v);
  if (hand.edits) {
    hand.edits->move(v, target);
    ++hand.made.smooths;
    return true;
  }
  apply_smooth(mesh_, v, target);
  made(StepKind::Smooth, v, hand.plan.change);
  return true;
}

std::uint32_t QualityLoop::swap_pass() {
  std::uint32_t count = 0;
  alone_.within_part = false;
  locate();
  measure_energy();
  SwapBatch batch;
  for (bool made = false; next_swap(batch, made); made = false) count += made;
  return pass_done(count);
}

std::uint32_t QualityLoop::smooth_pass() {
  std::uint32_t count = 0;
  alone_.within_part = false;
  locate();
  measure_energy();
  for (const Vertex v : mesh_.vertices()) count += try_smooth(v, alone_);
  return pass_done(count);
}

// Between two collapses the queue knows neither the new edges nor the new places, and in a pass of
// swaps what was judged ahead is out of date.
std::uint32_t QualityLoop::pass_done(std::uint32_t made) {
  locate();
  if (made > 0 && phase_ == Phase::Collapse) {
    partition_ = Partition(mesh_, part_count_, 0, options_.threads);
    queue_.measure(true);
    rounds_.begin(goals_[stage_], part_count_);
  }
  turns_.give_up_parts();
  std::fill(swaps_.refused.begin(), swaps_.refused.end(), std::array<Face, 3>());
  return made;
}

}  // namespace aomd
