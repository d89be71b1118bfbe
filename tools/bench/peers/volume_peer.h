#pragma once
// What the programs that make volumes coarser with other libraries share: each is volume_peer.cpp
// and one file for its library.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::peers {

/// Tetrahedra as every library takes them.
struct TetMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<int> regions;                          ///< the model region of each, from 1
  std::vector<std::array<std::uint32_t, 2>> curves;  ///< the edges on model edges
};

/// Name and version of the library that this program was built with.
[[nodiscard]] std::string library();
/// What `remesh` takes beside the mesh: "factor", of the mean length of the edges at a vertex, or
/// "tets".
[[nodiscard]] std::string wants();
/// Each library's file defines these three.
[[nodiscard]] TetMesh remesh(const TetMesh& mesh, double amount);

}  // namespace aomd::peers
