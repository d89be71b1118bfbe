#include "viewer/commands/script.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/io/error.h"
#include "viewer/commands/commands.h"

namespace aomd::scene {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

std::string_view name_in(std::string_view line) {
  line = command_text(line);
  return line.substr(0, line.find_first_of(" \t"));
}

bool may_interrupt(std::string_view line) {
  constexpr std::array<std::string_view, 3> names = {"cancel", "pause", "log"};
  const std::string_view first = name_in(line);
  return std::find(names.begin(), names.end(), first) != names.end();
}

}  // namespace

Script::Script(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream in(file);
  if (!in) throw io::ReadError(name, {}, "cannot be read");
  if (std::filesystem::is_directory(file)) throw io::ReadError(name, {}, "is a folder");
  for (std::string line; std::getline(in, line);)
    lines_.push_back({line, name + ":" + std::to_string(lines_.size() + 1)});
  if (in.bad()) throw io::ReadError(name, {}, "cannot be read to its end");
  if (!lines_.empty() && lines_.front().text.rfind(byte_order_mark, 0) == 0)
    lines_.front().text.erase(0, byte_order_mark.size());
}

void Script::add(const std::string& place, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) lines_.push_back({line, place});
}

bool Script::advance(const Session& session,
                     const std::function<void(const std::string&)>& carry_out) {
  if (done()) return false;
  const std::string& line = lines_[next_].text;
  // What fails while it is loaded is the fault of the line that asked for it: wait, unless that is
  // taken back.
  const bool may = may_interrupt(line) && (!session.loading() || name_in(line) == "cancel");
  const bool ready = (session.idle() && session.screenshots.empty()) || may;
  if (!ready) return false;
  ++next_;
  try {
    carry_out(line);
  } catch (const std::exception&) {
    fail();
  }
  return true;
}

void Script::fail() const {
  try {
    throw;
  } catch (const std::exception& cause) {
    std::throw_with_nested(ScriptError(lines_[next_ - 1].place + ": " + cause.what()));
  }
}

}  // namespace aomd::scene
