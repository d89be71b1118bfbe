#pragma once
// What a mesh loses in a file.

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/io.h"

namespace aomd::io::detail {

/// Names what the mesh has and the format, as text or `binary`, does not hold.
void note_losses(Format format, bool binary, const MeshData& mesh, std::vector<std::string>& notes);

/// Says what rounding to 32-bit floats does to the mesh. Throws WriteError where more than one face
/// in a hundred would have fewer than 3 different corners.
void note_rounding(const std::filesystem::path& path, const MeshData& mesh,
                   std::vector<std::string>& notes);

}  // namespace aomd::io::detail
