#pragma once
// A session without a window, driven as scripts drive it.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/commands/commands.h"
#include "viewer/commands/lesson_commands.h"
#include "viewer/session/session.h"

namespace aomd::scene::test {

/// Carries out each line and waits until it has come to its end.
inline void drive(Session& session, std::initializer_list<std::string_view> lines) {
  for (const std::string_view line : lines) {
    execute(session, line);
    session.finish();
    update_lesson(session);
    session.refresh();
  }
}

/// What was done, each with the operation at which it begins.
inline std::vector<std::string> labels(const Document& document) {
  std::vector<std::string> all;
  for (const HistoryMark& mark : document.marks())
    all.push_back(mark.label + std::to_string(mark.begin));
  return all;
}

}  // namespace aomd::scene::test
