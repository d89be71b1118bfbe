#pragma once
// Classification: the model entity that a mesh entity lies on (paper, section 2.1).

#include <cstdint>

#pragma GCC visibility push(default)

namespace aomd {

/// A model entity G^J: its dimension J (0..3) and tag, packed into 4 bytes; or none (unclassified).
/// Tags lie in [min_tag, max_tag]; readers report an error for a tag outside it.
class ModelRef {
 public:
  static constexpr std::int32_t min_tag = -(1 << 28);
  static constexpr std::int32_t max_tag = (1 << 28) - 1;

  constexpr ModelRef() = default;
  constexpr ModelRef(int dimension, std::int32_t tag)
      : bits_((static_cast<std::uint32_t>(tag) << 3) | static_cast<std::uint32_t>(dimension)) {}

  [[nodiscard]] constexpr bool valid() const { return dimension() <= 3; }
  /// 0 model vertex, 1 model edge, 2 model face, 3 model region; 7 where unclassified.
  [[nodiscard]] constexpr int dimension() const { return static_cast<int>(bits_ & 7u); }
  [[nodiscard]] constexpr std::int32_t tag() const { return static_cast<std::int32_t>(bits_) >> 3; }
  [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
  [[nodiscard]] static constexpr ModelRef from_bits(std::uint32_t bits) {
    ModelRef ref;
    ref.bits_ = bits;
    return ref;
  }
  /// The rule M^I on G^J only if J >= I (paper, section 2.1). Unclassified entities break no rule.
  [[nodiscard]] constexpr bool may_classify(int mesh_dimension) const {
    return !valid() || dimension() >= mesh_dimension;
  }

  friend constexpr bool operator==(ModelRef, ModelRef) = default;
  /// Orders by dimension, then by tag.
  friend constexpr bool operator<(ModelRef a, ModelRef b) {
    return a.dimension() != b.dimension() ? a.dimension() < b.dimension() : a.tag() < b.tag();
  }

 private:
  std::uint32_t bits_ = 7u;
};

}  // namespace aomd

#pragma GCC visibility pop
