#include "core/decimate/quality/pass_turns.h"

#include <algorithm>

#include "core/mesh/id_pool.h"

namespace aomd {

void PassTurns::begin(const Mesh& mesh, int level, std::size_t parts, int threads) {
  level_ = level;
  count_ = parts;
  cut_ = -1;
  left_.clear();
  each_alive(mesh.ids(level), 0, mesh.capacity(level),
             [&](std::uint32_t id) { left_.push_back(id); });
  cut_again(mesh, threads);
}

bool PassTurns::cut_again(const Mesh& mesh, int threads) {
  if (alone()) return false;
  ++cut_;
  part_ = 0;
  parts_.assign(alone() ? 1 : count_, {});
  if (alone()) {
    parts_[0].ids.swap(left_);
  } else {
    partition_ = Partition(mesh, count_, cut_, threads);
    deal_out(mesh);
  }
  return true;
}

void PassTurns::deal_out(const Mesh& mesh) {
  std::vector<std::uint32_t> later;
  for (const std::uint32_t id : left_)
    (is_inside(mesh, id) ? parts_[part_of(mesh, id)].ids : later).push_back(id);
  left_.swap(later);
}

bool PassTurns::is_inside(const Mesh& mesh, std::uint32_t id) const {
  if (level_ == 0) return !partition_.on_seam(Vertex(id));
  const auto t = mesh.triangle(Face(id));
  return std::none_of(t.begin(), t.end(), [&](Vertex v) { return partition_.on_seam(v); });
}

std::size_t PassTurns::part_of(const Mesh& mesh, std::uint32_t id) const {
  return partition_.part_of(level_ == 0 ? Vertex(id) : mesh.triangle(Face(id))[0]);
}

std::uint32_t PassTurns::next(const Mesh& mesh, int threads) {
  do {
    for (; part_ < parts_.size(); ++part_)
      if (const std::uint32_t id = next_of(part_); id != no_index) return id;
    end_parts();
  } while (cut_again(mesh, threads));
  return no_index;
}

void PassTurns::leave(std::size_t part, std::uint32_t id) {
  std::vector<std::uint32_t>& left = parts_[part].left;
  if (left.empty() || left.back() != id) left.push_back(id);
}

void PassTurns::end_parts() {
  for (Part& p : parts_) {
    left_.insert(left_.end(), p.left.begin(), p.left.end());
    p.left.clear();
  }
  std::sort(left_.begin(), left_.end());
  part_ = parts_.size();
}

void PassTurns::give_up_parts() {
  for (Part& p : parts_) {
    left_.insert(left_.end(), p.ids.begin() + static_cast<std::ptrdiff_t>(p.turn), p.ids.end());
    p.ids.clear();
    p.turn = 0;
  }
  end_parts();
  if (!alone()) cut_ = cuts - 1;
}

}  // namespace aomd
