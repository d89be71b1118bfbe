#pragma once
// aomd compare for meshes with regions.

#include "core/mesh/mesh.h"
#include "tools/aomd/compare_options.h"

namespace aomd::cli {

/// Prints what `result` kept of `original`; returns the exit code.
int compare_volumes(const CompareOptions& options, const Mesh& original, const Mesh& result);

}  // namespace aomd::cli
