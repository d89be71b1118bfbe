#pragma once
// One reader and one writer for each format family; io.cpp chooses among them.

#include <span>
#include <string>
#include <vector>

#include "core/io/io.h"
#include "core/io/source.h"

namespace aomd::io::detail {

[[nodiscard]] ReadResult read_obj(const Source& source);
[[nodiscard]] ReadResult read_ply(const Source& file);
[[nodiscard]] ReadResult read_off(const Source& source);
/// `binary` as is_binary_stl() says, or as the caller knows better.
[[nodiscard]] ReadResult read_stl(const Source& source, bool binary);
/// Gmsh MSH 1, 2, 4.0 and 4.1, text and binary.
[[nodiscard]] ReadResult read_msh(const Source& source);
/// Medit, text (.mesh) and binary (.meshb).
[[nodiscard]] ReadResult read_medit(const Source& source);
/// Legacy VTK, text and binary.
[[nodiscard]] ReadResult read_vtk(const Source& source);
/// VTK's XML files of unstructured grids: text, base64 and raw, compressed by zlib or not.
[[nodiscard]] ReadResult read_vtu(const Source& source);
/// A list of such files, which are read as well.
[[nodiscard]] ReadResult read_pvtu(const Source& source);
/// SU2's native format.
[[nodiscard]] ReadResult read_su2(const Source& source);
/// Whether the library for glTF was there when this was built; without it both functions fail.
[[nodiscard]] bool has_gltf();
/// glTF 2.0: .gltf with what it names beside it, and .glb.
[[nodiscard]] ReadResult read_gltf(const Source& source);

/// True where the size is what the count in a binary header promises: many binary files start with
/// "solid".
[[nodiscard]] bool is_binary_stl(std::string_view bytes);
/// True where the first line, in any case and with any blanks, is that of a legacy VTK file.
[[nodiscard]] bool is_vtk(std::string_view bytes);
/// True where a binary Medit file (.meshb) starts: with the number 1 in 32 bits, of either byte
/// order.
[[nodiscard]] bool is_binary_medit(std::string_view bytes);
/// True where the first word is one of OFF's, such as "OFF" or "STCNOFF".
[[nodiscard]] bool is_off(std::string_view first_word);

// The writers return the bytes of the file. Indices, sizes and shapes in the mesh are trusted:
// write() has checked what a format cannot hold.
/// `libraries` are those of materials that it names.
[[nodiscard]] std::string write_obj(const MeshData& mesh,
                                    const std::vector<std::string>& libraries);
/// `remarks` are the lines about the whole.
[[nodiscard]] std::string write_ply(const MeshData& mesh, bool binary,
                                    const std::vector<Remark>& remarks);
[[nodiscard]] std::string write_off(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_stl(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_msh(const MeshData& mesh, bool binary, bool msh2);
[[nodiscard]] std::string write_medit(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_vtk(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_vtu(const MeshData& mesh, bool binary);
[[nodiscard]] std::string write_su2(const MeshData& mesh);
/// The list of the pieces; they are files beside it.
void write_pvtu(const std::filesystem::path& path, const MeshData& mesh, bool binary,
                std::size_t pieces, EncodedMesh& encoded);
/// A .glb where it is to be `binary`; else numbers and pictures are files beside it, or part of it.
void write_gltf(const std::filesystem::path& path, const MeshData& mesh, bool binary, bool beside,
                EncodedMesh& encoded);

/// True where every coordinate is exactly a 32-bit float.
[[nodiscard]] bool fits_float(const MeshData& mesh);

/// Calls visit(vertices of the entity, its class) for each entity of the list.
template <class Visit>
void for_each_entity(const EntityList& list, Visit&& visit) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto n = static_cast<std::size_t>(shape_template(list.shapes[i]).vertex_count);
    visit(std::span(list.vertices).subspan(start, n),
          list.classes.empty() ? ModelRef() : list.classes[i]);
    start += n;
  }
}

}  // namespace aomd::io::detail
