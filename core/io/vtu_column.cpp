#include "core/io/vtu_column.h"

#include <algorithm>
#include <fstream>

#include "core/io/error.h"

namespace aomd::io::detail {
namespace {

class StreamOfFile final : public VtuStream {
 public:
  StreamOfFile(const std::filesystem::path& path, const VtuPlace& place)
      : VtuStream(path.string(), place), file_(path, std::ios::binary) {
    if (!file_) throw ReadError(path.string(), {}, "cannot be opened");
    file_.seekg(static_cast<std::streamoff>(place.begin));
  }

 private:
  std::string_view more_of_file(std::uint64_t most) override {
    constexpr std::uint64_t at_once = 1 << 16;
    buffer_.resize(static_cast<std::size_t>(std::min(at_once, most)));
    if (!file_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size())))
      fail("has become shorter while it was read");
    return buffer_;
  }

  std::ifstream file_;
  std::string buffer_;
};

}  // namespace

VtuColumn::VtuColumn(const std::filesystem::path& path, const VtuPlace& place,
                     const VtuPacking& packing)
    : stream_(std::make_unique<StreamOfFile>(path, place)),
      bytes_(std::make_unique<VtuBytes>(*stream_, packing)) {}

}  // namespace aomd::io::detail
