#include "core/io/vtu_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "core/base/text.h"

namespace aomd::io::detail {
namespace {

/// No more than zlib can count.
constexpr std::uint64_t most_at_once = 1 << 30;

}  // namespace

VtuBytes::VtuBytes(VtuStream& stream, const VtuPacking& packing) : stream_(stream) {
  if (!packing.compressed) {
    size_ = words(1, packing)[0];
    if (size_ > stream_.left())
      stream_.fail("the data end early: " + counted(size_, "byte") + " should follow");
    return;
  }
  head_ = head(packing);
  if (head_.packed.empty()) return;
  size_ = unpacked_size();
  check_packed();
  zlib_ = std::make_unique<z_stream>();
  if (::inflateInit(zlib_.get()) != Z_OK) throw std::bad_alloc();
}

VtuBytes::~VtuBytes() {
  if (zlib_) ::inflateEnd(zlib_.get());
}

void VtuBytes::take(std::size_t n, std::string& into) {
  if (!zlib_) return stream_.take(n, into);
  into.resize(n);
  inflate(into.data(), n);
}

std::vector<std::uint64_t> VtuBytes::words(std::uint64_t n, const VtuPacking& packing) const {
  const std::size_t size = packing.wide ? 8 : 4;
  if (n > stream_.left() / size)
    stream_.fail("the data end early: a header of " + counted(n, "word") + " should follow");
  std::string bytes;
  stream_.take(static_cast<std::size_t>(n) * size, bytes);
  std::vector<std::uint64_t> result(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t k =
        packing.order == std::endian::big ? i : i / size * size + size - 1 - i % size;
    result[i / size] = result[i / size] << 8 | static_cast<unsigned char>(bytes[k]);
  }
  return result;
}

/// A number of blocks, the size of each, that of the last where it is smaller (else 0; meshio
/// repeats the size of the others), the compressed size of each.
VtuBytes::Head VtuBytes::head(const VtuPacking& packing) const {
  const std::vector<std::uint64_t> first = words(3, packing);
  if (first[0] == 0) return {};
  return {first[1], first[2] != 0 ? first[2] : first[1], words(first[0], packing)};
}

void VtuBytes::check_packed() const {
  std::uint64_t left = stream_.left();
  for (std::size_t i = 0; i < head_.packed.size(); ++i) {
    if (head_.packed[i] > left)
      stream_.fail("the data end early: block " + std::to_string(i) + " of " +
                   counted(head_.packed[i], "byte") + " should follow");
    left -= head_.packed[i];
  }
}

/// The sum of the unpacked sizes. zlib never packs tighter than 1 : 1032.
std::uint64_t VtuBytes::unpacked_size() const {
  const std::uint64_t full = head_.packed.size() - 1,
                      possible = 1040 * std::min<std::uint64_t>(stream_.left(), UINT64_MAX / 1040);
  if (head_.last > possible || (full > 0 && head_.size > (possible - head_.last) / full))
    stream_.fail("the data end early: " + counted(head_.packed.size(), "block") + " of " +
                 counted(head_.size, "byte") + " should follow");
  return full * head_.size + head_.last;
}

void VtuBytes::inflate(char* to, std::size_t n) {
  for (;;) {
    while (left_ == 0 && blocks_ < head_.packed.size()) open_block();
    if (n == 0) return;
    if (left_ == 0) stream_.fail("the data end early");
    const auto some = static_cast<std::size_t>(std::min({std::uint64_t{n}, left_, most_at_once}));
    if (fill(to, some) < some) fail_damaged();
    to += some;
    n -= some;
    left_ -= some;
    if (left_ == 0) close_block();
  }
}

/// Blocks may be empty.
void VtuBytes::open_block() {
  ::inflateReset(zlib_.get());
  zlib_->avail_in = 0;
  ended_ = false;
  packed_left_ = head_.packed[blocks_++];
  left_ = blocks_ == head_.packed.size() ? head_.last : head_.size;
  if (left_ == 0) close_block();
}

/// It must come to no more than it should, and there must be nothing behind it.
void VtuBytes::close_block() {
  char more = 0;
  if (fill(&more, 1) > 0 || zlib_->avail_in > 0 || packed_left_ > 0) fail_damaged();
}

/// Up to n bytes of the present block. Returns how many: fewer where it ends.
std::size_t VtuBytes::fill(char* to, std::size_t n) {
  zlib_->next_out = reinterpret_cast<Bytef*>(to);
  zlib_->avail_out = static_cast<uInt>(n);
  while (zlib_->avail_out > 0 && !ended_) {
    if (zlib_->avail_in == 0) feed();
    const int status = ::inflate(zlib_.get(), Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END) fail_damaged();
    ended_ = status == Z_STREAM_END;
  }
  return n - zlib_->avail_out;
}

void VtuBytes::feed() {
  if (packed_left_ == 0) fail_damaged();
  const std::string_view packed = stream_.some(std::min(packed_left_, most_at_once));
  packed_left_ -= packed.size();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): zlib only reads from there
  zlib_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  zlib_->avail_in = static_cast<uInt>(packed.size());
}

void VtuBytes::fail_damaged() const {
  stream_.fail("block " + std::to_string(blocks_ - 1) + " of compressed data is damaged");
}

}  // namespace aomd::io::detail
