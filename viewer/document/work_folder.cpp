#include "viewer/document/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <system_error>
#include <utility>

#include "core/io/error.h"

namespace aomd::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view digits = "0123456789";

std::vector<fs::path> files_where(const fs::path& folder,
                                  const std::function<bool(const fs::path&)>& wanted) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error))
    if (wanted(it->path())) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether it is the name of a program: "4711", or "4711+2" where that was taken.
bool is_name(const std::string& name) {
  return !name.empty() && digits.find(name.front()) != std::string_view::npos &&
         name.find_first_not_of("0123456789+") == std::string::npos;
}

/// Whether a program with that name writes a file like this, NAME.json apart: "NAME-12.journal", or
/// what is to become one of its files.
bool is_side_file(const std::string& file, const std::string& name) {
  if (file.rfind(name + ".json.", 0) == 0) return true;
  if (file.rfind(name + "-", 0) != 0) return false;
  const std::string rest = file.substr(name.size() + 1);
  const std::size_t end = rest.find_first_not_of(digits);
  if (end == 0 || end == std::string::npos) return false;
  return rest.substr(end) == ".journal" || rest.rfind(".journal.", end) == end;
}

/// What a process has left that its NAME.json does not name: journals, and files that it was about
/// to write.
void remove_strays(const fs::path& folder, const std::string& name, const fs::path& kept) {
  std::error_code ignored;
  for (const fs::path& file : files_where(folder, [&](const fs::path& each) {
         return each != kept && is_side_file(each.filename().string(), name);
       }))
    fs::remove(file, ignored);
}

/// Of a program that is dead; null where it left none.
std::shared_ptr<const SavedWork> take(const fs::path& lock_file) {
  auto lock = FileLock::take(lock_file);
  if (!lock) return {};
  const fs::path file = fs::path(lock_file).replace_extension(".json");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {  // it had nothing to lose
    remove_strays(lock_file.parent_path(), lock_file.stem().string(), {});
    fs::remove(lock_file, ignored);
    return {};
  }
  auto work = std::make_shared<SavedWork>(read_saved_work(file));
  remove_strays(lock_file.parent_path(), lock_file.stem().string(), work->journal);
  work->lock = std::move(lock);
  return work;
}

}  // namespace

std::shared_ptr<const FileLock> FileLock::take(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return {};
  std::shared_ptr<const FileLock> lock(new FileLock(descriptor));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return {};
  // Whoever held it before may have removed the file in between: then this lock keeps nobody out.
  struct stat held {
  }, named{};
  const bool same = ::fstat(descriptor, &held) == 0 && ::stat(file.c_str(), &named) == 0 &&
                    held.st_ino == named.st_ino && held.st_dev == named.st_dev;
  return same ? lock : nullptr;
}

FileLock::~FileLock() { ::close(descriptor_); }

FoundWork find_saved_work(const fs::path& folder) {
  FoundWork found;
  for (const fs::path& lock : files_where(folder, [](const fs::path& each) {
         return each.extension() == ".lock" && is_name(each.stem().string());
       })) {
    try {
      if (auto work = take(lock)) found.works.push_back(std::move(work));
    } catch (const io::ReadError& error) {
      found.unreadable.emplace_back(error.what());
    }
  }
  std::stable_sort(found.works.begin(), found.works.end(),
                   [](const auto& a, const auto& b) { return a->seconds > b->seconds; });
  return found;
}

void discard(const SavedWork& work) {
  std::error_code ignored;
  fs::remove(work.file, ignored);
  fs::remove(work.journal, ignored);
  fs::remove(fs::path(work.file).replace_extension(".lock"), ignored);
}

fs::path recovery_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state != nullptr && *state == '/') return fs::path(state) / "aomd";
  if (home != nullptr && *home == '/') return fs::path(home) / ".local" / "state" / "aomd";
  return {};
}

}  // namespace aomd::scene
