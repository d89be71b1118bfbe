#pragma once
// The faces at each vertex, kept while single faces change.

#include <unordered_map>
#include <vector>

#include "core/repair/surface.h"

namespace aomd::repair_detail {

/// Faces around vertices. Reading everything once is O(faces); each change is local.
class Around {
 public:
  explicit Around(const Surface& surface);

  /// The living faces at a vertex. Valid until the next change.
  [[nodiscard]] std::span<const std::uint32_t> faces(std::uint32_t v) const;
  /// The living faces at both.
  [[nodiscard]] std::vector<std::uint32_t> faces(std::uint32_t a, std::uint32_t b) const;
  /// The faces that have a side from a to b or from b to a.
  [[nodiscard]] std::vector<std::uint32_t> at_side(std::uint32_t a, std::uint32_t b) const;
  /// The vertices that a side connects with v, each once, ascending.
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  /// True when a side at v has one face only.
  [[nodiscard]] bool at_border(std::uint32_t v) const;

  void add(std::uint32_t v, std::uint32_t f) { changed(v).push_back(f); }
  void remove(std::uint32_t v, std::uint32_t f) { std::erase(changed(v), f); }

 private:
  [[nodiscard]] std::vector<std::uint32_t> met(std::uint32_t v) const;
  std::vector<std::uint32_t>& changed(std::uint32_t v);

  const Surface& surface_;
  std::vector<std::uint32_t> begin_, faces_;  ///< as read
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> changed_;
};

}  // namespace aomd::repair_detail
