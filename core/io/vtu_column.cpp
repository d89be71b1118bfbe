#include "core/io/vtu_column.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/io/base64.h"
#include "core/io/error.h"

namespace aomd::io::detail {

VtuColumn::VtuColumn(const std::filesystem::path& path, const VtuColumnPlace& place,
                     const VtuPacking& packing)
    : name_(path.string()), place_(place), file_(path, std::ios::binary) {
  if (!file_) throw ReadError(name_, {}, "cannot be opened");
  file_.seekg(static_cast<std::streamoff>(place.begin));
  const std::string head = take(packing.wide ? 8 : 4);
  for (std::size_t i = 0; i < head.size(); ++i) {
    const std::size_t k = packing.order == std::endian::big ? i : head.size() - 1 - i;
    size_ = size_ << 8 | static_cast<unsigned char>(head[k]);
  }
  if (size_ > left()) fail("the data end early: " + counted(size_, "byte") + " should follow");
}

void VtuColumn::fail(const std::string& what) const {
  throw ReadError(name_, Place{.byte = place_.begin + used_}, what);
}

// No more bytes than this.
std::uint64_t VtuColumn::left() const {
  const std::uint64_t encoded = place_.end - std::min(place_.end, place_.begin + used_);
  return place_.base64 ? encoded / 4 * 3 + 3 + rest_.size() : encoded;
}

/// The next bytes of the file. False at the end.
bool VtuColumn::fill() {
  constexpr std::uint64_t at_once = 1 << 16;
  place_.begin += buffer_.size();
  buffer_.resize(std::min(at_once, place_.end - std::min(place_.end, place_.begin)));
  used_ = 0;
  if (!file_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size())))
    fail("has become shorter while it was read");
  return !buffer_.empty();
}

std::string VtuColumn::take(std::size_t n) {
  if (!place_.base64) return take_raw(n);
  std::string bytes = std::move(rest_);
  while (bytes.size() < n) decode_group(bytes);
  rest_ = bytes.substr(n);
  bytes.resize(n);
  return bytes;
}

std::string VtuColumn::take_raw(std::size_t n) {
  std::string bytes;
  while (bytes.size() < n) {
    if (used_ == buffer_.size() && !fill()) fail("the data end early");
    const std::size_t some = std::min(n - bytes.size(), buffer_.size() - used_);
    bytes.append(buffer_, used_, some);
    used_ += some;
  }
  return bytes;
}

/// Four digits. A padded group may stand anywhere: headers are encoded apart from what they
/// describe.
void VtuColumn::decode_group(std::string& out) {
  std::uint32_t bits = 0;
  int digits = 0, padding = 0;
  while (digits < 4) {
    if (used_ == buffer_.size() && !fill()) fail("the data end early");
    const char c = buffer_[used_++];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int value = base64_value(c);
    if (c == '=' ? digits < 2 : value < 0 || padding > 0)
      fail("not base64: " + shown(std::string_view(&c, 1)));
    padding += c == '=';
    bits = bits << 6 | (c == '=' ? 0u : static_cast<std::uint32_t>(value));
    ++digits;
  }
  for (int byte = 0; byte < 3 - padding; ++byte)
    out += static_cast<char>(bits >> (16 - 8 * byte) & 255u);
}

}  // namespace aomd::io::detail
