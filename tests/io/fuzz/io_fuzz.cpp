// Readers against arbitrary bytes. The first byte chooses the name under which the rest is read.
// With clang: -fsanitize=fuzzer,address; without: io_fuzz_test.cpp calls it.

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "core/base/text.h"
#include "core/io/io.h"

namespace {

void check(const aomd::EntityList& list, int dimension, std::size_t vertices) {
  std::size_t sum = 0;
  for (const aomd::Shape shape : list.shapes) {
    if (aomd::shape_template(shape).dimension != dimension) std::abort();
    sum += static_cast<std::size_t>(aomd::shape_template(shape).vertex_count);
  }
  if (list.vertices.size() != sum) std::abort();
  if (!list.classes.empty() && list.classes.size() != list.size()) std::abort();
  for (const std::uint32_t v : list.vertices) {
    if (v >= vertices) std::abort();
  }
}

/// One line that a terminal can take.
bool printable(std::string_view text) { return aomd::printable(text) == text; }

void check(const aomd::io::ReadResult& result) {
  const aomd::MeshData& mesh = result.mesh;
  for (int dimension = 1; dimension <= 3; ++dimension)
    check(mesh.list(dimension), dimension, mesh.positions.size());
  if (!mesh.vertex_classes.empty() && mesh.vertex_classes.size() != mesh.positions.size())
    std::abort();
  if (result.notes.size() > 20 || !std::all_of(result.notes.begin(), result.notes.end(), printable))
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* names[] = {"f.obj", "f.ply", "f.off", "f.stl",  "f.msh", "f.mesh",
                                   "f.vtk", "f.vtu", "f.su2", "f.gltf", "f"};
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    check(aomd::io::read_bytes(names[data[0] % std::size(names)], bytes));
  } catch (const aomd::io::FileError& error) {
    if (!printable(error.what())) std::abort();
  }
  return 0;
}
