#include "core/model/gmsh_model.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/model/cad_file.h"
#include "core/model/gmsh_library.h"
#include "core/model/projection.h"

namespace aomd {
namespace {

using gmsh::call;
using gmsh::functions;

// A function of the interface that takes parameters of an entity and returns numbers, `at least
// `wanted`.
template <typename Function>
std::vector<double> evaluate(Function function, ModelRef e, std::vector<double> parameters,
                             std::size_t wanted) {
  gmsh::Array<double> out;
  call(function, e.dimension(), e.tag(), parameters.data(), parameters.size(), &out.data,
       &out.size);
  if (out.size < wanted) throw ModelError("Gmsh cannot evaluate " + name_of(e));
  return {out.data, out.data + out.size};
}

glm::dvec3 triple(const std::vector<double>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

std::vector<double> flat(ModelRef e, const std::vector<glm::dvec2>& parameters) {
  std::vector<double> numbers;
  for (const glm::dvec2& t : parameters) {
    if (e.dimension() >= 1) numbers.push_back(t.x);
    if (e.dimension() == 2) numbers.push_back(t.y);
  }
  return numbers;
}

std::vector<glm::dvec3> positions_at(ModelRef e, const std::vector<glm::dvec2>& parameters) {
  const auto numbers =
      evaluate(functions().ModelGetValue, e, flat(e, parameters), 3 * parameters.size());
  std::vector<glm::dvec3> positions;
  for (std::size_t i = 0; i < parameters.size(); ++i) positions.push_back(triple(numbers, i));
  return positions;
}

Jet jet_at(ModelRef e, const glm::dvec2& t) {
  const std::vector<double> at = flat(e, {t});
  const bool surface = e.dimension() == 2;
  const auto first = evaluate(functions().ModelGetDerivative, e, at, surface ? 6 : 3);
  const auto second = evaluate(functions().ModelGetSecondDerivative, e, at, surface ? 9 : 3);
  Jet jet{positions_at(e, {t})[0], triple(first, 0), {}, triple(second, 0), {}, {}};
  if (surface) jet.v = triple(first, 1), jet.vv = triple(second, 1), jet.uv = triple(second, 2);
  return jet;
}

// Gmsh does not say which parametrisations close: those whose two ends are the same points.
std::array<bool, 2> closed_directions(ModelRef e, const ParameterRange& range) {
  std::array<bool, 2> closed{};
  for (int k = 0; k < e.dimension(); ++k) {
    std::vector<glm::dvec2> ends;
    for (const double across : {0.21, 0.5, 0.83}) {
      glm::dvec2 t = range.low + across * (range.high - range.low);
      t[k] = range.low[k], ends.push_back(t);
      t[k] = range.high[k], ends.push_back(t);
    }
    const auto p = positions_at(e, ends);
    Box box;
    for (const glm::dvec3& q : p) box.add(q);
    const double gap =
        std::max({glm::length(p[0] - p[1]), glm::length(p[2] - p[3]), glm::length(p[4] - p[5])});
    closed[static_cast<std::size_t>(k)] = gap <= 1e-9 * std::max(box.diagonal(), glm::length(p[0]));
  }
  return closed;
}

ParameterRange range_in_gmsh(ModelRef e) {
  gmsh::Array<double> low, high;
  call(functions().ModelGetParametrizationBounds, e.dimension(), e.tag(), &low.data, &low.size,
       &high.data, &high.size);
  const auto n = static_cast<std::size_t>(e.dimension());
  if (low.size < n || high.size < n) throw ModelError("Gmsh knows no parameters of " + name_of(e));
  ParameterRange range;
  for (std::size_t k = 0; k < n; ++k) {
    range.low[static_cast<int>(k)] = low.data[k];
    range.high[static_cast<int>(k)] = high.data[k];
  }
  range.periodic = closed_directions(e, range);
  return range;
}

// How many samples in each direction show every hollow of the distance.
int samples_across(ModelRef e) {
  char* text = nullptr;
  call(functions().ModelGetType, e.dimension(), e.tag(), &text);
  const std::string type = text;
  functions().Free(text);
  if (type == "Line" || type == "Plane") return 3;
  if (e.dimension() == 1) return 128;
  return type == "Cylinder" || type == "Cone" || type == "Sphere" || type == "Torus" ? 24 : 48;
}

std::vector<Model::Entry> entries_of(const gmsh::File& file) {
  std::vector<Model::Entry> entries;
  for (const ModelRef e : file.entities()) {
    Model::Entry& entry = entries.emplace_back(Model::Entry{e, {}});
    int dim_tag[2] = {e.dimension(), e.tag()};
    gmsh::Array<int> border, embedded;
    call(functions().ModelGetBoundary, dim_tag, std::size_t{2}, &border.data, &border.size, 0, 0,
         0);
    if (e.dimension() >= 2)
      call(functions().ModelMeshGetEmbedded, e.dimension(), e.tag(), &embedded.data,
           &embedded.size);
    for (const auto& list : {border.values(), embedded.values()})
      for (std::size_t i = 0; i + 1 < list.size(); i += 2)
        entry.boundary.emplace_back(list[i], std::abs(list[i + 1]));
    std::sort(entry.boundary.begin(), entry.boundary.end());
    entry.boundary.erase(std::unique(entry.boundary.begin(), entry.boundary.end()),
                         entry.boundary.end());
  }
  return entries;
}

class GmshModel final : public Model {
 public:
  explicit GmshModel(std::unique_ptr<gmsh::File> file)
      : Model(entries_of(*file)), file_(std::move(file)) {
    for (std::size_t i = 0; i < size(); ++i) {
      const ModelRef e = entity(i);
      Projection& projection = projections_.emplace_back();
      if (e.dimension() < 1 || e.dimension() > 2) continue;
      const ParameterRange range = range_in_gmsh(e);
      const int across = samples_across(e);
      const auto places = Projection::sample_places(range, e.dimension(), across);
      projection = Projection(range, e.dimension(), across, positions_at(e, places));
    }
  }

 private:
  ClosestPoint closest_on(std::size_t index, const glm::dvec3& point) const override {
    file_->make_current();
    const ModelRef e = entity(index);
    if (e.dimension() == 0) return {positions_at(e, {{}})[0], {}};
    const auto jet = [e](const glm::dvec2& t) { return jet_at(e, t); };
    return projections_[index].closest(jet, point);
  }

  glm::dvec3 normal_of(std::size_t index, const glm::dvec3& point) const override {
    std::vector<double> at = flat(entity(index), {*closest_on(index, point).parameters});
    gmsh::Array<double> out;
    call(functions().ModelGetNormal, entity(index).tag(), at.data(), at.size(), &out.data,
         &out.size);
    const glm::dvec3 normal =
        out.size == 3 ? glm::dvec3(out.data[0], out.data[1], out.data[2]) : glm::dvec3(0);
    const double length = glm::length(normal);
    if (!(length > 0)) throw ModelError(name_of(entity(index)) + " has no normal here");
    return normal / length;
  }

  std::optional<ParameterRange> range_of(std::size_t index) const override {
    const int dim = entity(index).dimension();
    if (dim < 1 || dim > 2) return {};
    return projections_[index].range();
  }

  glm::dvec3 evaluate_at(std::size_t index, const glm::dvec2& parameters) const override {
    file_->make_current();
    return positions_at(entity(index), {parameters})[0];
  }

  Box box_of(std::size_t index) const override {
    file_->make_current();
    const ModelRef e = entity(index);
    Box b;
    call(functions().ModelGetBoundingBox, e.dimension(), e.tag(), &b.low.x, &b.low.y, &b.low.z,
         &b.high.x, &b.high.y, &b.high.z);
    return b;
  }

  std::unique_ptr<gmsh::File> file_;
  std::vector<Projection> projections_;  ///< by entity; empty for vertices and regions
};

}  // namespace

bool has_gmsh() {
  try {
    static_cast<void>(functions());
    return true;
  } catch (const ModelError&) {
    return false;
  }
}

std::unique_ptr<Model> load_gmsh_model(const std::string& path) {
  auto file = std::make_unique<gmsh::File>(path);
  try {
    return std::make_unique<GmshModel>(std::move(file));
  } catch (const std::invalid_argument& e) {
    throw ModelError(path + ": " + e.what());
  }
}

}  // namespace aomd
