#include "core/io/output_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/io/io.h"
#include "core/io/output_target.h"

namespace aomd::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_prefix = ".aomd-", temporary_suffix = ".tmp";

/// The temporaries of this process, which abandon_outputs() removes. It is never destroyed: a
/// signal may come while the program ends.
struct Registry {
  std::mutex mutex;
  std::set<fs::path> temporaries;
  bool appeared = false;
};

Registry& registry() {
  static auto* const known = new Registry;
  return *known;
}

/// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int fd() const { return fd_; }
  bool close() {
    const int fd = std::exchange(fd_, -1);
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

bool is_temporary(std::string_view name) {
  return name.starts_with(temporary_prefix) && name.ends_with(temporary_suffix);
}

/// Whoever writes a temporary holds a lock on it: one that can be locked has been left behind.
void remove_if_stale(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat info {};
  if (file.fd() < 0 || ::fstat(file.fd(), &info) != 0 || !S_ISREG(info.st_mode)) return;
  if (::flock(file.fd(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
}

void remove_stale_temporaries(const fs::path& folder) {
  DIR* const entries = ::opendir(folder.empty() ? "." : folder.c_str());
  if (entries == nullptr) return;
  while (const dirent* const entry = ::readdir(entries))
    if (is_temporary(entry->d_name)) remove_if_stale(folder / entry->d_name);
  ::closedir(entries);
}

void flush_folder(const fs::path& folder) {
  const Descriptor file(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Only makes the rename survive a power cut; the file itself is whole either way.
  if (file.fd() >= 0) ::fsync(file.fd());
}

}  // namespace

/// One file, from its temporary to its place.
class OutputFiles::Temporary {
 public:
  Temporary(fs::path shown, detail::OutputTarget target)
      : shown_(std::move(shown)), target_(std::move(target)), file_(open()) {
    if (file_.fd() < 0) detail::fail_to_write(shown_);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    const std::scoped_lock lock(registry().mutex);
    if (there_) ::unlink(path_.c_str());
    registry().temporaries.erase(path_);
  }

  [[nodiscard]] const fs::path& shown() const { return shown_; }
  [[nodiscard]] fs::path folder() const { return target_.path.parent_path(); }

  void write(const std::function<void(const Take&)>& content) {
    const auto need = [&](bool done) {
      if (!done) detail::fail_to_write(shown_);
    };
    need(!target_.mode || ::fchmod(file_.fd(), *target_.mode) == 0);
    content([&](std::string_view bytes) { need(detail::write_all(file_.fd(), bytes)); });
    need(::fsync(file_.fd()) == 0);
  }

  /// With the registry locked. What stood there is kept in the temporary's place where others
  /// follow, which may fail.
  [[nodiscard]] bool put_in_place(bool others_follow) {
    struct stat old {};
    existed_ = ::lstat(target_.path.c_str(), &old) == 0;
    if (existed_ && S_ISDIR(old.st_mode)) {
      errno = EISDIR;
      return false;
    }
    exchanged_ =
        existed_ && others_follow &&
        ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.path.c_str(), RENAME_EXCHANGE) == 0;
    if (exchanged_) return true;
    there_ = ::rename(path_.c_str(), target_.path.c_str()) != 0;
    return !there_;
  }

  /// With the registry locked: undoes put_in_place(). A file system without the exchange of two
  /// names has lost what stood there.
  void take_back() {
    if (exchanged_) {
      there_ = ::rename(path_.c_str(), target_.path.c_str()) != 0;
    } else if (!existed_) {
      ::unlink(target_.path.c_str());
    }
  }

 private:
  /// Opens a file of a name that is nobody's: neither a file nor a link of that name is followed.
  int open() {
    const std::scoped_lock lock(registry().mutex);
    for (unsigned number = 0;; ++number) {
      path_ = folder() / (std::string(temporary_prefix) + std::to_string(::getpid()) + "-" +
                          std::to_string(number) + std::string(temporary_suffix));
      const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (fd < 0 && errno == EEXIST) continue;
      if (fd < 0 || locked(fd)) {
        there_ = fd >= 0;
        if (there_) registry().temporaries.insert(path_);
        return fd;
      }
      ::close(fd);
    }
  }

  /// False where another process took the new file for one that was left behind. File systems
  /// without locks have nobody who could.
  static bool locked(int fd) {
    struct stat info {};
    ::flock(fd, LOCK_EX);
    return ::fstat(fd, &info) == 0 && info.st_nlink > 0;
  }

  fs::path shown_;
  detail::OutputTarget target_;
  fs::path path_;
  bool there_ = false;  ///< something has the temporary's name: this file, or the one before it
  bool existed_ = false, exchanged_ = false;
  Descriptor file_;
};

/// What pipes, devices and descriptors are to get.
struct OutputFiles::Stream {
  fs::path shown;
  detail::OutputTarget target;
  std::string bytes;

  void write() const {
    const bool own = target.kind == detail::OutputTarget::Kind::Descriptor;
    Descriptor file(own ? ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, 0)
                        : ::open(target.path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.fd() < 0 || !detail::write_all(file.fd(), bytes) || !file.close())
      detail::fail_to_write(shown);
  }
};

OutputFiles::OutputFiles() = default;
OutputFiles::~OutputFiles() = default;

void OutputFiles::add(const fs::path& path, std::string_view bytes) {
  add(path, [&](const Take& take) { take(bytes); });
}

void OutputFiles::add(const fs::path& path, const std::function<void(const Take&)>& write) {
  detail::OutputTarget target = detail::find_output_target(path);
  if (target.kind != detail::OutputTarget::Kind::File) {
    streams_.push_back({path, std::move(target), {}});
    write([&](std::string_view bytes) { streams_.back().bytes += bytes; });
    return;
  }
  remove_stale_temporaries(target.path.parent_path());
  auto file = std::make_unique<Temporary>(path, std::move(target));
  file->write(write);
  files_.push_back(std::move(file));
}

// Permissions do not say all: the folder may lie on what cannot be written.
void OutputFiles::probe(const fs::path& path) {
  detail::OutputTarget target = detail::find_output_target(path);
  if (target.kind == detail::OutputTarget::Kind::File)
    const Temporary unused(path, std::move(target));
}

// Streams first, and without the lock: they may block, and they cannot be taken back.
void OutputFiles::commit() {
  for (const Stream& stream : streams_) stream.write();
  {
    const std::scoped_lock lock(registry().mutex);
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i]->put_in_place(i + 1 < files_.size())) continue;
      const int cause = errno;
      for (std::size_t k = i; k-- > 0;) files_[k]->take_back();
      errno = cause;
      detail::fail_to_write(files_[i]->shown());
    }
    registry().appeared = true;
  }
  for (const auto& file : files_) flush_folder(file->folder());
  files_.clear();
  streams_.clear();
}

bool abandon_outputs() {
  static std::unique_lock<std::mutex> held_for_ever;
  held_for_ever = std::unique_lock(registry().mutex);
  for (const fs::path& path : registry().temporaries) ::unlink(path.c_str());
  return registry().appeared;
}

void write_file(const fs::path& path, std::string_view bytes) {
  OutputFiles files;
  files.add(path, bytes);
  files.commit();
}

}  // namespace aomd::io
