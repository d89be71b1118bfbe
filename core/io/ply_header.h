#pragma once
// The header of a PLY file.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/source.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// What our writer puts into the header.
inline constexpr std::string_view own_comment = "AOMD Studio";

enum class PlyEncoding : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::Float32;
  bool list = false;
  NumberType count_type = NumberType::UInt8;  ///< of a list
};

/// A list of the corners of faces.
[[nodiscard]] bool is_corner_list(const PlyProperty& property);
/// Of a vertex: 0, 1 and 2 for x, y and z; -1 for what is no coordinate.
[[nodiscard]] int axis_of(const PlyProperty& property);

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
  std::vector<Remark> remarks;  ///< "comment" and "obj_info" lines, but for our own
  std::size_t body = 0;         ///< offset of the first byte after the header

  [[nodiscard]] const PlyElement* find(std::string_view name) const;
};

/// Throws ReadError with the line of what is wrong.
[[nodiscard]] PlyHeader read_ply_header(const Source& source);

}  // namespace aomd::io::detail
