#pragma once
// aomd compare for meshes with regions.

#include <vector>

#include "core/measure/field_comparison.h"
#include "core/mesh/mesh.h"
#include "tools/aomd/compare_arguments.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// What `result` kept of `original`, and what their arrays differ by, as --json prints it.
[[nodiscard]] Json volume_comparison_json(const CompareArguments& options, const Mesh& original,
                                          const Mesh& result,
                                          std::vector<measure::FieldDifference> fields);

/// Prints what `result` kept of `original`, and what their arrays differ by; returns the exit code.
int compare_volumes(const CompareArguments& options, const Mesh& original, const Mesh& result,
                    std::vector<measure::FieldDifference> fields);

}  // namespace aomd::cli
