#pragma once
// What a mesh loses in a file.

#include <string>
#include <vector>

#include "core/io/io.h"

namespace aomd::io::detail {

/// Names what the mesh has and the format, as text or `binary`, does not hold; `beside`: a Medit
/// mesh has its file of arrays.
void note_losses(Format format, bool binary, bool beside, const MeshData& mesh,
                 std::vector<std::string>& notes);

/// What a mesh is written as instead, where 32-bit floats do it harm: "text", or another format.
[[nodiscard]] std::string_view exact_form(Format format);

/// Says what rounding to 32-bit floats does to the mesh, and what keeps it.
void note_rounding(const MeshData& mesh, std::string_view exact, std::vector<std::string>& notes);

/// Why the mesh should not be rounded so: more than one face in a hundred would have fewer than 3
/// different corners. Else an empty string.
[[nodiscard]] std::string rounding_defect(const MeshData& mesh, std::string_view exact);

}  // namespace aomd::io::detail
