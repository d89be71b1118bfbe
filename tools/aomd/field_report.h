#pragma once
// What the commands say of arrays: what they are, and what became of them.

#include <iosfwd>
#include <string>
#include <vector>

#include "core/fields/carry.h"
#include "core/measure/field_comparison.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// "fields" of a report: each array that went along, before and after.
[[nodiscard]] Json fields_json(const std::vector<fields::CarriedField>& list);

/// A line for each, 20 at most: its range and its integral before and after, of vectors by
/// component in JSON alone.
void print_fields(std::ostream& out, const std::vector<fields::CarriedField>& list);

/// The arrays of a mesh by themselves: name, place, components, type and range.
[[nodiscard]] Json arrays_json(const MeshData& mesh);
void print_arrays(std::ostream& out, const MeshData& mesh);
/// The same of materials and their pictures.
[[nodiscard]] Json materials_json(const MeshData& mesh);
void print_materials(std::ostream& out, const MeshData& mesh);

/// What arrays of two meshes differ by; `extent` is what a share is of: "volume" or "area".
[[nodiscard]] Json differences_json(const std::vector<measure::FieldDifference>& list);
void print_differences(std::ostream& out, const std::vector<measure::FieldDifference>& list,
                       const std::string& extent);

}  // namespace aomd::cli
