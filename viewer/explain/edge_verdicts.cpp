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

Color verdict_color(std::uint8_t code) {
  constexpr std::array<Color, reason_count> colors = {
      rgb(0x1fa37a),  // could go
      rgb(0xd9dee5),  // spacing: what most edges of a finished mesh are
      rgb(0x2f7fc1),  // shape of the model
      rgb(0x7b4fb5),  // topology
      rgb(0x8c5a2b),  // flat face
      rgb(0xe0662f),  // angle
      rgb(0xd98cb3),  // quality
      rgb(0x555e6b),  // kept
      rgb(0xe8c52e),  // shape
      rgb(0x6cc3ea),  // distance
      rgb(0xb0214f),  // intersection
  };
  return code < colors.size() ? colors[code] : plain_face_color();
}

void VerdictField::set(Edge e, std::uint8_t code) {
  std::uint8_t& present = (*codes_)[e];
  if (present != absent) --counts_[present];
  if (code != absent) ++counts_[code];
  present = code;
}

void VerdictField::start(const Mesh& mesh) {
  codes_ = std::make_shared<EdgeCodes>(mesh.capacity(1), absent);
  counts_ = {};
  queue_.clear();
  next_ = 0;
  for (const Edge e : mesh.edges()) {
    set(e, unjudged);
    queue_.push_back(e);
  }
}

void VerdictField::note(const Mesh& mesh, const SurfaceChanges& changes) {
  if (codes_->size() < mesh.capacity(1)) codes_->resize(mesh.capacity(1), absent);
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(next_));
  next_ = 0;
  for (const Edge e : changes.edges) {
    if (e.index >= codes_->size()) continue;
    if (!mesh.alive(e)) set(e, absent);
    if (mesh.alive(e)) queue_.push_back(e);
  }
}

std::vector<Edge> VerdictField::judge(Decimation& decimation, const Mesh& mesh,
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
