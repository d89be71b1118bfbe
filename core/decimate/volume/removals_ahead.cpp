#include "core/decimate/volume/removals_ahead.h"

#include <algorithm>
#include <array>
#include <bit>

namespace aomd {

// One of so many threads judges its share of all, and at their turn one of them judges again what
// has changed.
void RemovalsAhead::begin(const Mesh& mesh, std::uint32_t from, int threads) {
  constexpr double worth = 1.2;
  constexpr int batches_at_rest = 8;
  if (rests_ > 0)
    --rests_;
  else if (double(saved_) * threads < worth * double(asked_))
    rests_ = batches_at_rest;
  asked_ = saved_ = 0;
  begin_ = from;
  end_ = std::min(mesh.capacity(3) - from, batch) + from;
  open_.assign(end_ - begin_, all);
  if (touched_.size() != mesh.capacity(0)) touched_.assign(mesh.capacity(0), stamp_);
  ++stamp_;
}

// Topology may be that of tetrahedra further off.
RemovalsAhead::Removals RemovalsAhead::worth_judging(const Mesh& mesh, Region r,
                                                     const RemovalRules& rules, EdgeRemoval& edge,
                                                     FaceRemoval& face) {
  const auto t = mesh.tetrahedron(r);
  unsigned open = 0, bit = 1;
  const auto note = [&](const Verdict& v) {
    if (v.accepted() || v.reason == Reason::Topology) open |= bit;
    bit <<= 1;
  };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k) note(aomd::judge(mesh, t[i], t[k], rules, edge));
  for (std::uint32_t slot = 0; slot < 4; ++slot) note(aomd::judge(mesh, r, slot, rules, face));
  return static_cast<Removals>(open);
}

RemovalsAhead::Removals RemovalsAhead::of(const Mesh& mesh, Region r) {
  if (!covers(r) || rests_ > 0) return all;
  const auto t = mesh.tetrahedron(r);
  std::array<bool, 4> is_new;
  for (std::size_t i = 0; i < 4; ++i) is_new[i] = touched_[t[i]] == stamp_;
  unsigned open = open_[r.index - begin_], bit = 1;
  const auto reopen = [&](bool changed) {
    if (changed) open |= bit;
    bit <<= 1;
  };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k) reopen(is_new[i] && is_new[k]);
  for (std::size_t i = 0; i < 4; ++i)
    reopen(is_new[(i + 1) % 4] && is_new[(i + 2) % 4] && is_new[(i + 3) % 4]);
  asked_ += 10;
  saved_ += 10 - static_cast<unsigned>(std::popcount(open));
  return static_cast<Removals>(open);
}

void RemovalsAhead::changed(const EdgeRemoval& plan) {
  touch(plan.ring.a);
  touch(plan.ring.b);
  for (std::uint32_t s = 0; s < plan.ring.side_count; ++s)
    for (std::uint32_t i = 0; i < plan.ring.sides[s].count; ++i) touch(plan.ring.sides[s].ring[i]);
}

void RemovalsAhead::changed(const FaceRemoval& plan) {
  for (const Vertex v : plan.apexes) touch(v);
  for (const Vertex v : plan.corners) touch(v);
}

}  // namespace aomd
