#include "core/decimate/volume/removals_ahead.h"

#include <algorithm>

namespace aomd {

void RemovalsAhead::begin(const Mesh& mesh, std::uint32_t from) {
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

RemovalsAhead::Removals RemovalsAhead::of(const Mesh& mesh, Region r) const {
  if (!covers(r)) return all;
  int touched = 0;
  for (const Vertex v : mesh.tetrahedron(r)) touched += touched_[v] == stamp_;
  return touched < 2 ? open_[r.index - begin_] : all;
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
