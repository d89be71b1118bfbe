// Writing a file whole or not at all.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "core/io/io.h"

namespace aomd::io {
namespace {

namespace fs = std::filesystem;

/// A file open for writing; close() tells whether the bytes arrived.
class OutputFile {
 public:
  OutputFile(const fs::path& path, int flags)
      : fd_(::open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666)) {}
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() { close(); }

  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  [[nodiscard]] bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t done = ::write(fd_, bytes.data(), bytes.size());
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
  }
  [[nodiscard]] bool flush() const { return ::fsync(fd_) == 0; }
  [[nodiscard]] bool set_mode(mode_t mode) const { return ::fchmod(fd_, mode & 07777u) == 0; }
  bool close() {
    if (fd_ < 0) return true;
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

[[noreturn]] void fail(const fs::path& path) {
  throw WriteError(path.string(), {}, "cannot be written: " + std::string(std::strerror(errno)));
}

/// What a chain of symbolic links names in the end, whether it exists or not.
fs::path without_links(fs::path path) {
  constexpr int longest_chain = 40;
  std::error_code ignored;
  for (int i = 0; i < longest_chain && fs::is_symlink(path, ignored); ++i) {
    const fs::path next = fs::read_symlink(path, ignored);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

/// A name beside the target that no other writer uses.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  fs::path path = target;
  path += ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  return path;
}

/// Pipes and devices take the bytes as they come: there is nothing to replace.
void write_to_device(const fs::path& shown, const fs::path& path, std::string_view bytes) {
  OutputFile file(path, 0);
  if (!file.is_open() || !file.write(bytes) || !file.close()) fail(shown);
}

void flush_folder(const fs::path& folder) {
  const int fd = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);  // only makes the rename survive a power cut; the file itself is whole either way
  ::close(fd);
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
  const fs::path target = without_links(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    throw WriteError(path.string(), {}, "cannot be written: it is a folder");
  if (exists && !S_ISREG(old.st_mode)) return write_to_device(path, target, bytes);
  if (exists && ::access(target.c_str(), W_OK) != 0) fail(path);

  const fs::path temporary = temporary_beside(target);
  OutputFile file(temporary, O_CREAT | O_EXCL);
  if (!file.is_open()) fail(path);
  const bool written = (!exists || file.set_mode(old.st_mode)) && file.write(bytes) &&
                       file.flush() && file.close() &&
                       ::rename(temporary.c_str(), target.c_str()) == 0;
  if (!written) {
    const int cause = errno;
    ::unlink(temporary.c_str());
    errno = cause;
    fail(path);
  }
  flush_folder(target.parent_path());
}

}  // namespace aomd::io
