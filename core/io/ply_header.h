#pragma once
// The header of a PLY file.

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/source.h"

namespace aomd::io::detail {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
enum class PlyEncoding : std::uint8_t { Ascii, LittleEndian, BigEndian };

/// Bytes that one value takes in binary files.
[[nodiscard]] constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool list = false;
  PlyType count_type = PlyType::UInt8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  ///< as promised: check it against the file's size before trusting it
  std::vector<PlyProperty> properties;
  std::size_t line_offset = 0;  ///< where the header declares it

  /// The bytes that one element takes at the least.
  [[nodiscard]] std::size_t least_size(PlyEncoding encoding) const;
  [[nodiscard]] bool has_list() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  ///< offset of the first byte after the header

  [[nodiscard]] const PlyElement* find(std::string_view name) const;
};

/// Throws ReadError with the line of what is wrong.
[[nodiscard]] PlyHeader read_ply_header(const Source& source);

}  // namespace aomd::io::detail
