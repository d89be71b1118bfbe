#pragma once
// One reader and one writer for each format family; io.cpp chooses among them.

#include <span>
#include <string>

#include "core/io/io.h"
#include "core/io/source.h"

namespace aomd::io::detail {

[[nodiscard]] ReadResult read_obj(const Source& source);
[[nodiscard]] ReadResult read_ply(const Source& source);
[[nodiscard]] ReadResult read_off(const Source& source);
/// `binary` as is_binary_stl() says, or as the caller knows better.
[[nodiscard]] ReadResult read_stl(const Source& source, bool binary);

/// True where the size is what the count in a binary header promises: many binary files start with "solid".
[[nodiscard]] bool is_binary_stl(std::string_view bytes);
/// True where the first word is one of OFF's, such as "OFF" or "STCNOFF".
[[nodiscard]] bool is_off(std::string_view first_word);

// The writers return the bytes of the file. Indices in the mesh are trusted.
[[nodiscard]] std::string write_obj(const MeshData& mesh);
[[nodiscard]] std::string write_ply(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_off(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_stl(const MeshData& mesh, bool binary);

/// True where every coordinate is exactly a 32-bit float.
[[nodiscard]] bool fits_float(const MeshData& mesh);

/// Calls visit(vertices of the entity, its class) for each entity of the list.
template <class Visit>
void for_each_entity(const EntityList& list, Visit&& visit) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto n = static_cast<std::size_t>(shape_template(list.shapes[i]).vertex_count);
    visit(std::span(list.vertices).subspan(start, n), list.classes.empty() ? ModelRef() : list.classes[i]);
    start += n;
  }
}

}  // namespace aomd::io::detail
