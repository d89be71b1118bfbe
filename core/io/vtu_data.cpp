#include "core/io/vtu_data.h"

#include "core/base/text.h"
#include "core/io/vtu_bytes.h"

namespace aomd::io::detail {
namespace {

class StreamOfMemory final : public VtuStream {
 public:
  StreamOfMemory(const Source& source, std::size_t offset, std::size_t end, bool base64)
      : VtuStream(source.name, {source.skipped + offset, source.skipped + end, base64}),
        bytes_(source.bytes.substr(offset)) {}

 private:
  std::string_view more_of_file(std::uint64_t most) override {
    return bytes_.substr(0, static_cast<std::size_t>(most));  // all at once
  }

  std::string_view bytes_;
};

}  // namespace

Unpacked unpack(const Source& source, std::size_t offset, std::size_t end, bool base64,
                const VtuPacking& packing, std::uint64_t most) {
  StreamOfMemory stream(source, offset, end, base64);
  VtuBytes packed(stream, packing);
  if (packing.compressed && packed.size() > most)
    stream.fail("unpacks to " + counted(packed.size(), "byte") + ", and at most " +
                std::to_string(most) + " belong here");
  Unpacked result;
  packed.take(static_cast<std::size_t>(packed.size()), result.bytes);
  result.end = static_cast<std::size_t>(stream.at()) - source.skipped;
  return result;
}

}  // namespace aomd::io::detail
