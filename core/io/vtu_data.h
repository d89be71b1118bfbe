#pragma once
// The encoded arrays of VTK XML files in memory: base64 or raw bytes, compressed by zlib or not.

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/io/source.h"
#include "core/io/vtu_packing.h"

namespace aomd::io::detail {

struct Unpacked {
  std::string bytes;
  std::size_t end = 0;  ///< where the encoded form ends
};

/// The bytes of the array whose encoded form starts at `offset` of the source and ends at `end` at
/// the latest. Throws ReadError with the byte where data lack, are no base64, do not unpack or are
/// more than `most` bytes; sizes that the file only promises are checked before memory is taken.
[[nodiscard]] Unpacked unpack(const Source& source, std::size_t offset, std::size_t end,
                              bool base64, const VtuPacking& packing, std::uint64_t most);

}  // namespace aomd::io::detail
