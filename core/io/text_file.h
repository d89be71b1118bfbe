#pragma once
// Text beside the meshes: lists of vertices, spacings.

#include <filesystem>

#include "core/io/source.h"

namespace aomd::io::detail {

/// Without the byte order mark that some editors put before text.
[[nodiscard]] Source without_mark(const Source& text);

/// A text file in memory, without byte order mark and padding.
class TextFile {
 public:
  /// Throws as FileBytes does.
  explicit TextFile(const std::filesystem::path& path);

  [[nodiscard]] const Source& source() const { return source_; }

 private:
  FileBytes bytes_;
  Source source_;
};

}  // namespace aomd::io::detail
