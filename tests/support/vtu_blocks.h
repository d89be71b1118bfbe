#pragma once
// Arrays of VTK XML files in blocks of zlib, as several programs write them.

#include <zlib.h>

#include "tests/support/io_helpers.h"

namespace aomd::test {

/// How a writer splits an array into blocks, and what it says of the last.
enum class Blocks { Vtk, Meshio };

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  EXPECT_EQ(::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                        reinterpret_cast<const Bytef*>(bytes.data()),
                        static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION),
            Z_OK);
  packed.resize(size);
  return packed;
}

/// What stands before the blocks, and the blocks.
struct Packed {
  std::string head, data;
};

template <class Word>
Packed packed_in_blocks(const std::string& bytes, std::size_t block, Blocks blocks,
                        bool big = false) {
  const std::size_t n = (bytes.size() + block - 1) / block, rest = bytes.size() - (n - 1) * block;
  const std::size_t last = n > 0 && (blocks == Blocks::Meshio || rest != block) ? rest : 0;
  Packed result{raw(Word(n), big) + raw(Word(block), big) + raw(Word(last), big), {}};
  for (std::size_t i = 0; i < n; ++i) {
    const std::string part = deflated(bytes.substr(i * block, block));
    result.head += raw(Word(part.size()), big);
    result.data += part;
  }
  return result;
}

}  // namespace aomd::test
