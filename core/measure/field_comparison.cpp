#include "core/measure/field_comparison.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/fields/seams.h"
#include "core/fields/tet_tree.h"
#include "core/measure/surface_places.h"
#include "core/mesh/split_tets.h"

namespace aomd::measure {
namespace {

using fields::Cells;
using fields::TetTree;
using fields::Weights;

/// A volume in which arrays can be evaluated.
class FieldSide {
 public:
  FieldSide(const MeshData& mesh, int threads) : split_(cut(mesh)), cells_(split_, 3) {
    std::vector<std::uint32_t> all(cells_.size());
    std::iota(all.begin(), all.end(), 0u);
    tree_.emplace(cells_, all, threads);
  }

  [[nodiscard]] const Cells& cells() const { return cells_; }
  [[nodiscard]] const MeshData& mesh() const { return split_; }
  [[nodiscard]] std::uint32_t region_at(const glm::dvec3& p) const { return tree_->region_at(p); }

  /// The value of a component at a point of a region.
  [[nodiscard]] double value(const Attribute& a, std::uint32_t region, const Weights& weights,
                             std::size_t component) const {
    const auto stride = static_cast<std::size_t>(a.components);
    if (a.dimension == 3) return a.values[stride * region + component];
    const auto corners = cells_.vertices(region);
    const auto at = [&](std::size_t k) { return a.values[stride * corners[k] + component]; };
    if (fields::kind_of(a) == fields::FieldKind::Label)
      return at(static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                         weights.begin()));
    double change = 0;
    for (std::size_t k = 1; k < 4; ++k) change += weights[k] * (at(k) - at(0));
    return at(0) + change;
  }
  [[nodiscard]] Weights weights(std::uint32_t region, const glm::dvec3& p) const {
    return fields::TetCoordinates(cells_.tet(region)).refined(p);
  }

 private:
  static MeshData cut(const MeshData& mesh) {
    const std::vector<Shape>& shapes = mesh.regions.shapes;
    const bool tets =
        std::all_of(shapes.begin(), shapes.end(), [](Shape s) { return s == Shape::Tetrahedron; });
    return tets ? mesh : split_to_tets(mesh).mesh;
  }

  MeshData split_;
  Cells cells_;
  std::optional<TetTree> tree_;
};

/// A place where both meshes are asked, with a region of each.
struct Place {
  std::uint32_t before = no_index, after = no_index;
  Weights in_before{}, in_after{};
  double volume = 0;
};

class Places {
 public:
  Places(const FieldSide& original, const FieldSide& result, int threads)
      : original_(original), result_(result), threads_(threads) {
    add_middles();
    add_vertices();
  }

  /// Middles of the tetrahedra of both, and vertices of both.
  [[nodiscard]] const std::vector<Place>& middles() const { return middles_; }
  [[nodiscard]] const std::vector<Place>& vertices() const { return vertices_; }

 private:
  void add_middles() {
    const std::uint32_t n = original_.cells().size();
    fill(middles_, n, result_.cells().size(), [this, n](std::size_t i) {
      const bool first = i < n;
      const Cells& cells = first ? original_.cells() : result_.cells();
      const auto r = static_cast<std::uint32_t>(first ? i : i - n);
      Place place =
          first ? found(cells.centre(r), r, no_index) : found(cells.centre(r), no_index, r);
      place.volume = cells.measure(r);
      return place;
    });
  }
  void add_vertices() {
    const std::vector<glm::dvec3>&a = original_.mesh().positions, &b = result_.mesh().positions;
    fill(vertices_, a.size(), b.size(), [&](std::size_t i) {
      return found(i < a.size() ? a[i] : b[i - a.size()], no_index, no_index);
    });
  }

  template <typename At>
  void fill(std::vector<Place>& places, std::size_t n, std::size_t m, const At& at) const {
    places.resize(n + m);
    parallel_for(n + m, threads_, 128, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) places[i] = at(i);
    });
  }

  [[nodiscard]] Place found(const glm::dvec3& p, std::uint32_t before, std::uint32_t after) const {
    Place place;
    place.before = before != no_index ? before : original_.region_at(p);
    place.after = after != no_index ? after : result_.region_at(p);
    if (place.before != no_index) place.in_before = original_.weights(place.before, p);
    if (place.after != no_index) place.in_after = result_.weights(place.after, p);
    return place;
  }

  const FieldSide &original_, &result_;
  int threads_;
  std::vector<Place> middles_, vertices_;
};

/// Adds up an array's differences at places of volumes.
void add_differences(const FieldSide& original, const FieldSide& result, const Attribute& before,
                     const Attribute& after, const std::vector<Place>& places,
                     DifferenceSums& sums) {
  for (const Place& place : places) {
    if (place.before == no_index || place.after == no_index) continue;
    double squares = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(before.components); ++k) {
      const double d = result.value(after, place.after, place.in_after, k) -
                       original.value(before, place.before, place.in_before, k);
      squares += d * d;
    }
    sums.add(squares, place.volume);
  }
}

/// An array of both meshes, by its place in each.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// Those on vertices, and on cells of a dimension.
Pairs arrays_of_both(const MeshData& original, const MeshData& result, int cells) {
  Pairs pairs;
  for (std::size_t i = 0; i < original.attributes.size(); ++i) {
    const Attribute& a = original.attributes[i];
    const auto found =
        std::find_if(result.attributes.begin(), result.attributes.end(), [&](const Attribute& b) {
          return a.name == b.name && a.dimension == b.dimension && a.components == b.components;
        });
    if (found != result.attributes.end() && (a.dimension == 0 || a.dimension == cells))
      pairs.emplace_back(i, static_cast<std::size_t>(found - result.attributes.begin()));
  }
  return pairs;
}

