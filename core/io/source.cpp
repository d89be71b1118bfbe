#include "core/io/source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>

namespace aomd::io::detail {
namespace {

/// 1-based line of an offset; a line ends with "\n", "\r\n" or a lone "\r".
std::uint64_t line_of(std::string_view text, std::size_t offset) {
  std::uint64_t line = 1;
  for (std::size_t i = 0; i < std::min(offset, text.size()); ++i) {
    const bool lone_return = text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n');
    line += text[i] == '\n' || lone_return;
  }
  return line;
}

/// A file descriptor that closes itself.
struct Descriptor {
  int fd = -1;
  explicit Descriptor(int f) : fd(f) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

std::string system_message() { return std::strerror(errno); }

}  // namespace

void Source::fail_at_line(std::size_t offset, const std::string& what) const {
  throw ReadError(name, Place{.line = line_of(bytes, offset)}, what);
}

void Source::fail_at_byte(std::size_t offset, const std::string& what) const {
  throw ReadError(name, Place{.byte = skipped + offset}, what);
}

void Source::fail(const std::string& what) const { throw ReadError(name, {}, what); }

Source without_padding(const Source& text) {
  constexpr std::string_view padding("\0\x1a\f \t\r\n", 7);
  const std::size_t last = text.bytes.find_last_not_of(padding);
  const std::size_t mark =
      text.bytes.find_first_of(padding.substr(0, 3), last == std::string_view::npos ? 0 : last);
  return {text.name, text.bytes.substr(0, mark), text.skipped};
}

std::string read_whole(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw ReadError(path.string(), {}, "is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(path.string(), {}, "cannot be opened");
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw ReadError(path.string(), {}, "cannot be read");
  return bytes;
}

FileBytes::FileBytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  // Without O_NONBLOCK, opening a pipe that nobody writes to would hang before fstat can refuse it.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.fd < 0) throw ReadError(name, {}, "cannot be opened: " + system_message());
  struct stat info {};
  if (::fstat(file.fd, &info) != 0)
    throw ReadError(name, {}, "cannot be read: " + system_message());
  if (S_ISDIR(info.st_mode)) throw ReadError(name, {}, "is a folder, not a mesh file");
  if (!S_ISREG(info.st_mode)) throw ReadError(name, {}, "is not a regular file");
  if (info.st_size == 0) throw ReadError(name, {}, "is empty");

  const auto expected = static_cast<std::size_t>(info.st_size);
  try {
    data_ = std::make_unique_for_overwrite<char[]>(expected);
  } catch (const std::bad_alloc&) {
    throw LimitError(name, {}, "does not fit into memory (" + std::to_string(expected) + " bytes)");
  }
  while (size_ < expected) {
    const ssize_t got = ::read(file.fd, data_.get() + size_, expected - size_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw ReadError(name, {}, "cannot be read: " + system_message());
    if (got == 0) break;
    size_ += static_cast<std::size_t>(got);
  }
}

}  // namespace aomd::io::detail
