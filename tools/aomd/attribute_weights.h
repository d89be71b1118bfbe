#pragma once
// What --attributes says of the arrays of a surface.

#include <string>
#include <vector>

#include "core/decimate/counted_values.h"

namespace aomd::cli {

/// What counts: colours and texture coordinates, changed by words such as "uv=0" and "heat=2";
/// after "none" only what follows. Throws UsageError for what the mesh does not have.
[[nodiscard]] std::vector<ArrayWeight> attribute_weights(const MeshData& mesh,
                                                         const std::vector<std::string>& words);

}  // namespace aomd::cli
