#pragma once
// Outputs that appear together or not at all, and that nothing is left of where a program ends
// early.

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "core/io/io.h"

namespace aomd::io {

/// The files that one piece of work writes. Each is written beside its target as
/// `.aomd-PROCESS-NUMBER.tmp`, flushed, and renamed over it at the end. Symbolic links are
/// followed, and an existing file keeps its permissions. Pipes, devices and the descriptors of this
/// process
/// (/dev/stdout) take their bytes at the end, before anything is renamed.
class OutputFiles {
 public:
  OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;
  /// Removes what has not appeared.
  ~OutputFiles();

  /// Writes an output beside its target, and removes what killed programs have left there. Throws
  /// WriteError.
  void add(const std::filesystem::path& path, std::string_view bytes);
  /// The same for bytes that are made piece by piece: what is long need not be there at one time.
  using Take = std::function<void(std::string_view)>;
  void add(const std::filesystem::path& path, const std::function<void(const Take&)>& write);
  /// Throws WriteError where an output could not be written: for complaints before the work instead
  /// of after it.
  static void probe(const std::filesystem::path& path);
  /// Puts all in place. Throws WriteError; then all targets are what they were before.
  void commit();

 private:
  class Temporary;
  struct Stream;

  std::vector<std::unique_ptr<Temporary>> files_;
  std::vector<Stream> streams_;
};

/// Adds a mesh, and the file of arrays beside it, to what is to be written. Where such a file is
/// there that does not belong to the mesh, the notes say so.
void add_mesh(OutputFiles& files, const std::filesystem::path& path, EncodedMesh& encoded);

/// For a program that a signal ends: waits for a commit that has begun, removes all temporaries of
/// this process and lets nobody write from then on, since others may still be at work. Returns
/// whether any output has appeared.
[[nodiscard]] bool abandon_outputs();

}  // namespace aomd::io
