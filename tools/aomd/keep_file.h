#pragma once
// Vertices that stay, as a file lists them or the mesh's own file requires.

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

/// Nonzero at each vertex that such a file does not list, and at those that stay anyway (`keep`, or
/// null). Here a model entity lists the vertices that lie on it, and not those of what bounds it: a
/// region the vertices inside it. O(entities). Throws as read_keep_file does.
[[nodiscard]] std::shared_ptr<const Column<Vertex, std::uint8_t>> read_only_file(
    const std::filesystem::path& file, const Mesh& mesh,
    const std::shared_ptr<const Column<Vertex, std::uint8_t>>& keep);

/// Marks what the mesh's own file requires: vertices with the mark of Medit, and those of edges and
/// faces with it, besides those that stay anyway (`keep`, or null). Null where nothing
/// stays. `required` receives the number of required vertices. O(entities).
[[nodiscard]] std::shared_ptr<const Column<Vertex, std::uint8_t>> keep_required(
    const Mesh& mesh, const std::shared_ptr<const Column<Vertex, std::uint8_t>>& keep,
    std::size_t& required);

}  // namespace aomd::cli
