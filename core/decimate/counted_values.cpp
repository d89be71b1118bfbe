#include "core/decimate/counted_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/fields/field.h"
#include "core/mesh/extent.h"

namespace aomd {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Where values lie, and how far apart they can be.
struct Range {
  double middle = 0, length = 0;
};

/// What whole numbers of a type can be, colours have; 0 where no type says so.
double whole_colours(const Attribute& array) {
  if (array.type == NumberType::UInt8) return 255;
  return array.type == NumberType::UInt16 ? 65535 : 0;
}

// Nearly the same colours all over are no colours to keep apart: theirs is the range of what could
// be. Of other arrays nobody knows that.
Range range_of(const Attribute& array) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double x : array.values) {
    if (!std::isfinite(x)) continue;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (!(low < high)) return {};
  Range range{low / 2 + high / 2, high - low};
  const bool known = array.meaning == Meaning::Colour || array.meaning == Meaning::Texture;
  if (known && !array.integer) range.length = 1;
  if (known && whole_colours(array) > 0) range.length = whole_colours(array);
  return range;
}

/// By vertex: what all corners there agree on, else nothing.
std::vector<double> on_vertices(const MeshData& mesh, const Attribute& corners) {
  const auto n = static_cast<std::size_t>(corners.components);
  std::vector<double> values(n * mesh.positions.size(), nothing);
  std::vector<bool> seen(mesh.positions.size());
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c) {
    const std::uint32_t v = mesh.faces.vertices[c];
    for (std::size_t k = 0; k < n; ++k) {
      double& at_vertex = values[n * v + k];
      const double here = corners.values[n * c + k];
      if (!seen[v])
        at_vertex = here;
      else if (at_vertex != here)
        at_vertex = nothing;
    }
    seen[v] = true;
  }
  return values;
}

/// Fills some components of every vertex.
void fill(CountedValues& counted, std::size_t first, const std::vector<double>& values,
          std::size_t components, const Range& range, double full, const Mesh& mesh) {
  const double scale = range.length > 0 ? full / range.length : 0;
  auto next = values.begin();
  for (const Vertex v : mesh.vertices())
    for (std::size_t k = 0; k < components; ++k, ++next) {
      const double x = std::isfinite(*next) ? scale * (*next - range.middle) : nothing;
      counted.numbers[counted.components * v.index + first + k] = static_cast<float>(x);
    }
}

}  // namespace

bool can_count(const Attribute& array, bool on_corners) {
  return (on_corners || array.dimension == 0) && fields::kind_of(array) != fields::FieldKind::Label;
}

std::vector<ArrayWeight> usual_weights(const MeshData& mesh) {
  std::vector<ArrayWeight> weights;
  const auto look_at = [&](const Attribute& a, bool on_corners) {
    const bool usual = a.meaning == Meaning::Colour || a.meaning == Meaning::Texture;
    if (usual && can_count(a, on_corners))
      weights.push_back({a.name, a.meaning == Meaning::Colour ? 3.0 : 1.0});
  };
  for (const Attribute& a : mesh.attributes) look_at(a, false);
  for (const Attribute& a : mesh.corners) look_at(a, true);
  return weights;
}

std::shared_ptr<const CountedValues> counted_values(const MeshData& data, const Mesh& mesh,
                                                    std::span<const ArrayWeight> weights) {
  struct Counted {
    const Attribute& array;
    bool on_corners;
    double weight;
  };
  std::vector<Counted> list;
  const auto take = [&](const Attribute& a, bool on_corners) {
    const auto found = std::find_if(weights.begin(), weights.end(),
                                    [&](const ArrayWeight& w) { return w.name == a.name; });
    if (found != weights.end() && found->weight > 0 && can_count(a, on_corners))
      list.push_back({a, on_corners, found->weight});
  };
  for (const Attribute& a : data.attributes) take(a, false);
  for (const Attribute& a : data.corners) take(a, true);
  if (list.empty()) return nullptr;
  const auto counted = std::make_shared<CountedValues>();
  for (const Counted& one : list)
    counted->components += static_cast<std::size_t>(one.array.components);
  counted->numbers.resize(counted->components * mesh.capacity(0));
  std::size_t first = 0;
  for (const auto& [array, on_corners, weight] : list) {
    const auto n = static_cast<std::size_t>(array.components);
    const bool fits = !on_corners && fields::kind_of(array) == fields::FieldKind::Colour;
    counted->fitted.insert(counted->fitted.end(), n, fits);
    fill(*counted, first, on_corners ? on_vertices(data, array) : array.values, n, range_of(array),
         1e-3 * weight * diagonal_of(data), mesh);
    first += n;
  }
  return counted;
}

}  // namespace aomd
