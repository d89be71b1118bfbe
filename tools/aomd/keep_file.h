#pragma once
// Vertices that stay, as a file lists them.

#include <filesystem>
#include <memory>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"

namespace aomd::cli {

/// Nonzero at each vertex that stays. The file holds one item a line: a vertex (`123`, from 0 as in
/// the mesh's file), a range (`10-20`, both ends included), or a model entity (`vertex 3`, `edge
/// 7`, `face 2`), which keeps all vertices of what lies on it; `#` starts a comment. O(entities).
/// Throws io::ReadError with the line for what is none of these and for vertices and model entities
/// that the mesh does not have.
[[nodiscard]] std::shared_ptr<const Column<Vertex, std::uint8_t>> read_keep_file(
    const std::filesystem::path& file, const Mesh& mesh);

}  // namespace aomd::cli
