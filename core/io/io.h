#pragma once
// Reading and writing meshes: the format is chosen by content, then by extension.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/error.h"
#include "core/mesh/mesh_data.h"

#pragma GCC visibility push(default)

namespace aomd::io {

enum class Format { Obj, Ply, Off, Stl, Gltf, Msh, Medit, Vtk, Vtu, Su2, Pvtu };

/// What a reader returns: the mesh and what it had to do to get it.
struct ReadResult {
  MeshData mesh;
  Format format = Format::Obj;
  /// One line each, printable, at most 20: "12 polygons triangulated", "left out: normals".
  std::vector<std::string> notes;
  bool whole = true;  ///< Medit: the mesh has all vertices and elements of the file as they are
  /// The regions that the file lists inside out, ascending: their vertices were renumbered.
  std::vector<std::uint32_t> turned{};
};

struct WriteOptions {
  /// Where the format has both (PLY, STL, OFF, MSH, VTK, VTU, PVTU; Medit is binary in .meshb, text
  /// in .mesh, and glTF in .glb and .gltf, whatever is said here). Not given: PLY is binary; STL is
  /// binary unless faces are classified, since only text holds solids; PVTU is binary; the others
  /// are text. Binary VTU is appended raw bytes. Binary STL and OFF, and glTF, hold 32-bit floats,
  /// so that coordinates are rounded; everything else reads back as the same doubles.
  std::optional<bool> binary{};
  /// MSH only: 2.2 instead of 4.1.
  bool msh2 = false;
  /// Medit, glTF and OBJ: what the format has in files of their own goes beside the mesh. Else a
  /// glTF file holds its numbers itself, and the others leave such things out.
  bool beside = true;
  /// PVTU only: how many .vtu files the mesh is cut into, beside the one that names them.
  std::size_t pieces = 1;
};

/// A mesh as a file holds it, and what the format could not hold, as notes like those of a reader.
struct EncodedMesh {
  /// A file that belongs to it: arrays of Medit, numbers of glTF, pieces of PVTU, materials and
  /// pictures.
  struct Beside {
    std::string name;  ///< in the folder of the mesh
    std::string bytes;
  };

  std::string bytes;
  std::vector<Beside> beside;
  std::vector<std::string> notes;
};

/// Reads a mesh. Faces of more than 4 vertices become triangles, and quads too in OBJ, PLY, OFF and
/// STL; regions keep their shapes, and those that the file lists inside out are renumbered
/// (core/mesh/orient_regions.h). Vertices that nothing uses are kept, nodes that only higher-order
/// elements use are not. What follows the last face that is promised is passed over, and so are
/// elements of PLY and lines of OBJ that we do not know; a note names them. Of several arrays of
/// one name and dimension the later ones are renamed ("u (2)"). Faces lose repeated corners, and
/// are dropped, as edges are, where fewer than 3 different ones (2 for edges) are left: a note
/// counts them. A byte order mark means nothing. Cost: linear in the file; memory bounded by the
/// file's size, whatever its header promises. Throws ReadError (missing, folder, empty, truncated,
/// index out of range, NaN, repeated vertex in a region, unknown format) with line or byte, or
/// LimitError.
[[nodiscard]] ReadResult read(const std::filesystem::path& path);

/// Reads a mesh from bytes in memory, as read() does. `name` stands in messages; its extension
/// counts as a file's does.
[[nodiscard]] ReadResult read_bytes(const std::string& name, std::string_view bytes);

/// Writes a mesh; the extension chooses the format. The file appears whole or not at all: it is
/// written beside its target, flushed, and renamed; an existing target stays untouched when
/// anything fails.
///
/// What reads back equal ("-": left out):
///
///          shapes           classes                          attributes           model table
///   OBJ    edges, faces     of faces (groups)                some (7)             -
///   PLY    edges, faces     all                              all (4, 7)           -
///   OFF    faces            -                                some (7)             -
///   STL    triangles        of faces (solids, in text)       some (7)             -
///   glTF   edges, triangles of faces (names of primitives)   some (7)             -
///   MSH    all              all                              all                  all, links (6)
///   Medit  all (1)          of the own dimension (2)         "medit:" ones (3)    -
///   VTK    all              all                              all (4)              -
///   VTU,   all              all                              all (4)              -
///   PVTU
///   SU2    regions, faces;  of faces on model faces (5)      -                    groups of
///          in the plane faces, edges on model edges                              markers
///
/// 1. Faces, and regions, are listed shape by shape.
/// 2. A tag is read as one of the element's own dimension, no class as tag 0; tags that are all 0,
///    without corners and ridges, as no class. Model vertices are numbered anew; other vertices get
///    the class of the lowest element that uses them.
/// 3. medit:reference, medit:required, medit:ridge, medit:normal and medit:tangent. Beside the
/// mesh,
///    in .sol or .solb, finite real numbers of 1, 3, 6 or 9 components, without their names; read()
///    takes them from there, and refuses such a file that has other numbers of vertices or
///    elements.
/// 4. Those of vertices first, then those of edges, faces and regions.
/// 5. Unclassified faces are left out. A marker is a physical group, or a model entity in none;
///    read back they are model entities 1, 2, ...
/// 6. Periodic links. No other format has them.
/// 7. docs/ATTRIBUTES.md. PLY, OBJ, glTF and MSH hold values on corners too. Types come back as
///    well, but from MSH and from text OBJ and OFF, which are doubles.
///
/// What is left out is named in a note. Where coordinates are rounded to 32-bit floats a note gives
/// the largest move if it exceeds a millionth of the box's diagonal, and the number of faces that
/// collapse. Throws WriteError, also where more than 1 % of the faces would collapse, for regions
/// where the format has none, surfaces in space in SU2, and shapes that the program added.
/// Returns the notes.
std::vector<std::string> write(const std::filesystem::path& path, const MeshData& mesh,
                               const WriteOptions& options = {});

/// What write() puts into a file, in a format of the caller's choice. `name` stands in messages.
[[nodiscard]] EncodedMesh to_bytes(const std::filesystem::path& name, Format format,
                                   const MeshData& mesh, const WriteOptions& options = {});

/// The file of arrays that stands beside a Medit mesh: a.sol beside a.mesh, a.solb beside a.meshb;
/// empty for other names.
[[nodiscard]] std::filesystem::path solution_beside(const std::filesystem::path& mesh);

/// The file of one piece, counted from 0, of a .pvtu: a_0.vtu, a_1.vtu beside a.pvtu.
[[nodiscard]] std::filesystem::path piece_beside(const std::filesystem::path& list,
                                                 std::size_t piece);

/// The format that an extension names. Throws WriteError for an extension that no format has.
[[nodiscard]] Format format_for_writing(const std::filesystem::path& path);

/// The format of an extension without its dot, in any case: "ply"; none where no format has it.
[[nodiscard]] std::optional<Format> format_named(std::string_view extension);

/// Writes bytes atomically, with the guarantees of write(): for reports, journals and pictures too.
/// Symbolic links are followed, and an existing file keeps its permissions. Pipes and devices are
/// written to directly.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace aomd::io

#pragma GCC visibility pop
