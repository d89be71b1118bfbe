#pragma once
// What a mesh carries that operations on it do not see.

#include <string>
#include <vector>

#include "core/fields/carry.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io {

/// What carry_along() did.
struct CarriedAlong {
  /// What is to be said about it, a line each: how many values are no numbers, what is left out.
  std::vector<std::string> notes;
  std::vector<fields::CarriedField> fields;  ///< the arrays that went along
};

/// Makes `result`, to_data() of a Mesh that was built from `original`, true in all that operations
/// do not see. Where nothing changed, that is all of the original: arrays too that a Mesh does not
/// hold. Where something did, the arrays go along (fields::carry), but for what Medit says: its
/// marks and references stay (a mark of what is required on what is where it was), its normals go,
/// and so do periodic links. Labels that name the class of their entities (the materials of VTK)
/// follow that. The same for any number of threads. O(size log size).
[[nodiscard]] CarriedAlong carry_along(const MeshData& original, MeshData& result, int threads = 1);

}  // namespace aomd::io
