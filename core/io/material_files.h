#pragma once
// Materials that files beside a mesh describe: the .mtl of OBJ, the picture that PLY names.

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/io.h"

namespace aomd::io::detail {

/// Gives a mesh that was read from a file the materials of the libraries that it names, and says
/// which of them, and which pictures, are missing.
void add_materials(const std::filesystem::path& file, ReadResult& result);

/// The libraries that an OBJ at this place is to name. Those of the mesh, and its pictures, are
/// copied where they are not there yet; one is made of materials that are in none.
[[nodiscard]] std::vector<std::string> libraries_for(const std::filesystem::path& path,
                                                     const MeshData& mesh, EncodedMesh& encoded);

/// The lines that a PLY at this place is to have: those of the mesh, and one that names the picture
/// of its only material, which is copied where it is not there yet.
[[nodiscard]] std::vector<Remark> ply_remarks_for(const std::filesystem::path& path,
                                                  const MeshData& mesh, EncodedMesh& encoded);

/// The libraries that a mesh names, as it does.
[[nodiscard]] std::vector<std::string> named_libraries(const MeshData& mesh);

}  // namespace aomd::io::detail
