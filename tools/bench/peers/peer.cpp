// aomd-peer-LIBRARY: lists the library's methods, or runs one of them on a file.
//   aomd-peer-LIBRARY                             one line a method: its number, library and name
//   aomd-peer-LIBRARY NUMBER MESH FACES OUT.ply   prints what tools/bench/peers.sh needs as one
//                                                 line of JSON

#include "tools/bench/peers/peer.h"

#include <sys/resource.h>

#include <cstdlib>
#include <exception>
#include <iostream>

#include "core/io/io.h"

namespace aomd::peers {
namespace {

/// The triangles of a file; quads are cut. Vertices keep the order of the file, those that no face
/// uses are left out.
IndexedMesh load(const char* file) {
  const MeshData data = io::read(file).mesh;
  std::vector<std::uint32_t> number(data.positions.size(), 0);
  for (const std::uint32_t v : data.faces.vertices) number[v] = 1;
  IndexedMesh mesh;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(data.positions[v]);
  }
  std::size_t begin = 0;
  for (const Shape shape : data.faces.shapes) {
    const std::uint32_t* v = data.faces.vertices.data() + begin;
    const auto n = static_cast<std::size_t>(shape_template(shape).vertex_count);
    for (std::size_t k = 2; k < n; ++k)
      mesh.triangles.push_back({number[v[0]], number[v[k - 1]], number[v[k]]});
    begin += n;
  }
  return mesh;
}

void save(const char* file, const IndexedMesh& mesh) {
  MeshData data;
  data.positions = mesh.positions;
  for (const auto& [a, b, c] : mesh.triangles) data.faces.add(Shape::Triangle, {a, b, c});
  io::write(file, data);
}

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void list() {
  for (std::size_t i = 0; i < methods().size(); ++i)
    std::cout << i << ' ' << library() << ' ' << methods()[i].name << '\n';
}

int run(const Method& method, const char* file, std::size_t faces, const char* out) {
  const IndexedMesh mesh = load(file);
  const Simplified simplified = method.run(mesh, faces);
  const std::size_t peak = peak_bytes();
  save(out, simplified.mesh);
  std::cout << "{\"seconds\": " << simplified.seconds
            << ", \"faces\": " << simplified.mesh.triangles.size() << ", \"peak\": " << peak
            << ", \"note\": \"" << simplified.note << "\"}\n";
  return 0;
}

}  // namespace

std::string rejection(std::size_t rejected, std::size_t faces) {
  return rejected == 0 ? ""
                       : std::to_string(rejected) + " of " + std::to_string(faces) +
                             " faces rejected (non-manifold)";
}

}  // namespace aomd::peers

int main(int argc, char** argv) {
  using namespace aomd::peers;
  if (argc == 1) return list(), 0;
  const std::size_t number = std::strtoul(argv[1], nullptr, 10);
  if (argc != 5 || number >= methods().size()) {
    std::cerr << "usage: " << argv[0] << " [NUMBER MESH FACES OUT.ply]\n";
    return 2;
  }
  try {
    return run(methods()[number], argv[2], std::strtoul(argv[3], nullptr, 10), argv[4]);
  } catch (const std::exception& e) {
    std::cerr << argv[0] << ": " << e.what() << '\n';
    return 1;
  }
}
