#include "core/decimate/volume/improvement.h"

#include <algorithm>
#include <utility>

#include "core/mesh/tet_geometry.h"

namespace aomd {

bool VolumeImprovement::is_tetrahedron(Region r) const {
  return mesh_.alive(r) && mesh_.shape(r) == Shape::Tetrahedron;
}

// Both keep a plan that gains more than the best so far, and say so.
bool VolumeImprovement::beats(Vertex a, Vertex b, double& gain) {
  if (!judge(mesh_, a, b, rules_.removal, edge_).accepted()) return false;
  if (edge_.after - edge_.before <= gain || !watch_.allows(edge_)) return false;
  gain = edge_.after - edge_.before;
  std::swap(edge_, best_edge_);
  return true;
}

bool VolumeImprovement::beats(Region r, std::uint32_t slot, double& gain) {
  if (!judge(mesh_, r, slot, rules_.removal, face_).accepted()) return false;
  if (face_.after - face_.before <= gain || !watch_.allows(face_)) return false;
  gain = face_.after - face_.before;
  std::swap(face_, best_face_);
  return true;
}

bool VolumeImprovement::try_swap(Region r) {
  const auto t = mesh_.tetrahedron(r);
  unsigned open = ahead_.of(mesh_, r);
  double gain = 0;
  bool by_face = false;
  const auto is_open = [&] { return (std::exchange(open, open >> 1) & 1u) != 0; };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (is_open()) beats(t[i], t[k], gain);
  for (std::uint32_t slot = 0; slot < 4; ++slot)
    if (is_open()) by_face |= beats(r, slot, gain);
  if (gain == 0) return false;
  if (by_face)
    make(best_face_, best_face_.apexes);
  else
    make(best_edge_, {best_edge_.ring.a, best_edge_.ring.b});
  return true;
}

template <typename Plan>
void VolumeImprovement::make(const Plan& plan, const std::array<Vertex, 2>& changed) {
  apply(mesh_, plan);
  ahead_.changed(plan);
  revision_ = mesh_.revision();
  watch_.made(plan);
  changed_ = changed;
}

// Whatever else has changed the mesh may have moved vertices.
void VolumeImprovement::look_ahead(Region next) {
  if (mesh_.revision() != revision_) ahead_.forget();
  revision_ = mesh_.revision();
  if (threads_ == 1 || ahead_.covers(next)) return;
  ahead_.judge(mesh_, next.index, rules_.removal, threads_,
               [&](Region r) { return is_poor(r) && watch_.looks_at(r); });
}

bool VolumeImprovement::try_move(Vertex v) {
  if (!mover_.judge(mesh_, v, rules_.move, move_).accepted() || !watch_.allows(move_)) return false;
  RegionMover::apply(mesh_, move_);
  watch_.made(move_);
  changed_ = {v, v};
  return true;
}

bool VolumeImprovement::next_swap(bool& made) {
  const std::uint32_t id = mesh_.ids(3).next_alive(cursor_);
  if (id >= mesh_.capacity(3)) return false;
  cursor_ = id + 1;
  look_ahead(Region(id));
  made = is_poor(Region(id)) && watch_.looks_at(Region(id)) && try_swap(Region(id));
  return true;
}

bool VolumeImprovement::next_move(bool& made) {
  const std::uint32_t id = mesh_.ids(0).next_alive(cursor_);
  if (id >= mesh_.capacity(0)) return false;
  cursor_ = id + 1;
  made = try_move(Vertex(id));
  return true;
}

std::uint32_t VolumeImprovement::swap_pass() {
  std::uint32_t count = 0;
  begin_pass();
  for (bool made = false; next_swap(made);) count += made;
  return count;
}

std::uint32_t VolumeImprovement::smooth_pass() {
  std::uint32_t count = 0;
  begin_pass();
  for (bool made = false; next_move(made);) count += made;
  return count;
}

bool VolumeImprovement::try_mending(Region r) {
  if (try_swap(r)) return true;
  const auto corners = mesh_.tetrahedron(r);
  return std::any_of(corners.begin(), corners.end(), [&](Vertex v) { return try_move(v); });
}

void VolumeImprovement::queue(Region r, double below) {
  if (!is_tetrahedron(r)) return;
  const double q = tet_shape(mesh_, r);
  if (!(q < below)) return;
  slivers_.push_back({q, r});
  std::push_heap(slivers_.begin(), slivers_.end());
}

void VolumeImprovement::queue_changed(double below) {
  for (const Region r : mesh_.row<3>(changed_[0])) queue(r, below);
  if (changed_[1] == changed_[0]) return;
  for (const Region r : mesh_.row<3>(changed_[1])) queue(r, below);
}

std::uint32_t VolumeImprovement::mend(double below) {
  std::uint32_t count = 0;
  slivers_.clear();
  ahead_.forget();
  for (const Region r : mesh_.regions()) queue(r, below);
  while (!slivers_.empty()) {
    std::pop_heap(slivers_.begin(), slivers_.end());
    const auto [q, region] = slivers_.back();
    slivers_.pop_back();
    if (!is_tetrahedron(region) || tet_shape(mesh_, region) != q || !try_mending(region)) continue;
    ++count;
    queue_changed(below);
  }
  return count;
}

}  // namespace aomd
