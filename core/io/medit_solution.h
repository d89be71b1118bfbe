#pragma once
// The file of arrays that stands beside a Medit mesh: .sol beside .mesh, .solb beside .meshb.

#include <string>
#include <vector>

#include "core/io/source.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// What its n-th array on entities of a dimension is called: the file has no names.
[[nodiscard]] std::string solution_name(std::size_t n);

/// Appends its arrays to those of the mesh that it belongs to. Throws ReadError where that has
/// other numbers of vertices or elements.
void read_solution(const Source& source, MeshData& mesh);

/// The arrays that it has a place for: finite real numbers on vertices and elements, of 1 (a
/// scalar), 3 (a vector), 6 (a symmetric matrix) or 9 components (a matrix).
[[nodiscard]] std::vector<const Attribute*> solution_arrays(const MeshData& mesh);

/// The file; empty where the mesh has no such array.
[[nodiscard]] std::string write_solution(const MeshData& mesh, bool binary);

}  // namespace aomd::io::detail
