#include "core/io/vtu_stream.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/io/base64.h"
#include "core/io/error.h"

namespace aomd::io::detail {

void VtuStream::fail(const std::string& what) const {
  throw ReadError(name_, Place{.byte = at()}, what);
}

std::uint64_t VtuStream::left() const {
  const std::uint64_t encoded = end_ - std::min(end_, at());
  return base64_ ? encoded / 4 * 3 + 3 + rest_.size() : encoded;
}

void VtuStream::take(std::size_t n, std::string& into) {
  into.clear();
  into.reserve(n);
  while (into.size() < n) into += some(n - into.size());
}

std::string_view VtuStream::some(std::uint64_t most) {
  constexpr std::uint64_t at_once = 1 << 16;
  if (base64_) return decoded(static_cast<std::size_t>(std::min(at_once, most)));
  need_encoded();
  const std::string_view bytes = encoded_.substr(used_, static_cast<std::size_t>(most));
  used_ += bytes.size();
  return bytes;
}

void VtuStream::need_encoded() {
  if (used_ < encoded_.size()) return;
  if (at() >= end_) fail("the data end early");
  at_ += used_;
  used_ = 0;
  encoded_ = {};
  encoded_ = more_of_file(end_ - at_);
}

/// The next n bytes of text.
std::string_view VtuStream::decoded(std::size_t n) {
  decoded_.resize(n + 2);  // the last group may have two more than are asked for
  char* const to = decoded_.data();
  std::size_t known = rest_.copy(to, rest_.size());
  while (known < n) {
    const std::size_t groups =
        decode_groups(encoded_.substr(used_), (n - known + 2) / 3, to + known);
    used_ += 4 * groups;
    known += 3 * groups;
    if (known < n) known += decode_group(to + known);
  }
  rest_.assign(to + n, known - n);
  return {to, n};
}

/// Four digits, with whatever blanks there are between them. A padded group may stand anywhere:
/// headers are encoded apart from what they describe.
std::size_t VtuStream::decode_group(char* to) {
  std::uint32_t bits = 0;
  std::size_t digits = 0, padding = 0;
  for (; digits < 4; ++used_) {
    need_encoded();
    const char c = encoded_[used_];
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int value = base64_value(c);
    if (c == '=' ? digits < 2 : value < 0 || padding > 0)
      fail("not base64: " + shown(std::string_view(&c, 1)));
    padding += c == '=';
    bits = bits << 6 | (c == '=' ? 0u : static_cast<std::uint32_t>(value));
    ++digits;
  }
  for (std::size_t byte = 0; byte < 3 - padding; ++byte)
    to[byte] = static_cast<char>(bits >> (16 - 8 * byte) & 255u);
  return 3 - padding;
}

}  // namespace aomd::io::detail
