#pragma once
// The bytes of an array of a VTK XML file, compressed by zlib or not.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/io/vtu_packing.h"
#include "core/io/vtu_stream.h"

struct z_stream_s;

namespace aomd::io::detail {

/// In sequence, unpacked as far as they are asked for.
class VtuBytes {
 public:
  /// Reads how many there are, and the sizes of all blocks. Throws ReadError where no more than
  /// what is left of the stream can unpack to as many. The stream must outlive this.
  VtuBytes(VtuStream& stream, const VtuPacking& packing);
  VtuBytes(const VtuBytes&) = delete;
  VtuBytes& operator=(const VtuBytes&) = delete;
  ~VtuBytes();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// The next n in place of what `into` holds. Throws ReadError where data lack or are damaged: a
  /// block that ends is looked at to its end, so that with the last byte all has been looked at.
  void take(std::size_t n, std::string& into);

 private:
  /// What stands before compressed blocks.
  struct Head {
    std::uint64_t size = 0, last = 0;   ///< unpacked: of each block but the last, and of that
    std::vector<std::uint64_t> packed;  ///< of each block
  };

  [[nodiscard]] std::vector<std::uint64_t> words(std::uint64_t n, const VtuPacking& packing) const;
  [[nodiscard]] Head head(const VtuPacking& packing) const;
  void check_packed() const;
  [[nodiscard]] std::uint64_t unpacked_size() const;
  void inflate(char* to, std::size_t n);
  void open_block();
  void close_block();
  std::size_t fill(char* to, std::size_t n);
  void feed();
  [[noreturn]] void fail_damaged() const;

  VtuStream& stream_;
  Head head_;
  std::uint64_t size_ = 0;
  std::unique_ptr<z_stream_s> zlib_;  ///< only where they are compressed
  std::size_t blocks_ = 0;            ///< that have been opened
  std::uint64_t left_ = 0;            ///< bytes that the last of them should still come to
  std::uint64_t packed_left_ = 0;     ///< that have not been handed to zlib
  bool ended_ = false;                ///< as zlib says
};

}  // namespace aomd::io::detail
