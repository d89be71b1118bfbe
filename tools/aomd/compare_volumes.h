#pragma once
// aomd compare for meshes with regions.

#include "core/mesh/mesh.h"
#include "tools/aomd/compare_arguments.h"

namespace aomd::cli {

/// Prints what `result` kept of `original`; returns the exit code.
int compare_volumes(const CompareArguments& options, const Mesh& original, const Mesh& result);

}  // namespace aomd::cli
