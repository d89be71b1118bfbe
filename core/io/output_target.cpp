#include "core/io/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

#include "core/io/error.h"

namespace aomd::io::detail {
namespace {

namespace fs = std::filesystem;

/// The number of a descriptor of this process that a path names, as /proc/self/fd/1 does. What it
/// leads to must not be opened anew: that would begin at its start.
std::optional<int> own_descriptor(const fs::path& path) {
  std::error_code failed;
  const fs::path own = fs::canonical("/proc/self/fd", failed);
  if (failed || fs::canonical(path.parent_path(), failed) != own || failed) return {};
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? std::optional(number)
                                                                  : std::nullopt;
}

/// Follows symbolic links to a descriptor of this process or to the end of the chain, whether that
/// exists or not. The system has found before that there is an end.
OutputTarget without_links(fs::path path) {
  std::error_code failed;
  while (true) {
    if (const auto number = own_descriptor(path))
      return {OutputTarget::Kind::Descriptor, path, {}, *number};
    if (!fs::is_symlink(path, failed)) return {OutputTarget::Kind::File, path, {}, -1};
    const fs::path next = fs::read_symlink(path, failed);
    if (failed) return {OutputTarget::Kind::File, path, {}, -1};
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
}

std::string place_on_disk(const struct stat& info) {
  return std::to_string(info.st_dev) + ':' + std::to_string(info.st_ino);
}

bool takes_bytes(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) != O_RDONLY) return true;
  errno = EBADF;
  return false;
}

/// A file is written beside its target: the folder must be there and allow that.
void require_folder(const fs::path& shown, const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  struct stat info {};
  if (::stat(folder.c_str(), &info) == 0) {
    if (S_ISDIR(info.st_mode) && ::access(folder.c_str(), W_OK | X_OK) == 0) return;
    if (!S_ISDIR(info.st_mode)) errno = ENOTDIR;
  }
  throw WriteError(
      shown.string(), {},
      "cannot be written: its folder " + folder.string() + ": " + std::strerror(errno));
}

}  // namespace

OutputTarget find_output_target(const fs::path& path) {
  struct stat old {};
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (!exists && errno != ENOENT && errno != ENOTDIR && errno != EACCES) fail_to_write(path);
  OutputTarget target = without_links(path);
  if (target.kind == OutputTarget::Kind::Descriptor) {
    if (!takes_bytes(target.descriptor)) fail_to_write(path);
    return target;
  }
  if (exists && S_ISDIR(old.st_mode))
    throw WriteError(path.string(), {}, "cannot be written: it is a folder");
  if (exists && ::access(target.path.c_str(), W_OK) != 0) fail_to_write(path);
  if (exists && !S_ISREG(old.st_mode)) {
    target.kind = OutputTarget::Kind::Stream;
    return target;
  }
  require_folder(path, target.path);
  if (exists) target.mode = old.st_mode & 07777u;
  return target;
}

std::optional<std::string> output_identity(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0)
    return S_ISCHR(info.st_mode) ? std::nullopt : std::optional(place_on_disk(info));
  if (errno == ELOOP) return {};
  const fs::path target = without_links(path).path;
  std::error_code failed;
  const fs::path folder = fs::weakly_canonical(fs::absolute(target, failed).parent_path(), failed);
  return (folder / target.filename()).string();
}

std::optional<std::string> input_identity(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return {};
  return place_on_disk(info);
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

void fail_to_write(const fs::path& path) {
  throw WriteError(path.string(), {}, "cannot be written: " + std::string(std::strerror(errno)));
}

}  // namespace aomd::io::detail
