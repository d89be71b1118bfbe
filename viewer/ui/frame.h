#pragma once
// What every panel is given: something to read, something to write to, and the look.

#include <string>
#include <string_view>
#include <vector>

#include "viewer/session/session.h"
#include "viewer/ui/theme.h"

namespace aomd::ui {

/// Panels read the session and emit lines; whoever called them executes the lines afterwards.
struct Frame {
  const scene::Session& session;
  const Fonts& fonts;
  ThemeColors colors;
  bool interactive = true;  ///< false for pictures: nothing that depends on time is drawn
  std::vector<std::string> lines;

  void emit(std::string line) { lines.push_back(std::move(line)); }
  [[nodiscard]] const scene::Document& document() const { return session.document(); }
  [[nodiscard]] bool has_mesh() const { return !session.document().empty(); }
  [[nodiscard]] bool can_decimate() const { return has_mesh() && document().hindrance().empty(); }
};

}  // namespace aomd::ui
