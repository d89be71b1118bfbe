#include "core/parts/pass_turns.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/raw_vector.h"
#include "core/mesh/id_pool.h"

namespace aomd {
namespace {

constexpr std::size_t ids_a_piece = 8192;        // where threads share them out
constexpr std::uint64_t fewest_faces_each = 16;  // to go, for each part: fewer go alone

}  // namespace

void PassTurns::begin(const Mesh& mesh, int level, std::size_t parts, int threads) {
  const auto vertex = [](std::uint32_t id) { return std::array{Vertex(id)}; };
  const auto face = [&mesh](std::uint32_t id) { return mesh.triangle(Face(id)); };
  if (level == 0)
    begin(mesh, mesh.ids(0), vertex, parts, threads);
  else
    begin(mesh, mesh.ids(2), face, parts, threads);
}

void PassTurns::begin_turns(const Mesh& mesh, const IdPool& ids, std::size_t parts, int threads,
                            std::uint64_t faces) {
  ids_ = &ids;
  count_ = parts;
  cut_ = -1;
  faces_ = faces;
  left_.clear();
  left_.reserve(ids.size());
  each_alive(ids, 0, ids.capacity(), [&](std::uint32_t id) { left_.push_back(id); });
  all_ = left_.size();
  parts_.clear();
  cut_again(mesh, threads);
}

bool PassTurns::cut_again(const Mesh& mesh, int threads) {
  if (alone()) return false;
  ++cut_;
  if (faces_ < fewest_faces_each * count_) cut_ = cuts;
  part_ = 0;
  parts_.assign(alone() ? 1 : count_, {});
  if (alone()) {
    parts_[0].ids.swap(left_);
  } else {
    partition_ = Partition(mesh, count_, cut_, threads);
    deal_out(threads);
    share_out();
  }
  return true;
}

void PassTurns::deal_out(int threads) {
  RawVector<std::uint16_t> places(left_.size());
  parallel_for(left_.size(), threads, ids_a_piece, [&](std::size_t begin, std::size_t end) {
    find_places_(partition_, std::span(left_).subspan(begin, end - begin), &places[begin]);
  });
  std::size_t later = 0;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const std::uint32_t id = left_[i];
    if (places[i] != on_seam)
      parts_[places[i]].ids.push_back(id);
    else if (ids_->alive(id))
      left_[later++] = id;
  }
  left_.resize(later);
}

void PassTurns::share_out() {
  if (faces_ == unlimited) return;
  std::size_t waiting = left_.size();
  for (const Part& p : parts_) waiting += p.ids.size();
  for (Part& p : parts_) p.share = faces_ * p.ids.size() / std::max<std::size_t>(1, waiting);
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
    left_.insert(left_.end(), p.ids.begin() + static_cast<std::ptrdiff_t>(p.turn), p.ids.end());
    if (faces_ != unlimited) faces_ -= std::min(faces_, std::exchange(p.taken, 0));
    p.left.clear();
    p.ids.clear();
    p.turn = 0;
  }
  std::sort(left_.begin(), left_.end());
  part_ = parts_.size();
}

void PassTurns::give_up_parts() {
  end_parts();
  cut_ = cuts - 1;
}

double PassTurns::progress() const {
  std::size_t waiting = left_.size();
  for (const Part& p : parts_) waiting += p.ids.size() - p.turn;
  return all_ > 0 ? 1 - static_cast<double>(std::min(waiting, all_)) / static_cast<double>(all_)
                  : 1;
}

}  // namespace aomd