/// Those on the corners of faces, with a value for each of these.
Pairs corners_of_both(const MeshData& original, const MeshData& result) {
  Pairs pairs;
  const auto full = [](const Attribute& a, const MeshData& mesh) {
    return a.values.size() == static_cast<std::size_t>(a.components) * mesh.faces.vertices.size();
  };
  for (std::size_t i = 0; i < original.corners.size(); ++i) {
    const Attribute& a = original.corners[i];
    const auto found =
        std::find_if(result.corners.begin(), result.corners.end(), [&](const Attribute& b) {
          return a.name == b.name && a.components == b.components && full(b, result);
        });
    if (found != result.corners.end() && full(a, original))
      pairs.emplace_back(i, static_cast<std::size_t>(found - result.corners.begin()));
  }
  return pairs;
}

std::vector<double> measures_for(const MeshData& mesh, int dimension, bool corners) {
  return corners ? fields::corner_measures(mesh) : fields::measures(mesh, dimension);
}

FieldDifference described(const MeshData& original, const MeshData& result, const Attribute& before,
                          const Attribute& after, bool corners = false) {
  FieldDifference d;
  d.name = before.name;
  d.dimension = before.dimension;
  d.components = before.components;
  d.corners = corners;
  d.label = fields::kind_of(before) == fields::FieldKind::Label &&
            fields::kind_of(after) == fields::FieldKind::Label;
  d.directions = d.components == 3 && fields::kind_of(before) == fields::FieldKind::Unit &&
                 fields::kind_of(after) == fields::FieldKind::Unit;
  d.before = fields::facts_of(before, measures_for(original, d.dimension, corners));
  d.after = fields::facts_of(after, measures_for(result, d.dimension, corners));
  for (const fields::ComponentFacts& c : d.before.components)
    d.range = std::max(d.range, c.high - c.low);
  return d;
}

std::vector<FieldDifference> fields_of_volumes(const MeshData& original, const MeshData& result,
                                               const Pairs& pairs, int threads) {
  const FieldSide before(original, threads), after(result, threads);
  const Places places(before, after, threads);
  std::vector<FieldDifference> list;
  for (const auto& [i, k] : pairs) {
    const Attribute &a = before.mesh().attributes[i], &b = after.mesh().attributes[k];
    list.push_back(described(original, result, original.attributes[i], result.attributes[k]));
    DifferenceSums sums;
    add_differences(before, after, a, b, places.middles(), sums);
    if (a.dimension == 0) add_differences(before, after, a, b, places.vertices(), sums);
    sums.write(list.back());
  }
  return list;
}

/// One array of two surfaces.
FieldDifference difference(const SurfacePlaces& places, const Attribute& before,
                           const Attribute& after, FieldDifference d) {
  DifferenceSums sums;
  places.add_differences(before, after, d.corners, sums);
  sums.write(d);
  if (!d.directions) return d;
  DifferenceSums angles;
  FieldDifference in_degrees;
  places.add_angles(before, after, d.corners, angles);
  angles.write(in_degrees);
  d.rms_deg = in_degrees.rms;
  d.largest_deg = in_degrees.largest;
  return d;
}

std::vector<FieldDifference> fields_of_surfaces(const MeshData& original, const MeshData& result,
                                                const Pairs& pairs, const Pairs& corners,
                                                int threads) {
  const SurfacePlaces places(original, result, threads);
  std::vector<FieldDifference> list;
  for (const auto& [i, k] : pairs) {
    const Attribute &a = original.attributes[i], &b = result.attributes[k];
    list.push_back(difference(places, a, b, described(original, result, a, b)));
  }
  for (const auto& [i, k] : corners) {
    const Attribute &a = original.corners[i], &b = result.corners[k];
    list.push_back(difference(places, a, b, described(original, result, a, b, true)));
  }
  return list;
}

}  // namespace

void DifferenceSums::add(double squares, double weight) {
  if (!std::isfinite(squares)) {
    ++missing_;
    return;
  }
  largest_ = std::max(largest_, std::sqrt(squares));
  squares_.add(weight * squares);
  if (squares > 0) differing_.add(weight);
  whole_.add(weight);
}

void DifferenceSums::write(FieldDifference& d) const {
  const double whole = whole_.value();
  d.missing = missing_;
  if (d.label) {
    d.differing = whole > 0 ? differing_.value() / whole : 0;
    return;
  }
  d.rms = whole > 0 ? std::sqrt(squares_.value() / whole) : 0;
  d.largest = largest_;
}

std::vector<FieldDifference> compare_fields(const MeshData& original, const MeshData& result,
                                            int threads) {
  const bool volumes = !original.regions.empty() && !result.regions.empty();
  if (!volumes && (original.faces.empty() || result.faces.empty())) return {};
  const Pairs pairs = arrays_of_both(original, result, volumes ? 3 : 2);
  const Pairs corners = volumes ? Pairs() : corners_of_both(original, result);
  if (pairs.empty() && corners.empty()) return {};
  return volumes ? fields_of_volumes(original, result, pairs, threads)
                 : fields_of_surfaces(original, result, pairs, corners, threads);
}

}  // namespace aomd::measure
