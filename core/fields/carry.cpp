#include "core/fields/carry.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>

#include "core/fields/cell_values.h"
#include "core/fields/fitted_values.h"
#include "core/fields/surface_pairing.h"
#include "core/fields/vertex_values.h"

namespace aomd::fields {
namespace {

using Arrays = std::vector<const Attribute*>;

std::vector<bool> where_moved(const std::vector<VertexSource>& sources) {
  std::vector<bool> moved;
  moved.reserve(sources.size());
  for (const VertexSource& s : sources)
    moved.push_back(s.corners[0] != no_index && s.weights[0] != 1);
  return moved;
}

void fit_colours(const std::vector<FitPoint>& points, const Attribute& original,
                 const std::vector<bool>& moved, Attribute& result) {
  const auto n = static_cast<std::size_t>(result.components);
  fit_values(n, points, moved, original.values, result.values);
  for (std::size_t v = 0; v < moved.size(); ++v)
    if (moved[v]) settle(result, std::span(result.values).subspan(n * v, n));
}

/// The arrays of one dimension of an original at the entities of its result.
class Carrier {
 public:
  Carrier(const MeshData& original, const MeshData& result, int dimension, int threads)
      : threads_(threads),
        original_(original, dimension),
        result_(result, dimension),
        vertices_(original, result) {}
  virtual ~Carrier() = default;

  [[nodiscard]] std::vector<Attribute> on(int dimension, const Arrays& arrays) const {
    if (arrays.empty()) return {};
    if (dimension == result_.dimension()) return on_cells(arrays);
    return dimension == 0 ? on_vertices(arrays) : on_sides(arrays, dimension);
  }

 protected:
  [[nodiscard]] virtual std::vector<Attribute> on_cells(const Arrays& arrays) const = 0;
  [[nodiscard]] virtual std::vector<VertexSource> vertex_sources() const = 0;
  /// Brings colours at vertices, those at the places that `sources` say, closer to the original's
  /// between them.
  virtual void fit(const Arrays&, const std::vector<VertexSource>&, std::span<Attribute>) const {}

  int threads_;
  Cells original_, result_;
  SameVertices vertices_;

 private:
  [[nodiscard]] std::vector<Attribute> on_vertices(const Arrays& arrays) const {
    const std::vector<VertexSource> sources = vertex_sources();
    std::vector<Attribute> results;
    for (const Attribute* array : arrays) results.push_back(at_vertices(*array, sources));
    fit(arrays, sources, results);
    return results;
  }

  /// On edges, or on faces of volumes.
  [[nodiscard]] std::vector<Attribute> on_sides(const Arrays& arrays, int dimension) const {
    const Cells original(original_.mesh(), dimension), result(result_.mesh(), dimension);
    const SideParts parts(original, result, threads_);
    const auto same = same_cells(original, result, vertices_);
    return at_cells(arrays, {original, result, same, parts}, threads_);
  }
};

class VolumeCarrier final : public Carrier {
 public:
  VolumeCarrier(const MeshData& original, const MeshData& result, int threads)
      : Carrier(original, result, 3, threads),
        same_(same_cells(original_, result_, vertices_)),
        tree_(original_, changed(), threads) {}

 private:
  [[nodiscard]] std::vector<VertexSource> vertex_sources() const override {
    return fields::vertex_sources(original_, tree_, result_, vertices_, threads_);
  }
  [[nodiscard]] std::vector<Attribute> on_cells(const Arrays& arrays) const override {
    const TetParts parts(original_, tree_, result_);
    return at_cells(arrays, {original_, result_, same_, parts}, threads_);
  }

  /// The tetrahedra of the original that the result does not have.
  [[nodiscard]] std::vector<std::uint32_t> changed() const {
    std::vector<bool> kept(original_.size(), false);
    for (const std::uint32_t r : same_)
      if (r != no_index) kept[r] = true;
    std::vector<std::uint32_t> others;
    for (std::uint32_t r = 0; r < original_.size(); ++r)
      if (!kept[r] && original_.shape(r) == Shape::Tetrahedron) others.push_back(r);
    return others;
  }

  std::vector<std::uint32_t> same_;
  TetTree tree_;
};

class SurfaceCarrier final : public Carrier {
 public:
  SurfaceCarrier(const MeshData& original, const MeshData& result, int threads)
      : Carrier(original, result, 2, threads), pairing_(original_, result_, vertices_, threads) {}

