// meshoptimizer (MIT): passes of independent collapses on index buffers, vertices stay where they
// are.

#include <meshoptimizer.h>

#include <limits>

#include "tools/bench/peers/peer.h"

namespace aomd::peers {
namespace {

/// Its meshes are arrays of its own precision; unused vertices are dropped afterwards.
Simplified simplify(const IndexedMesh& mesh, std::size_t faces) {
  std::vector<float> positions;
  std::vector<unsigned> indices, result(3 * mesh.triangles.size());
  for (const glm::dvec3& p : mesh.positions)
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
  for (const auto& t : mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
  Simplified simplified;
  simplified.seconds = seconds_of([&] {
    result.resize(meshopt_simplify(result.data(), indices.data(), indices.size(), positions.data(),
                                   mesh.positions.size(), 3 * sizeof(float), 3 * faces,
                                   std::numeric_limits<float>::max()));
  });
  simplified.mesh.positions = mesh.positions;
  for (std::size_t i = 0; i < result.size(); i += 3)
    simplified.mesh.triangles.push_back({result[i], result[i + 1], result[i + 2]});
  return simplified;
}

constexpr Method all[] = {{"simplify", simplify}};

}  // namespace

std::string library() {
  return "meshoptimizer " + std::to_string(MESHOPTIMIZER_VERSION / 1000) + "." +
         std::to_string(MESHOPTIMIZER_VERSION / 10 % 100);
}
std::span<const Method> methods() { return all; }

}  // namespace aomd::peers
