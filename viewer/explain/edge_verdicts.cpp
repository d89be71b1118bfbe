#include "viewer/explain/edge_verdicts.h"

namespace aomd::scene {
namespace {

constexpr std::uint8_t absent = 0xff;  // no such edge: it counts nowhere

}  // namespace

std::string reason_word(Reason reason) {
  std::string word = reason_name(reason);
  word[0] = static_cast<char>(word[0] - 'A' + 'a');
  return word;
}

void EdgeVerdicts::set(Edge e, std::uint8_t code) {
  std::uint8_t& present = (*codes_)[e];
  if (present != absent) --counts_[present];
  if (code != absent) ++counts_[code];
  present = code;
}

void EdgeVerdicts::start(const Mesh& mesh) {
  codes_ = std::make_shared<EdgeCodes>(mesh.capacity(1), absent);
  counts_ = {};
  queue_.clear();
  next_ = 0;
  for (const Edge e : mesh.edges()) {
    set(e, unjudged);
    queue_.push_back(e);
  }
}

void EdgeVerdicts::note(const Mesh& mesh, const SurfaceChanges& changes) {
  if (codes_->size() < mesh.capacity(1)) codes_->resize(mesh.capacity(1), absent);
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(next_));
  next_ = 0;
  for (const Edge e : changes.edges) {
    if (e.index >= codes_->size()) continue;
    if (!mesh.alive(e)) set(e, absent);
    if (mesh.alive(e)) queue_.push_back(e);
  }
}

std::vector<Edge> EdgeVerdicts::judge(Decimation& decimation, const Mesh& mesh,
                                      std::optional<std::chrono::microseconds> budget) {
  constexpr std::size_t between_checks = 64;
  const auto start = std::chrono::steady_clock::now();
  std::vector<Edge> others;
  for (; pending(); ++next_) {
    if (budget && next_ % between_checks == 0 && std::chrono::steady_clock::now() - start > *budget)
      break;
    const Edge e = queue_[next_];
    if (!mesh.alive(e)) continue;
    Vertex deleted;
    const auto code = static_cast<std::uint8_t>(decimation.judge(e, deleted).reason);
    if ((*codes_)[e] == code) continue;
    set(e, code);
    others.push_back(e);
  }
  return others;
}

}  // namespace aomd::scene