 private:
  [[nodiscard]] std::vector<VertexSource> vertex_sources() const override {
    return pairing_.vertex_sources();
  }
  void fit(const Arrays& arrays, const std::vector<VertexSource>& sources,
           std::span<Attribute> results) const override {
    const auto is_colour = [](const Attribute& a) { return kind_of(a) == FieldKind::Colour; };
    if (std::none_of(results.begin(), results.end(), is_colour)) return;
    const std::vector<bool> moved = where_moved(sources);
    const std::vector<FitPoint> points = original_on_result();
    for (std::size_t i = 0; i < results.size(); ++i)
      if (is_colour(results[i])) fit_colours(points, *arrays[i], moved, results[i]);
  }
  [[nodiscard]] std::vector<Attribute> on_cells(const Arrays& arrays) const override {
    const FaceParts parts(pairing_, result_);
    const auto same = same_cells(original_, result_, vertices_);
    return at_cells(arrays, {original_, result_, same, parts}, threads_);
  }

  /// Where the vertices of the original lie on the result.
  [[nodiscard]] std::vector<FitPoint> original_on_result() const {
    const SameVertices same(result_.mesh(), original_.mesh());
    const SurfacePairing pairing(result_, original_, same, threads_);
    const std::vector<double> areas = measures(original_.mesh(), 0);
    std::vector<FitPoint> points;
    for (const VertexSource& place : pairing.vertex_sources()) {
      FitPoint point{{}, glm::vec3(0.0f), 0};  // what lies nowhere weighs nothing
      if (place.corners[0] != no_index) {
        std::copy_n(place.corners.begin(), 3, point.corners.begin());
        point.weights = glm::vec3(place.weights[0], place.weights[1], place.weights[2]);
        point.area = static_cast<float>(areas[points.size()]);
      }
      points.push_back(point);
    }
    return points;
  }

  SurfacePairing pairing_;
};

std::unique_ptr<Carrier> carrier_for(const MeshData& original, const MeshData& result,
                                     int threads) {
  if (!original.regions.empty()) return std::make_unique<VolumeCarrier>(original, result, threads);
  return std::make_unique<SurfaceCarrier>(original, result, threads);
}

/// Measures of both meshes by dimension, for those that have arrays.
class Facts {
 public:
  Facts(const MeshData& original, const MeshData& result) : original_(original), result_(result) {}

  [[nodiscard]] CarriedField of(const Attribute& before, const Attribute& after, int dimension) {
    auto& pair = measures_[static_cast<std::size_t>(dimension)];
    if (!pair)
      pair = std::make_unique<Pair>(
          Pair{measures(original_, dimension), measures(result_, dimension)});
    return {before.name,
            dimension,
            before.components,
            kind_of(before),
            facts_of(before, pair->before),
            facts_of(after, pair->after)};
  }

 private:
  struct Pair {
    std::vector<double> before, after;
  };
  const MeshData &original_, &result_;
  std::array<std::unique_ptr<Pair>, 4> measures_;
};

bool has_some(const MeshData& mesh, int dimension) {
  return dimension == 0 ? !mesh.positions.empty() : !mesh.list(dimension).empty();
}

}  // namespace

bool can_carry(const MeshData& original, const MeshData& result) {
  if (original.regions.empty() && result.regions.empty())
    return !original.faces.empty() && !result.faces.empty();
  return !original.regions.empty() && !result.regions.empty();
}

std::vector<CarriedField> carry(std::span<const Attribute* const> arrays, const MeshData& original,
                                MeshData& result, int threads) {
  std::vector<CarriedField> list;
  std::vector<Attribute> all;
  if (arrays.empty() || !can_carry(original, result)) return list;
  const std::unique_ptr<Carrier> carrier = carrier_for(original, result, threads);
  Facts facts(original, result);
  for (int dimension = 0; dimension <= 3; ++dimension) {
    if (!has_some(original, dimension) || !has_some(result, dimension)) continue;
    Arrays here;
    for (const Attribute* array : arrays)
      if (array->dimension == dimension) here.push_back(array);
    std::vector<Attribute> results = carrier->on(dimension, here);
    for (std::size_t i = 0; i < here.size(); ++i)
      list.push_back(facts.of(*here[i], results[i], dimension));
    std::move(results.begin(), results.end(), std::back_inserter(all));
  }
  std::move(all.begin(), all.end(), std::back_inserter(result.attributes));
  return list;
}

std::vector<CarriedField> unmoved(std::span<const Attribute* const> arrays, const MeshData& mesh) {
  std::vector<CarriedField> list;
  Facts facts(mesh, mesh);
  for (const Attribute* array : arrays) list.push_back(facts.of(*array, *array, array->dimension));
  return list;
}

}  // namespace aomd::fields
