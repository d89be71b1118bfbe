#include "core/io/vtu_data.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/text.h"
#include "core/io/base64.h"

namespace aomd::io::detail {
namespace {

/// Bytes in sequence, decoded as far as they are asked for.
class Stream {
 public:
  Stream(const Source& source, std::size_t offset, std::size_t end, bool base64)
      : source_(source), at_(offset), end_(end), base64_(base64) {}

  [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(at_, what); }

  [[nodiscard]] std::size_t at() const { return at_; }
  /// No more bytes than this are left.
  [[nodiscard]] std::uint64_t left() const {
    return base64_ ? (end_ - at_) / 4 * 3 + 3 + rest_.size() : end_ - at_;
  }

  std::string take(std::uint64_t n) {
    if (n > left()) fail("the data end early: " + counted(n, "byte") + " should follow");
    std::string bytes;
    if (base64_) {
      bytes = std::move(rest_);
      while (bytes.size() < n) decode_group(bytes);
      rest_ = bytes.substr(static_cast<std::size_t>(n));
      bytes.resize(static_cast<std::size_t>(n));
    } else {
      bytes = source_.bytes.substr(at_, static_cast<std::size_t>(n));
      at_ += static_cast<std::size_t>(n);
    }
    return bytes;
  }

 private:
  /// Four digits. A padded group may stand anywhere: headers are encoded apart from what they
  /// describe.
  void decode_group(std::string& out) {
    std::uint32_t bits = 0;
    int digits = 0, padding = 0;
    for (; digits < 4; ++at_) {
      if (at_ == end_) fail("the data end early");
      const char c = source_.bytes[at_];
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
      const int value = base64_value(c);
      if (c == '=' ? digits < 2 : value < 0 || padding > 0)
        fail("not base64: " + shown(source_.bytes.substr(at_, 1)));
      padding += c == '=';
      bits = bits << 6 | (c == '=' ? 0u : static_cast<std::uint32_t>(value));
      ++digits;
    }
    for (int byte = 0; byte < 3 - padding; ++byte)
      out += static_cast<char>(bits >> (16 - 8 * byte) & 255u);
  }

  const Source& source_;
  std::size_t at_, end_;
  bool base64_;
  std::string rest_;  ///< decoded, not yet asked for
};

std::vector<std::uint64_t> words(Stream& stream, std::uint64_t n, const VtuPacking& packing) {
  const std::size_t size = packing.wide ? 8 : 4;
  if (n > stream.left() / size)
    stream.fail("the data end early: a header of " + counted(n, "word") + " should follow");
  const std::string bytes = stream.take(n * size);
  std::vector<std::uint64_t> result(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t k =
        packing.order == std::endian::big ? i : i / size * size + size - 1 - i % size;
    result[i / size] = result[i / size] << 8 | static_cast<unsigned char>(bytes[k]);
  }
  return result;
}

/// What stands before compressed blocks.
struct BlockHead {
  std::uint64_t size = 0, last = 0;   ///< unpacked: of each block but the last, and of that
  std::vector<std::uint64_t> packed;  ///< of each block
};

/// A number of blocks, the size of each, that of the last where it is smaller (else 0; meshio
/// repeats the size of the others), the compressed size of each.
BlockHead block_head(Stream& stream, const VtuPacking& packing) {
  const std::vector<std::uint64_t> head = words(stream, 3, packing);
  if (head[0] == 0) return {};
  return {head[1], head[2] != 0 ? head[2] : head[1], words(stream, head[0], packing)};
}

/// The sum of the unpacked sizes. zlib never packs tighter than 1 : 1032.
std::uint64_t unpacked_size(const BlockHead& head, const Stream& stream, std::uint64_t most) {
  const std::uint64_t full = head.packed.size() - 1,
                      possible = 1040 * std::min<std::uint64_t>(stream.left(), UINT64_MAX / 1040);
  if (head.last > possible || (full > 0 && head.size > (possible - head.last) / full))
    stream.fail("the data end early: " + counted(head.packed.size(), "block") + " of " +
                counted(head.size, "byte") + " should follow");
  const std::uint64_t sum = full * head.size + head.last;
  if (sum > most)
    stream.fail("unpacks to " + counted(sum, "byte") + ", and at most " + std::to_string(most) +
                " belong here");
  return sum;
}

std::string inflate_blocks(Stream& stream, const VtuPacking& packing, std::uint64_t most) {
  const BlockHead head = block_head(stream, packing);
  std::string out;
  if (head.packed.empty()) return out;
  out.resize(static_cast<std::size_t>(unpacked_size(head, stream, most)));
  std::size_t start = 0;
  for (std::size_t i = 0; i < head.packed.size(); ++i) {
    uLongf size = static_cast<uLongf>(i + 1 == head.packed.size() ? head.last : head.size);
    const std::string bytes = stream.take(head.packed[i]);
    const uLongf expected = size;
    if (::uncompress(reinterpret_cast<Bytef*>(out.data() + start), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()),
                     static_cast<uLong>(bytes.size())) != Z_OK ||
        size != expected)
      stream.fail("block " + std::to_string(i) + " of compressed data is damaged");
    start += expected;
  }
  return out;
}

}  // namespace

Unpacked unpack(const Source& source, std::size_t offset, std::size_t end, bool base64,
                const VtuPacking& packing, std::uint64_t most) {
  Stream stream(source, offset, end, base64);
  std::string bytes = packing.compressed ? inflate_blocks(stream, packing, most)
                                         : stream.take(words(stream, 1, packing)[0]);
  return {std::move(bytes), stream.at()};
}

}  // namespace aomd::io::detail
