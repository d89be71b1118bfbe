#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

// Sets of faces, each face with its direction against that of the root.
class DirectedSets {
 public:
  explicit DirectedSets(std::size_t n) : parent_(n), against_(n, 0) {
    for (std::uint32_t f = 0; f < n; ++f) parent_[f] = f;
  }
  [[nodiscard]] std::uint32_t find(std::uint32_t f) {
    std::uint32_t root = f;
    std::uint8_t against = 0;
    for (; parent_[root] != root; root = parent_[root]) against ^= against_[root];
    while (parent_[f] != root && f != root) {
      const std::uint32_t up = parent_[f];
      const std::uint8_t rest = against ^ against_[f];
      parent_[f] = root;
      against_[f] = against;
      f = up, against = rest;
    }
    return root;
  }
  /// After find(f).
  [[nodiscard]] bool against_root(std::uint32_t f) const {
    return parent_[f] != f && against_[f] != 0;
  }
  /// Joins two faces; false where they are joined already and the other way round.
  bool unite(std::uint32_t f, std::uint32_t g, bool against) {
    const std::uint32_t a = find(f), b = find(g);
    const bool turn = against_root(f) ^ against_root(g) ^ against;
    if (a == b) return !turn;
    const std::uint32_t root = std::min(a, b), other = std::max(a, b);
    parent_[other] = root;
    against_[other] = turn;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> against_;
};

class Orienter {
 public:
  explicit Orienter(Surface& surface)
      : surface_(surface), sets_(surface.face_count()), twisted_(surface.face_count(), 0) {}

  Oriented run() {
    join();
    std::vector<std::int64_t> majority(surface_.face_count(), 0);  // with the root less against it
    surface_.each_face(
        [&](std::uint32_t f) { majority[sets_.find(f)] += sets_.against_root(f) ? -1 : 1; });
    Oriented result;
    surface_.each_face([&](std::uint32_t f) {
      const std::uint32_t root = sets_.find(f);
      if (twisted_[root]) return void(f == root ? result.twisted.add(f) : void());
      if (sets_.against_root(f) == (majority[root] < 0)) return;
      const auto v = surface_.vertices(f);
      std::reverse(v.begin() + 1, v.end());
      result.turned.add(f);
    });
    return result;
  }

 private:
  void join() {
    std::vector<std::uint32_t> conflicts;
    EdgeUses(surface_).each([&](std::span<const EdgeUses::Use> uses) {
      if (uses.size() != 2) return;
      const std::uint32_t f = surface_.face_of(uses[0].corner()),
                          g = surface_.face_of(uses[1].corner());
      if (!sets_.unite(f, g, uses[0].forward() == uses[1].forward())) conflicts.push_back(f);
    });
    for (const std::uint32_t f : conflicts) twisted_[sets_.find(f)] = 1;
  }

  Surface& surface_;
  DirectedSets sets_;
  std::vector<std::uint8_t> twisted_;  ///< by root
};

}  // namespace

Oriented mend_orientation(Surface& surface) { return Orienter(surface).run(); }

}  // namespace aomd::repair_detail
