// Readers against arbitrary bytes. The first byte chooses the name under which the rest is read.
// With clang: -fsanitize=fuzzer,address; without: tests/io_fuzz_test.cpp calls it.

#include <cstdint>
#include <cstdlib>

#include "core/io/io.h"

namespace {

void check(const aomd::EntityList& list, std::size_t per_entity, std::size_t vertices) {
  if (list.vertices.size() != per_entity * list.size()) std::abort();
  if (!list.classes.empty() && list.classes.size() != list.size()) std::abort();
  for (const std::uint32_t v : list.vertices) {
    if (v >= vertices) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr const char* names[] = {"f.obj", "f.ply", "f.off", "f.stl", "f"};
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  try {
    const aomd::MeshData mesh = aomd::io::read_bytes(names[data[0] % 5], bytes).mesh;
    check(mesh.faces, 3, mesh.positions.size());
    check(mesh.edges, 2, mesh.positions.size());
    if (!mesh.vertex_classes.empty() && mesh.vertex_classes.size() != mesh.positions.size()) std::abort();
  } catch (const aomd::io::FileError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
