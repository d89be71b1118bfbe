#pragma once
// An array of a VTK XML file that need not fit into memory.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/io/vtu_data.h"

namespace aomd::io::detail {

/// Where its encoded form lies in the file, at the most.
struct VtuColumnPlace {
  std::uint64_t begin = 0, end = 0;
  bool base64 = false;
};

/// Its bytes from the first one on, which must not be compressed.
class VtuColumn {
 public:
  /// Reads how many bytes there are. Throws ReadError where the file has not as many.
  VtuColumn(const std::filesystem::path& path, const VtuColumnPlace& place,
            const VtuPacking& packing);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// The next n bytes.
  [[nodiscard]] std::string take(std::size_t n);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] std::uint64_t left() const;
  bool fill();
  [[nodiscard]] std::string take_raw(std::size_t n);
  void decode_group(std::string& out);

  std::string name_;
  VtuColumnPlace place_;  ///< `begin` of what is in `buffer_` and behind
  std::ifstream file_;
  std::string buffer_;
  std::size_t used_ = 0;  ///< of the buffer
  std::string rest_;      ///< decoded, not yet asked for
  std::uint64_t size_ = 0;
};

}  // namespace aomd::io::detail
