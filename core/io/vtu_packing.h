#pragma once
// How VTK XML files pack their arrays.

#include <bit>
#include <functional>
#include <string>

#include <pugixml.hpp>

namespace aomd::io::detail {

/// As the attributes of the root element say.
struct VtuPacking {
  std::endian order = std::endian::little;
  bool wide = false;             ///< 64-bit header words instead of 32-bit
  bool compressed = false;       ///< by zlib
  bool appended_base64 = false;  ///< appended data are text instead of bytes
};

/// Calls fail(what), which throws, for compressors that are not read.
[[nodiscard]] VtuPacking packing_of(const pugi::xml_node& root,
                                    const std::function<void(const std::string&)>& fail);

}  // namespace aomd::io::detail
