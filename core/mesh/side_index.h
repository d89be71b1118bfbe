#pragma once
// Lower entities looked up by their vertices in bulk: what building T(2,1), T(3,1) and T(3,2) is
// made of.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/base/assertion.h"
#include "core/base/raw_vector.h"
#include "core/mesh/entity_hash.h"
#include "core/mesh/handle.h"
#include "core/mesh/shape.h"

namespace aomd {

/// Vertices of a lower entity, taken from those of the whole one.
struct SideVertices {
  std::array<std::uint32_t, max_face_vertices> ids{};
  std::uint32_t count;

  SideVertices(const SubEntity& sub, const std::uint32_t* whole)
      : count(static_cast<std::uint32_t>(shape_template(sub.shape).vertex_count)) {
    for (std::uint32_t k = 0; k < count; ++k) ids[k] = whole[sub.vertices[k]];
  }
  explicit SideVertices(std::span<const std::uint32_t> all)
      : count(static_cast<std::uint32_t>(all.size())) {
    std::copy(all.begin(), all.end(), ids.begin());
  }
  [[nodiscard]] std::span<const std::uint32_t> span() const { return {ids.data(), count}; }
};

/// What tells edges apart: their ends. `forward`: from the smaller vertex to the larger.
struct EdgeKey {
  using Tag = std::uint32_t;
  std::uint32_t low;
  Tag tag;
  bool forward;

  EdgeKey(std::uint32_t from, std::uint32_t to)
      : low(std::min(from, to)), tag(std::max(from, to)), forward(from < to) {}
};

/// What tells faces apart: a triangle's vertices, exactly; for another polygon a hash of its
/// vertices, so that a hit needs a second look. `forward`: round from the smallest vertex, the
/// smaller of its neighbours first.
struct FaceKey {
  using Tag = std::uint64_t;
  std::uint32_t low;
  Tag tag;
  bool forward;

  // Without branches: which of three is smallest cannot be foretold.
  FaceKey(std::uint32_t a, std::uint32_t b, std::uint32_t c) : low(std::min(std::min(a, b), c)) {
    const std::uint32_t high = std::max(std::max(a, b), c), middle = a ^ b ^ c ^ low ^ high;
    forward =
        ((a == low) & (b == middle)) | ((b == low) & (c == middle)) | ((c == low) & (a == middle));
    tag = Tag{middle} << 32 | high;
  }
  explicit FaceKey(std::span<const std::uint32_t> v) : FaceKey(v[0], v[1], v[2]) {
    if (v.size() == 3) return;
    const auto at = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
    low = v[at];
    forward = v[(at + 1) % v.size()] < v[(at + v.size() - 1) % v.size()];
    tag = EntityHash::key(v);
  }
};

/// Compares 16 bytes with one, without branches: bit k of the result for the k-th.
[[nodiscard]] inline unsigned equal_bytes(const std::uint8_t* bytes, std::uint8_t value) {
#ifdef __SSE2__
  const __m128i loaded = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
  return static_cast<unsigned>(
      _mm_movemask_epi8(_mm_cmpeq_epi8(loaded, _mm_set1_epi8(static_cast<char>(value)))));
#else
  unsigned bits = 0;
  for (unsigned k = 0; k < 16; ++k) bits |= unsigned{bytes[k] == value} << k;
  return bits;
#endif
}

/// The entities of one level, sorted by smallest vertex. Building is a counting sort; finding reads
/// one byte of each entity at the smallest vertex, 16 at a time, and then the one that is meant.
/// Where a vertex is the smallest of more than `long_row` entities, they are sorted by their tags
/// and searched by halves.
template <typename Key>
class SideIndex {
 public:
  /// What find() meets: an entity and whether its own direction is forward (see the keys).
  class Hit {
   public:
    Hit() = default;
    Hit(std::uint32_t id, bool forward) : bits_(id << 1 | std::uint32_t{forward}) {}
    [[nodiscard]] bool valid() const { return bits_ != no_index; }
    [[nodiscard]] std::uint32_t id() const { return bits_ >> 1; }
    [[nodiscard]] bool forward() const { return (bits_ & 1u) != 0; }

   private:
    std::uint32_t bits_ = no_index;
  };

  /// `each(visit)` calls visit(id, Key) for every entity, the same on both of its calls. Of equal
  /// entities find() meets the one visited first. Ids lie below 2^31.
  template <typename Each>
  SideIndex(std::uint32_t vertices, std::size_t entities, Each&& each)
      : begin_(vertices + std::size_t{2}, 0), bytes_(entities + 15), entries_(entities) {
    AOMD_CHECK(entities < (std::size_t{1} << 31));
    std::fill(bytes_.end() - 15, bytes_.end(), std::uint8_t{0});
    // Local copies: the compiler must not fear that a byte written changes where the arrays are.
    std::uint32_t* const begin = begin_.data();
    std::uint8_t* const bytes = bytes_.data();
    Entry* const all = entries_.data();
    each([begin](std::uint32_t, const Key& key) { ++begin[key.low + std::size_t{2}]; });
    for (std::size_t v = 2; v < begin_.size(); ++v) begin[v] += begin[v - 1];
    each([begin, bytes, all](std::uint32_t id, const Key& key) {
      const std::uint32_t at = begin[key.low + std::size_t{1}]++;
      bytes[at] = byte_of(key.tag);
      all[at] = {key.tag, Hit(id, key.forward)};
    });
    for (std::uint32_t v = 0; v < vertices; ++v)
      if (begin[v + 1] - begin[v] > long_row)
        std::stable_sort(all + begin[v], all + begin[v + 1], by_tag);
  }

  /// The entity with this key for which `same(id)` holds, or an invalid hit.
  template <typename Same>
  [[nodiscard]] Hit find(const Key& key, Same&& same) const {
    const std::uint32_t begin = begin_[key.low], end = begin_[key.low + std::size_t{1}];
    if (end - begin > long_row) return find_sorted(key, begin, end, same);
    const std::uint8_t byte = byte_of(key.tag);
    for (std::uint32_t at = begin; at < end; at += 16) {
      unsigned hits = equal_bytes(bytes_.data() + at, byte);
      hits &= end - at < 16 ? (1u << (end - at)) - 1 : ~0u;
      for (; hits; hits &= hits - 1)
        if (const Entry& entry = entries_[at + static_cast<std::uint32_t>(std::countr_zero(hits))];
            entry.tag == key.tag && same(entry.hit.id()))
          return entry.hit;
    }
    return {};
  }

 private:
  struct Entry {
    typename Key::Tag tag;
    Hit hit;
  };
  static constexpr std::uint32_t long_row = 256;

  static bool by_tag(const Entry& a, const Entry& b) { return a.tag < b.tag; }
  template <typename Same>
  [[nodiscard]] Hit find_sorted(const Key& key, std::uint32_t begin, std::uint32_t end,
                                Same&& same) const {
    const Entry* const last = entries_.data() + end;
    const Entry* entry =
        std::lower_bound(entries_.data() + begin, last, Entry{key.tag, {}}, by_tag);
    for (; entry != last && entry->tag == key.tag; ++entry)
      if (same(entry->hit.id())) return entry->hit;
    return {};
  }
  static std::uint8_t byte_of(std::uint64_t tag) {
    return static_cast<std::uint8_t>((tag * 0x9e3779b97f4a7c15ull) >> 56);
  }

  RawVector<std::uint32_t> begin_;  ///< by smallest vertex, one past the largest at the end
  RawVector<std::uint8_t> bytes_;   ///< of each tag; 15 more, so that 16 can be read at any place
  RawVector<Entry> entries_;
};

}  // namespace aomd
