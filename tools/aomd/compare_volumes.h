#pragma once
// aomd compare for meshes with regions.

#include <vector>

#include "core/measure/field_comparison.h"
#include "core/mesh/mesh.h"
#include "tools/aomd/compare_arguments.h"

namespace aomd::cli {

/// Prints what `result` kept of `original`, and what their arrays differ by; returns the exit code.
int compare_volumes(const CompareArguments& options, const Mesh& original, const Mesh& result,
                    std::vector<measure::FieldDifference> fields);

}  // namespace aomd::cli
