#include "core/io/vtu_packing.h"

#include <string_view>

#include "core/base/text.h"

namespace aomd::io::detail {

VtuPacking packing_of(const pugi::xml_node& root,
                      const std::function<void(const std::string&)>& fail) {
  const std::string_view compressor = root.attribute("compressor").value();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    fail("compressed by " + shown(compressor) +
         "; only vtkZLibDataCompressor is read: save it with that, or uncompressed");
  VtuPacking packing;
  packing.compressed = !compressor.empty();
  packing.wide = std::string_view(root.attribute("header_type").value()) == "UInt64";
  if (std::string_view(root.attribute("byte_order").value()) == "BigEndian")
    packing.order = std::endian::big;
  packing.appended_base64 =
      std::string_view(root.child("AppendedData").attribute("encoding").value()) == "base64";
  return packing;
}

}  // namespace aomd::io::detail
