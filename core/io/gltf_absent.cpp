// In place of gltf_read.cpp and gltf_write.cpp where tinygltf is missing.

#include "core/io/formats.h"

namespace aomd::io::detail {
namespace {

constexpr const char* absent = "this program was built without glTF (package libtinygltf-dev)";

}  // namespace

bool has_gltf() { return false; }

ReadResult read_gltf(const Source& source) { source.fail(absent); }

void write_gltf(const std::filesystem::path& path, const MeshData&, bool, bool, EncodedMesh&) {
  throw WriteError(path.string(), {}, absent);
}

}  // namespace aomd::io::detail
