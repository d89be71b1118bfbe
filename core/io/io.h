#pragma once
// Reading and writing meshes: the format is chosen by content, then by extension.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/error.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io {

enum class Format { Obj, Ply, Off, Stl };

/// What a reader returns: the mesh and what it had to do to get it.
struct ReadResult {
  MeshData mesh;
  Format format = Format::Obj;
  std::vector<std::string> notes;  ///< one line each: "12 polygons triangulated", "104 vertices welded"
};

struct WriteOptions {
  /// Where the format has both (PLY, STL, OFF). Not given: PLY is binary; STL is binary unless faces are
  /// classified, since only text holds solids; OFF is text. Binary STL and OFF hold 32-bit floats, so that
  /// coordinates are rounded; everything else reads back as the same doubles.
  std::optional<bool> binary{};
};

/// Reads a surface mesh. Polygons become triangles; vertices that no face uses are kept; attributes that we
/// do not know are passed over. Cost: linear in the file; memory bounded by the file's size, whatever its
/// header promises.
/// Throws ReadError (missing, folder, empty, truncated, index out of range, NaN, repeated vertex in a face,
/// unknown format) with line or byte, or LimitError.
[[nodiscard]] ReadResult read(const std::filesystem::path& path);

/// The same for bytes in memory. `name` stands in messages; its extension counts as a file's does.
[[nodiscard]] ReadResult read_bytes(const std::string& name, std::string_view bytes);

/// Writes a mesh; the extension chooses the format. The file appears whole or not at all: it is written
/// beside its target, flushed, and renamed; an existing target stays untouched when anything fails.
/// Classification: PLY keeps all of it; OBJ (groups) and text STL (solids) that of the faces; OFF none.
/// Throws WriteError, also for a mesh with regions.
void write(const std::filesystem::path& path, const MeshData& mesh, const WriteOptions& options = {});

/// The format that an extension names. Throws WriteError for an extension that no format has.
[[nodiscard]] Format format_for_writing(const std::filesystem::path& path);

/// Writes bytes atomically, with the guarantees of write(): for reports, journals and pictures too. Symbolic
/// links are followed, and an existing file keeps its permissions. Pipes and devices are written to directly.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace aomd::io
