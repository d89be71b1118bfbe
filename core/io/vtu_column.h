#pragma once
// An array of a VTK XML file that need not fit into memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/io/vtu_bytes.h"

namespace aomd::io::detail {

/// Its bytes from the first one on. 200 KiB are in memory at the most, and 8 bytes for each block
/// of a compressed one.
class VtuColumn {
 public:
  /// Reads how many bytes there are. Throws ReadError where the file has not as many.
  VtuColumn(const std::filesystem::path& path, const VtuPlace& place, const VtuPacking& packing);

  [[nodiscard]] std::uint64_t size() const { return bytes_->size(); }
  /// The next n bytes in place of what `into` holds.
  void take(std::size_t n, std::string& into) { bytes_->take(n, into); }

 private:
  std::unique_ptr<VtuStream> stream_;
  std::unique_ptr<VtuBytes> bytes_;
};

}  // namespace aomd::io::detail
