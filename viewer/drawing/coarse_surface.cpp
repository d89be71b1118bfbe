#include "viewer/drawing/coarse_surface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr std::uint32_t no_edges = hide_edge_01 | hide_edge_12 | hide_edge_20;

bool alive(std::span<const Corner> face) {
  return face[0].position != face[1].position || face[0].position != face[2].position;
}

/// Cubes of one size over all of the surface.
struct Grid {
  glm::vec3 low{0};
  float cells_a_unit = 0;

  Grid(std::span<const Corner> corners, std::size_t wanted_faces) {
    double area = 0;
    glm::vec3 least(0);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      const glm::vec3 a = corners[i].position;
      area +=
          0.5 * glm::length(glm::cross(corners[i + 1].position - a, corners[i + 2].position - a));
      least = glm::min(least, a);
    }
    // A plane meets 1.5 squares of a cell's size of its own area in cells, seen from all sides, and
    // a surface has twice as many triangles as points.
    const double cell = std::sqrt(3 * area / static_cast<double>(wanted_faces));
    cells_a_unit = cell > 0 ? static_cast<float>(1 / cell) : 0;
    low = least;
  }
  /// Of the cell that a place lies in; never 0.
  [[nodiscard]] std::uint64_t key(glm::vec3 p) const {
    constexpr std::uint64_t most = (1u << 21) - 1;
    const glm::vec3 at = (p - low) * cells_a_unit + 1.0f;
    const auto part = [&](float v) {
      return std::min(most, static_cast<std::uint64_t>(std::max(v, 0.0f)));
    };
    return part(at.x) | part(at.y) << 21 | part(at.z) << 42;
  }
};

/// Numbers for keys other than 0, in the order in which they come. Open addressing, at most half
/// full.
class Numbering {
 public:
  explicit Numbering(std::size_t expected) {
    reserve(std::bit_ceil(std::max<std::size_t>(64, 2 * expected)));
  }
  /// The key's number, and whether it is new.
  std::pair<std::uint32_t, bool> of(std::uint64_t key) {
    if (2 * std::size_t{count_} >= keys_.size()) grow();
    const std::size_t at = place(key);
    const bool fresh = keys_[at] == 0;
    if (fresh) {
      keys_[at] = key;
      numbers_[at] = count_++;
    }
    return {numbers_[at], fresh};
  }

 private:
  void reserve(std::size_t size) {
    keys_.assign(size, 0);
    numbers_.assign(size, 0);
  }
  [[nodiscard]] std::size_t place(std::uint64_t key) const {
    std::size_t at = (key * 0x9e3779b97f4a7c15u) >> 20 & (keys_.size() - 1);
    while (keys_[at] != 0 && keys_[at] != key) at = (at + 1) & (keys_.size() - 1);
    return at;
  }
  void grow() {
    const std::vector<std::uint64_t> keys = std::move(keys_);
    const std::vector<std::uint32_t> numbers = std::move(numbers_);
    reserve(2 * keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i] == 0) continue;
      const std::size_t at = place(keys[i]);
      keys_[at] = keys[i];
      numbers_[at] = numbers[i];
    }
  }
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> numbers_;
  std::uint32_t count_ = 0;
};

/// What lies in one cell.
struct Point {
  glm::vec3 position{0}, normal{0};  ///< sums
  float count = 0;

  void add(const Corner& corner) {
    position += corner.position;
    normal += unpack_normal(corner.normal);
    ++count;
  }
  [[nodiscard]] glm::vec3 middle() const { return position / count; }
  /// Both sides of something thin lie in the cell.
  [[nodiscard]] bool thin() const { return glm::length(normal) < 0.5f * count; }
};

/// A face of the cells that its corners lie in, named by their numbers whatever the first is.
std::uint64_t key_of(std::array<std::uint32_t, 3> cells) {
  std::rotate(cells.begin(), std::min_element(cells.begin(), cells.end()), cells.end());
  std::uint64_t key = 0x2545f4914f6cdd1du;
  for (const std::uint32_t cell : cells) key = (key ^ cell) * 0xff51afd7ed558ccdu;
  return key | 1u;
}

struct Kept {
  std::array<std::uint32_t, 3> cells{};
  std::size_t first = 0;  ///< corner
};

Corner corner_of(const Point& point, const Corner& from, std::uint32_t flags) {
  const float length = glm::length(point.normal);
  const bool known = length > 0 && !point.thin();
  return {point.middle(), known ? pack_normal(point.normal / length) : from.normal, from.color,
          flags};
}

/// Whether a face looks as the surface does around its points: not where that was folded.
bool looks_outward(const Kept& face, const std::vector<Point>& points) {
  const auto at = [&](std::size_t k) { return points[face.cells[k]].middle(); };
  glm::vec3 sum(0);
  for (const std::uint32_t cell : face.cells) sum += points[cell].normal;
  return glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), sum) > 0;
}

}  // namespace

std::vector<Corner> coarse_corners(std::span<const Corner> corners, std::size_t wanted_faces) {
  const Grid grid(corners, wanted_faces);
  Numbering cells(wanted_faces), faces(wanted_faces);
  std::vector<Point> points;
  std::vector<Kept> kept;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (!alive(corners.subspan(i, 3))) continue;
    Kept face{{}, i};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [cell, fresh] = cells.of(grid.key(corners[i + k].position));
      if (fresh) points.emplace_back();
      points[cell].add(corners[i + k]);
      face.cells[k] = cell;
    }
    const auto& c = face.cells;
    if (c[0] != c[1] && c[1] != c[2] && c[0] != c[2] && faces.of(key_of(c)).second)
      kept.push_back(face);
  }
  std::vector<Corner> coarse;
  coarse.reserve(3 * kept.size());
  for (const Kept& face : kept) {
    const bool folded = !looks_outward(face, points);
    const bool thin =
        folded || std::any_of(face.cells.begin(), face.cells.end(),
                              [&](std::uint32_t cell) { return points[cell].thin(); });
    const std::uint32_t flags =
        corners[face.first].flags | no_edges | (thin ? CornerFlag::without_back : 0u);
    for (std::size_t k = 0; k < 3; ++k)
      coarse.push_back(corner_of(points[face.cells[k]], corners[face.first + k], flags));
  }
  return coarse;
}

}  // namespace aomd::scene
