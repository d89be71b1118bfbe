#include "viewer/ui/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/io/io.h"

namespace aomd::ui {

RecentFiles::RecentFiles(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream in(file_);
  for (std::string line; paths_.size() < most && std::getline(in, line);)
    if (!line.empty()) paths_.emplace_back(line);
}

void RecentFiles::add(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path full = std::filesystem::absolute(path, ignored).lexically_normal();
  std::erase(paths_, full);
  paths_.insert(paths_.begin(), full);
  if (paths_.size() > most) paths_.resize(most);
  if (file_.empty()) return;
  std::string text;
  for (const std::filesystem::path& each : paths_) text += each.string() + "\n";
  std::filesystem::create_directories(file_.parent_path(), ignored);
  try {
    io::write_file(file_, text);
  } catch (const io::WriteError&) {
  }
}

std::filesystem::path recent_files_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (config != nullptr && *config == '/')
    folder = config;
  else if (home != nullptr && *home == '/')
    folder = std::filesystem::path(home) / ".config";
  else
    return {};
  return folder / "aomd-studio" / "recent-files";
}

}  // namespace aomd::ui
