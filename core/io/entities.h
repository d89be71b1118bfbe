#pragma once
// What every reader checks of an entity before it goes into a list.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/notes.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

[[nodiscard]] inline bool outside(std::int64_t index, std::uint64_t vertex_count) {
  return index < 0 || static_cast<std::uint64_t>(index) >= vertex_count;
}

/// What is wrong with a 0-based index that is outside; the message counts from `first`, as the file
/// does.
[[nodiscard]] std::string out_of_range(std::int64_t index, std::uint64_t vertex_count,
                                       int first = 0);

/// The first of these that is outside, as out_of_range() says it, or an empty string.
[[nodiscard]] std::string range_defect(std::span<const std::int64_t> vertices,
                                       std::uint64_t vertex_count, int first = 0);

/// What is wrong with an entity by these 0-based vertices (out of range, one of them twice), or an
/// empty string. No allocation for 8 vertices or fewer.
[[nodiscard]] std::string entity_defect(Shape shape, std::span<const std::int64_t> vertices,
                                        std::uint64_t vertex_count, int first = 0);

/// What is left of an edge or a face that entity_defect() finds fault with, by its vertices: a
/// triangle of a quad, or none where it is to be dropped. It is counted in `repeats`. Nothing where
/// the file is to be refused: for a vertex out of range, and for regions.
[[nodiscard]] std::optional<std::vector<std::int64_t>> without_repeats(
    Shape shape, std::span<const std::int64_t> vertices, std::uint64_t vertex_count,
    Repeats& repeats);

/// True where a vertex occurs twice.
[[nodiscard]] bool repeats_vertex(std::span<const std::int64_t> vertices);

/// Takes away what the walk around a polygon does for nothing: staying at a vertex, and going forth
/// and straight back. Linear.
void trim_walk(std::vector<std::int64_t>& polygon);

/// Appends a checked entity of shape.vertex_count vertices. Its class, if any, is the caller's.
void append(EntityList& list, Shape shape, std::span<const std::int64_t> vertices);

/// Takes out the vertices whose mark is not 0, with their classes and values; nothing may use them.
/// Linear.
void drop_vertices(MeshData& mesh, const std::vector<std::uint8_t>& marks);

/// The class of each vertex, where a file gives none: that of the lowest-dimensional classified
/// entity that uses the vertex, the smallest where there are several. Unclassified where there is
/// none. Linear.
[[nodiscard]] std::vector<ModelRef> lowest_classes(const MeshData& mesh);

}  // namespace aomd::io::detail
