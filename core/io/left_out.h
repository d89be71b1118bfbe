#pragma once
// What a mesh carries that operations on it do not follow, or that formats do not hold.

#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io {

/// Makes `result`, to_data() of a Mesh that was built from `original`, true in all that operations
/// do not follow. Where nothing changed, that is all of the original: arrays too that a Mesh does
/// not hold. Where something did, arrays go, but for the marks and references of Medit (a mark of
/// what is required stays on what is where it was), and so do periodic links. Returns what is to be
/// said about it: a line that names what is left out, or nothing. O(size log size).
[[nodiscard]] std::vector<std::string> leave_out_unfollowed(const MeshData& original,
                                                            MeshData& result);

/// The line about arrays and periodic links that the format of this name does not hold, or nothing.
/// Throws WriteError for an extension that no format has.
[[nodiscard]] std::vector<std::string> leaves_out(const std::filesystem::path& file,
                                                  const MeshData& mesh);

}  // namespace aomd::io
