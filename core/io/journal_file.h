#pragma once
// Journals on disk: a history that another run, or another machine, can replay on the same mesh.
//
// Layout, little-endian, offsets in bytes:
//    0  "AOMDJRNL"                      40  u64 fingerprint of the start mesh
//    8  u32 version                     48  f64 feature angle, degrees     56  f64 corner angle
//   12  u32 flags (see JournalFlag)     64  u64 number of steps S
//   16  u32 vertices, edges, faces,     72  u64 number of words W
//       regions of the start mesh, 0    80  u64 checksum of everything but itself
//   36  u32 0                           88  S times: u32 kind | dimension << 8, u32 entity,
//                                           u64 first word
//                                           W times: u32, as in core/mesh/journal

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/io/error.h"
#include "core/io/output_files.h"
#include "core/mesh/journal.h"
#include "core/model/classify.h"

namespace aomd::io {

/// What tells one start mesh from another: entity counts and a hash of connectivity, positions and
/// classification.
struct MeshFingerprint {
  std::array<std::uint32_t, 4> counts{};
  std::uint64_t hash = 0;
  friend bool operator==(const MeshFingerprint&, const MeshFingerprint&) = default;
};

/// O(entities).
[[nodiscard]] MeshFingerprint fingerprint(const Mesh& mesh);

/// A history and what it starts from: a mesh as read, then classified with these options.
struct JournalFile {
  ClassifyOptions classify;
  MeshFingerprint start;
  Journal journal;
  bool seams = false;  ///< the seams of the mesh were model edges; which these are is not stored
};

/// Hands over the bytes of a journal file, piece by piece.
void put_bytes(const JournalFile& file, const OutputFiles::Take& take);

/// Writes a history with the guarantees of write_file(). Throws WriteError.
void write_journal(const std::filesystem::path& path, const JournalFile& file);

/// Reads a history, nothing of it applied yet. Throws ReadError for what is missing, truncated,
/// damaged (the checksum tells), of another version or no journal at all; LimitError.
[[nodiscard]] JournalFile read_journal(const std::filesystem::path& path);

/// Makes sure, before anything is applied, that every record of the history fits the mesh it would
/// meet: ids, id stack, vertex lists, model entities, coordinates. `name` is the journal's file.
/// O(mesh + records). Throws ReadError when the mesh is another one or a record cannot be applied.
void check_journal(const JournalFile& file, const std::string& name, const Mesh& mesh);

}  // namespace aomd::io
