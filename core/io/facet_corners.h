#pragma once
// Which corners of very many loose facets are one vertex.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace aomd::io::detail {

using FacetPoint = std::array<float, 3>;

/// Numbers the corners of facets by where they are: corners whose coordinates compare equal (so -0
/// and 0) are one vertex. Vertices are numbered in order of first appearance, as by a Welder.
class FacetCorners {
 public:
  static constexpr std::uint32_t most_facets = 0xfffffffeu / 3;

  FacetCorners() = default;
  /// each(take) calls take(corners) for all corners, some at a time, in their order, and is called
  /// up to 16 times: a pass looks at some of the places, by a hash of them. In memory are 12 bytes
  /// a facet, and during the passes at most 2 more, or 32 MB.
  using Take = std::function<void(std::span<const FacetPoint>)>;
  FacetCorners(std::uint32_t facets, const std::function<void(const Take&)>& each);

  [[nodiscard]] std::uint32_t vertices() const { return vertices_; }
  /// Of a corner, counted through all facets.
  [[nodiscard]] std::uint32_t operator[](std::size_t corner) const { return vertex_[corner]; }

 private:
  void number();

  std::vector<std::uint32_t> vertex_;  ///< by corner; during the passes the first corner at a place
  std::uint32_t vertices_ = 0;
};

}  // namespace aomd::io::detail
