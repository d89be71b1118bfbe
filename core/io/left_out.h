#pragma once
// What a mesh carries that operations on it do not follow.

#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io {

/// Makes `result`, to_data() of a Mesh that was built from `original`, true in all that operations
/// do not follow. Where nothing changed, that is all of the original: arrays too that a Mesh does
/// not hold. Where something did, arrays go, but for the marks and references of Medit (a mark of
/// what is required stays on what is where it was) and labels that name the class of their entities
/// (the materials of VTK), and so do periodic links. Returns what is to be
/// said about it: a line that names what is left out, or nothing. O(size log size).
[[nodiscard]] std::vector<std::string> leave_out_unfollowed(const MeshData& original,
                                                            MeshData& result);

}  // namespace aomd::io
