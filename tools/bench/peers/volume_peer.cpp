// aomd-volume-peer-*: makes the tetrahedra of a classified mesh fewer with another library.
//   aomd-volume-peer-X               prints the library and what AMOUNT is
//   aomd-volume-peer-X IN OUT AMOUNT

#include "tools/bench/peers/volume_peer.h"

#include <cstdlib>
#include <exception>
#include <iostream>

#include "core/io/io.h"
#include "core/mesh/handle.h"

namespace aomd::peers {
namespace {

// Without vertices that no tetrahedron uses, which not every library takes.
TetMesh read(const char* file) {
  const MeshData data = io::read(file).mesh;
  TetMesh mesh;
  std::vector<std::uint32_t> place(data.positions.size(), no_index);
  for (const std::uint32_t v : data.regions.vertices) {
    if (place[v] != no_index) continue;
    place[v] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(data.positions[v]);
  }
  for (std::size_t i = 0; i < data.regions.size(); ++i) {
    const std::uint32_t* v = &data.regions.vertices[4 * i];
    mesh.tets.push_back({place[v[0]], place[v[1]], place[v[2]], place[v[3]]});
    mesh.regions.push_back(data.regions.classes.empty() ? 1 : data.regions.classes[i].tag());
  }
  for (std::size_t i = 0; i < data.edges.classes.size(); ++i) {
    const std::uint32_t* v = &data.edges.vertices[2 * i];
    if (data.edges.classes[i].dimension() == 1) mesh.curves.push_back({place[v[0]], place[v[1]]});
  }
  return mesh;
}

void write(const char* file, const TetMesh& mesh) {
  MeshData data;
  data.positions = mesh.positions;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tets[i];
    data.regions.add(Shape::Tetrahedron, {a, b, c, d}, ModelRef(3, mesh.regions[i]));
  }
  io::write(file, data);
}

int run(int argc, char** argv) {
  if (argc != 4) {
    std::cout << library() << '\n' << wants() << '\n';
    return argc == 1 ? 0 : 2;
  }
  write(argv[2], remesh(read(argv[1]), std::strtod(argv[3], nullptr)));
  return 0;
}

}  // namespace
}  // namespace aomd::peers

int main(int argc, char** argv) {
  try {
    return aomd::peers::run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << argv[0] << ": " << e.what() << '\n';
    return 3;
  }
}
