// Passes of the quality strategy over faces and vertices: swaps and moves that bring the surface closer to
// the original. Judging is most of the work and changes nothing, so it is done ahead, a batch at a time and
// on all threads; what was judged has its turn in a fixed order.

#include <algorithm>

#include "core/decimate/quality_loop.h"
#include "core/mesh/parallel.h"
#include "core/operators/smooth.h"

namespace aomd {
namespace {

constexpr std::size_t batch_size = 8192;  // about 10 ms of work: others want to see something happen
constexpr std::size_t faces_a_piece = 128, moves_a_piece = 64;

}  // namespace

void QualityLoop::begin_pass() {
  batch_ = {};
  corner_ = next_face_ = 0;
  colouring_.reset();
  colour_ = next_vertex_ = 0;
}

// Between two collapses the queue knows neither the new edges nor the new places, and what was judged ahead
// in a pass that is under way is out of date.
std::uint32_t QualityLoop::pass(bool (QualityLoop::*next)(bool& made)) {
  original_.locate(mesh_, options_.threads);
  measure_energy();
  begin_pass();
  std::uint32_t count = 0;
  for (bool made = false; (this->*next)(made); made = false) count += made;
  original_.locate(mesh_, options_.threads);
  if (count > 0 && phase_ == Phase::Collapse) measure_vertices(true);
  begin_pass();
  return count;
}

// The edge after the last one; false when there is none.
bool QualityLoop::next_swap(bool& made) {
  if (batch_.turn == batch_.faces.size() && !judge_faces_ahead()) return false;
  const std::size_t item = batch_.turn;
  const std::uint32_t k = corner_;
  const auto t = mesh_.triangle(batch_.faces[item]);
  corner_ = (k + 1) % 3;
  batch_.turn += corner_ == 0;
  made = t[k] < t[corner_] && !still_refused(item, k, t) && try_swap(t[k], t[corner_]);
  return true;
}

// With one thread there is nothing to win: edges are judged at their turn.
bool QualityLoop::judge_faces_ahead() {
  batch_.faces.clear();
  batch_.turn = 0;
  const IdPool& ids = mesh_.ids(2);
  std::uint32_t f = ids.next_alive(next_face_);
  for (; f < ids.capacity() && batch_.faces.size() < batch_size; f = ids.next_alive(f + 1))
    batch_.faces.emplace_back(f);
  next_face_ = f;
  batch_.refused.assign(batch_.faces.size(), 0);
  if (swapped_.size() != mesh_.capacity(0)) swapped_.assign(mesh_.capacity(0), swap_stamp_);
  ++swap_stamp_;
  if (options_.threads <= 1) return !batch_.faces.empty();
  if (!mesh_.stored(0, 1)) mesh_.build_hash(1);
  const auto judge = [&](std::size_t begin, std::size_t end) {
    EdgePair pair;
    for (std::size_t i = begin; i < end; ++i) {
      const auto t = mesh_.triangle(batch_.faces[i]);
      for (std::size_t k = 0; k < 3; ++k)
        if (const Vertex a = t[k], b = t[(k + 1) % 3];
            a < b && !fitter_.judge_swap(a, b, fit_, pair).accepted())
          batch_.refused[i] |= static_cast<std::uint8_t>(1u << k);
    }
  };
  parallel_for(batch_.faces.size(), options_.threads, faces_a_piece, judge);
  return !batch_.faces.empty();
}

// A verdict reads the faces around both ends of the edge and the third corners of its two faces, and of the
// far one only what would show at the near one too. A swap changes no others than its own four vertices.
bool QualityLoop::still_refused(std::size_t item, std::uint32_t corner,
                                const std::array<Vertex, 3>& corners) const {
  const bool refused = (batch_.refused[item] >> corner & 1u) != 0;
  return refused && std::none_of(corners.begin(), corners.end(),
                                 [this](Vertex v) { return swapped_[v] == swap_stamp_; });
}

bool QualityLoop::try_swap(Vertex a, Vertex b) {
  EdgePair pair;
  if (!fitter_.judge_swap(a, b, fit_, pair).accepted() || !guards_.judge(mesh_, pair).accepted())
    return false;
  fitter_.swapped(pair);
  apply_swap(mesh_, pair);
  made(StepKind::Swap, pair.f);
  for (const Vertex v : {pair.a, pair.b, pair.c, pair.d}) swapped_[v] = swap_stamp_;
  return true;
}

// The vertex after the last one, colour by colour; false when there is none.
bool QualityLoop::next_move(bool& made) {
  if (batch_.turn == batch_.vertices.size() && !judge_moves_ahead()) return false;
  const std::size_t item = batch_.turn++;
  const auto& target = batch_.targets[item];
  made = target && try_move(batch_.vertices[item], *target);
  return true;
}

// A move is judged by the vertex and its neighbours, none of which has the same colour: what others of the
// colour do does not matter.
bool QualityLoop::judge_moves_ahead() {
  const auto may_move = [this](Vertex v) {
    return options_.smooth && mesh_.classification(v).dimension() >= 2 && !options_.kept(v);
  };
  if (!colouring_) colouring_.emplace(mesh_, may_move);
  while (colour_ < colouring_->colours() && next_vertex_ == colouring_->vertices(colour_).size())
    ++colour_, next_vertex_ = 0;
  batch_.turn = 0;
  batch_.vertices = {};
  if (colour_ == colouring_->colours()) return false;
  const auto rest = colouring_->vertices(colour_).subspan(next_vertex_);
  batch_.vertices = rest.first(std::min(rest.size(), batch_size));
  next_vertex_ += batch_.vertices.size();
  batch_.targets.assign(batch_.vertices.size(), std::nullopt);
  const auto judge = [&](std::size_t begin, std::size_t end) {
    Star star;
    glm::dvec3 target;
    for (std::size_t i = begin; i < end; ++i)
      if (fitter_.judge_move(batch_.vertices[i], fit_, star, target).accepted()) batch_.targets[i] = target;
  };
  const int threads = options_.model ? 1 : options_.threads;  // modelers need not answer several at once
  parallel_for(batch_.vertices.size(), threads, moves_a_piece, judge);
  return true;
}

bool QualityLoop::try_move(Vertex v, const glm::dvec3& target) {
  if (guards_.any()) {
    gather(mesh_, v, star_);
    if (!guards_.judge(mesh_, v, star_, target).accepted()) return false;
  }
  apply_smooth(mesh_, v, target);
  made(StepKind::Smooth, v);
  return true;
}

}  // namespace aomd
