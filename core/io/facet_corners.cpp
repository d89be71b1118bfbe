#include "core/io/facet_corners.h"

#include <bit>
#include <cstddef>

namespace aomd::io::detail {
namespace {

std::uint64_t place_hash(const FacetPoint& p) {
  std::uint64_t h = 0;
  for (const float x : p) {
    h ^= std::bit_cast<std::uint32_t>(x + 0.0f);  // + 0 makes -0 and 0 one
    h *= 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

/// The first corner at each of many places.
class FirstCorners {
 public:
  /// Of the place of this corner, which may be itself.
  std::uint32_t add(const FacetPoint& p, std::uint64_t hash, std::uint32_t corner) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = find(p, hash);
    if (slot.corner == none) {
      slot = {p, corner};
      ++count_;
    }
    return slot.corner;
  }
  /// All are gone, but not the memory.
  void clear() {
    slots_.assign(slots_.size(), Slot{});
    count_ = 0;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Slot {
    FacetPoint at{};
    std::uint32_t corner = none;
  };

  Slot& find(const FacetPoint& p, std::uint64_t hash) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash & mask;; i = (i + 1) & mask)
      if (slots_[i].corner == none || slots_[i].at == p) return slots_[i];
  }
  void grow() {
    std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.corner != none) find(slot.at, place_hash(slot.at)) = slot;
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

/// A power of two: half a million places or a sixteenth of all have their turn at a time.
std::uint32_t passes_for(std::uint32_t facets) {
  constexpr std::uint32_t at_a_time = 1u << 20, most = 16;
  std::uint32_t passes = 1;
  while (passes < most && facets / passes > at_a_time) passes *= 2;
  return passes;
}

}  // namespace

FacetCorners::FacetCorners(std::uint32_t facets, const std::function<void(const Take&)>& each)
    : vertex_(3 * std::size_t{facets}) {
  const std::uint32_t passes = passes_for(facets);
  FirstCorners first;
  for (std::uint32_t pass = 0; pass < passes; ++pass) {
    std::uint32_t corner = 0;
    each([&](std::span<const FacetPoint> corners) {
      for (const FacetPoint& p : corners) {
        const std::uint64_t hash = place_hash(p);
        if ((hash >> 40) % passes == pass) vertex_[corner] = first.add(p, hash, corner);
        ++corner;
      }
    });
    first.clear();
  }
  number();
}

// From the first corner of each place to the number of its vertex.
void FacetCorners::number() {
  for (std::size_t corner = 0; corner < vertex_.size(); ++corner) {
    std::uint32_t& first = vertex_[corner];
    first = first == corner ? vertices_++ : vertex_[first];
  }
}

}  // namespace aomd::io::detail
