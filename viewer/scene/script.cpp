#include "viewer/scene/script.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/io/error.h"
#include "viewer/scene/commands.h"

namespace aomd::scene {
namespace {

bool may_interrupt(const std::string& line) {
  constexpr std::array<std::string_view, 3> names = {"cancel", "pause", "log"};
  const std::string first = line.substr(0, line.find_first_of(" \t\r"));
  return std::find(names.begin(), names.end(), first) != names.end();
}

}  // namespace

Script::Script(const std::filesystem::path& file) : name_(file.string()) {
  std::ifstream in(file);
  if (!in) throw io::ReadError(name_, {}, "cannot be read");
  for (std::string line; std::getline(in, line);) lines_.push_back(line);
}

bool Script::advance(Session& session) {
  if (done()) return false;
  const std::string& line = lines_[next_];
  // What fails while it is loaded is the fault of the line that asked for it: wait, unless that is
  // taken back.
  const bool may = may_interrupt(line) && (!session.loading() || line.rfind("cancel", 0) == 0);
  const bool ready = (session.idle() && session.screenshots.empty()) || may;
  if (!ready) return false;
  ++next_;
  try {
    execute(session, line);
  } catch (const std::exception&) {
    fail();
  }
  return true;
}

void Script::fail() const {
  try {
    throw;
  } catch (const std::exception& cause) {
    std::throw_with_nested(ScriptError(name_ + ":" + std::to_string(next_) + ": " + cause.what()));
  }
}

}  // namespace aomd::scene
