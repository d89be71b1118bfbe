#pragma once
// What the programs that run other libraries' simplification share: each is peer.cpp and one file
// for its library.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::peers {

/// A mesh as every library takes it.
struct IndexedMesh {
  std::vector<glm::dvec3> positions;  ///< all of them used
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct Simplified {
  IndexedMesh mesh;
  double seconds =
      0;  ///< the simplification alone: without building the library's mesh and reading it back
  std::string note = {};  ///< what the library could not hold, for the table
};

/// One way in which a library simplifies. `run` aims at `faces` triangles and may stop above or
/// below.
struct Method {
  const char* name;  ///< of the method, as tables show it
  Simplified (*run)(const IndexedMesh& mesh, std::size_t faces);
};

/// Name and version of the library that this program was built with.
[[nodiscard]] std::string library();
/// What it can do. Each library's file defines these two.
[[nodiscard]] std::span<const Method> methods();

/// Seconds that `work` takes by the wall clock.
template <typename Work>
[[nodiscard]] double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// "4078 of 202520 faces rejected", or nothing when all were taken: libraries of half-edges refuse
/// faces that would make an edge non-manifold.
[[nodiscard]] std::string rejection(std::size_t rejected, std::size_t faces);

}  // namespace aomd::peers
