#include "core/fields/carry_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/buckets.h"
#include "core/base/parallel.h"
#include "core/fields/field.h"
#include "core/fields/same_place.h"
#include "core/fields/seams.h"
#include "core/fields/sided_tree.h"

namespace aomd::fields {
namespace {

/// How far from its corner towards the middle of a face its side of a seam is looked for.
constexpr double inside = 0.1;
constexpr std::size_t most_faces = 256;  ///< that are looked at around one corner

/// A place on a face of the original: three of its corners by weight.
struct CornerPlace {
  std::array<std::size_t, 3> corners{};
  glm::dvec3 weights{1, 0, 0};
  double distance2 = std::numeric_limits<double>::infinity();
};

/// One array on its way.
class CornerCarrier {
 public:
  /// The tree has the faces of the original; its parts become the charts of this array.
  CornerCarrier(const Cells& original, const Cells& result, const Attribute& array, SidedTree& tree,
                int threads)
      : original_(original),
        result_(result),
        array_(array),
        charts_(original, array),
        tree_(tree),
        threads_(threads) {
    const std::vector<std::uint32_t> numbers = charts_.numbers();
    for (SidedTree::Item& item : tree.items()) item.part = numbers[item.owner];
  }

  [[nodiscard]] Attribute run(const std::vector<std::uint32_t>& same) const {
    Attribute carried = like(array_);
    const std::size_t corners = result_.mesh().faces.vertices.size();
    carried.values.resize(corners * stride());
    parallel_for(result_.size(), threads_, 64, [&](std::size_t begin, std::size_t end) {
      for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
        fill(f, same[f], std::span(carried.values).subspan(stride() * result_.first_corner(f)));
    });
    join(carried);
    return carried;
  }

 private:
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(array_.components); }

  void fill(std::uint32_t f, std::uint32_t same, std::span<double> values) const {
    const glm::dvec3 centre = result_.centre(f);
    Side side{result_.area_normal(f), 2 * std::sqrt(result_.measure(f)), no_index};
    const SidedTree::Item* const middle = same == no_index ? tree_.nearest(centre, side) : nullptr;
    if (middle) side.part = middle->part;
    for (std::size_t k = 0; k < result_.vertices(f).size(); ++k) {
      const glm::dvec3& p = result_.corner(f, k);
      if (same != no_index) {
        write(at_vertex(same, p), values.subspan(stride() * k));
        continue;
      }
      const glm::dvec3 beside = p + inside * (centre - p);
      const SidedTree::Item* const start = tree_.nearest(beside, side);
      if (start) write(nearest_from(start->owner, p, beside), values.subspan(stride() * k));
    }
  }

  /// The corner of a face that is at a place.
  [[nodiscard]] CornerPlace at_vertex(std::uint32_t face, const glm::dvec3& p) const {
    const std::size_t n = original_.vertices(face).size(), first = original_.first_corner(face);
    std::size_t k = 0;
    while (k + 1 < n && original_.corner(face, k) != p) ++k;
    return {{first + k, first + k, first + k}, {1, 0, 0}, 0};
  }

  [[nodiscard]] CornerPlace place_on(std::uint32_t face, const glm::dvec3& p) const {
    CornerPlace best;
    const std::size_t n = original_.vertices(face).size(), first = original_.first_corner(face);
    for (std::size_t k = 2; k < n; ++k) {
      glm::dvec3 weights;
      const double d2 =
          nearest_barycentric(p, original_.corner(face, 0), original_.corner(face, k - 1),
                              original_.corner(face, k), weights);
      if (d2 < best.distance2) best = {{first, first + k - 1, first + k}, weights, d2};
    }
    return best;
  }

  /// Goes from face to face as long as these are about as near to the corner as the start is.
  [[nodiscard]] CornerPlace nearest_from(std::uint32_t start, const glm::dvec3& p,
                                         const glm::dvec3& beside) const {
    std::vector<std::uint32_t> met{start};
    CornerPlace best = place_on(start, p);
    const glm::dvec3 way = p - beside;
    const double reach2 = std::max(2 * glm::dot(way, way), best.distance2);
    for (std::size_t i = 0; i < met.size() && met.size() < most_faces; ++i)
      for (std::size_t k = 0; k < original_.vertices(met[i]).size(); ++k) {
        const std::uint32_t next = charts_.beyond(original_.first_corner(met[i]) + k);
        if (next == no_index || std::find(met.begin(), met.end(), next) != met.end()) continue;
        const CornerPlace there = place_on(next, p);
        if (there.distance2 > reach2) continue;
        met.push_back(next);
        if (there.distance2 < best.distance2) best = there;
      }
    return best;
  }

  void write(const CornerPlace& place, std::span<double> values) const {
    const auto value = [&](std::size_t corner, std::size_t k) {
      return array_.values[stride() * place.corners[corner] + k];
    };
    for (int c = 0; c < 3; ++c)
      if (place.weights[c] == 1) {
        for (std::size_t k = 0; k < stride(); ++k)
          values[k] = value(static_cast<std::size_t>(c), k);
        return;
      }
    for (std::size_t k = 0; k < stride(); ++k)
      values[k] = value(0, k) + place.weights.y * (value(1, k) - value(0, k)) +
                  place.weights.z * (value(2, k) - value(0, k));
    settle(array_, values.first(stride()));
  }

  /// Corners of one vertex that differ by rounding alone get one value, so that no seam comes of
  /// it.
  void join(Attribute& carried) const {
    std::vector<double> range(stride(), 0);
    for (std::size_t i = 0; i < array_.values.size(); ++i)
      if (std::isfinite(array_.values[i]))
        range[i % stride()] = std::max(range[i % stride()], std::abs(array_.values[i]));
    const auto close = [&](std::size_t c, std::size_t other) {
      for (std::size_t k = 0; k < stride(); ++k)
        if (!(std::abs(carried.values[stride() * c + k] - carried.values[stride() * other + k]) <=
              1e-9 * range[k]))
          return false;
      return true;
    };
    const std::vector<std::uint32_t>& vertices = result_.mesh().faces.vertices;
    Buckets<std::size_t> at(result_.mesh().positions.size(), [&](const auto& file) {
      for (std::size_t c = 0; c < vertices.size(); ++c) file(vertices[c], c);
    });
    for (std::size_t v = 0; v < at.count(); ++v) {
      auto known = at[v].begin();  // the end of those that differ
      for (const std::size_t c : at[v]) {
        const auto found =
            std::find_if(at[v].begin(), known, [&](std::size_t other) { return close(c, other); });
        if (found == known)
          *known++ = c;
        else
          std::copy_n(&carried.values[stride() * *found], stride(), &carried.values[stride() * c]);
      }
    }
  }

  const Cells &original_, &result_;
  const Attribute& array_;
  Charts charts_;
  const SidedTree& tree_;
  int threads_;
};

}  // namespace

std::vector<Attribute> carried_corners(const MeshData& original, const MeshData& result,
                                       int threads) {
  std::vector<Attribute> arrays;
  if (original.corners.empty() || original.faces.empty() || result.faces.empty()) return arrays;
  const Cells before(original, 2), after(result, 2);
  const auto same = same_cells(before, after, SameVertices(original, result));
  const bool changed = std::find(same.begin(), same.end(), no_index) != same.end();
  SidedTree tree(original.positions, changed ? face_items(before) : std::vector<SidedTree::Item>(),
                 threads);
  for (const Attribute& a : original.corners)
    arrays.push_back(CornerCarrier(before, after, a, tree, threads).run(same));
  return arrays;
}

}  // namespace aomd::fields
