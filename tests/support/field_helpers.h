#pragma once
// Volumes with arrays, decimated, and what the arrays come to.

#include <cmath>
#include <functional>
#include <map>

#include "core/decimate/decimation.h"
#include "core/fields/cells.h"
#include "core/fields/field.h"
#include "core/io/left_out.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"

namespace aomd::test {

using Function = std::function<double(const glm::dvec3&)>;

/// A function that no axis is special to.
inline double slanted(const glm::dvec3& p) { return 3 * p.x - 2 * p.y + 0.5 * p.z + 7; }

/// The values of a function at all entities of a dimension: at vertices, or in the middle of cells.
inline std::vector<double> values_at(const MeshData& mesh, int dim, const Function& f) {
  std::vector<double> values;
  if (dim == 0)
    for (const glm::dvec3& p : mesh.positions) values.push_back(f(p));
  if (dim == 0) return values;
  const fields::Cells cells(mesh, dim);
  for (std::uint32_t i = 0; i < cells.size(); ++i) values.push_back(f(cells.centre(i)));
  return values;
}

inline Attribute field(const MeshData& mesh, const char* name, int dim, const Function& f) {
  return {name, dim, 1, false, values_at(mesh, dim, f)};
}

inline const Attribute* find(const MeshData& mesh, const std::string& name, int dim) {
  for (const Attribute& a : mesh.attributes)
    if (a.name == name && a.dimension == dim) return &a;
  return nullptr;
}

struct Carried {
  MeshData mesh;
  io::CarriedAlong along;
};

/// The mesh with a share of its tetrahedra, or faces where there are none, and its arrays.
inline Carried decimated(const MeshData& original, double share, int threads = 1,
                         const ClassifyOptions& how = {}) {
  Mesh mesh(original);
  classify(mesh, how);
  DecimationOptions options;
  options.strategy = Strategy::Quality;
  options.target_faces = static_cast<std::uint32_t>(share * mesh.count(mesh.dimension()));
  options.angle_deg = usual_angle_deg(options.strategy, false);
  options.threads = threads;
  Decimation(mesh, options).run();
  Carried result{to_data(mesh), {}};
  result.along = io::carry_along(original, result.mesh, threads);
  return result;
}

/// How often cells of a dimension use a vertex at x = 1, where two parts touch: the first array is
/// expected to be -1 in the part below and 1 in the one above.
inline std::size_t uses_at_contact(const MeshData& mesh, int dimension) {
  const fields::Cells cells(mesh, dimension);
  std::size_t at_contact = 0;
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    for (const std::uint32_t v : cells.vertices(i)) {
      EXPECT_EQ(mesh.attributes[0].values[v], cells.centre(i).x < 1 ? -1 : 1);
      at_contact += mesh.positions[v].x == 1;
    }
  return at_contact;
}

/// The integral of a component over each class, and that of its size over all.
inline std::map<std::uint32_t, double> integrals(const MeshData& mesh, const Attribute& a,
                                                 std::size_t component, double& size) {
  const std::vector<double> measures = fields::measures(mesh, a.dimension);
  std::map<std::uint32_t, fields::Sum> sums;
  size = 0;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const double x = a.values[static_cast<std::size_t>(a.components) * i + component];
    sums[mesh.list(a.dimension).classes[i].bits()].add(measures[i] * x);
    size += measures[i] * std::abs(x);
  }
  std::map<std::uint32_t, double> result;
  for (const auto& [model, sum] : sums) result[model] = sum.value();
  return result;
}

}  // namespace aomd::test
