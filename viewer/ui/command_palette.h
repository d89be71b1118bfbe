#pragma once
// All commands in one list that is searched by typing.

#include <string>
#include <vector>

#include "viewer/commands/command_search.h"
#include "viewer/ui/frame.h"

namespace aomd::ui {

/// The content of the palette's dialog. Enter, or a click, emits the chosen line; where it lacks
/// arguments it is put into the field to be completed. Stays open over an error, which it shows,
/// and closes otherwise.
class CommandPalette {
 public:
  static constexpr std::size_t most_recent = 8;

  /// To be called when the dialog appears.
  void begin(const Frame& frame);
  void draw(Frame& frame);

  /// The lines that were chosen last, newest first.
  std::vector<std::string> recent;

 private:
  void draw_field(const Frame& frame);
  void draw_list(Frame& frame);
  [[nodiscard]] static bool draw_row(const Frame& frame, const scene::CommandMatch& match,
                                     bool chosen);
  static void draw_footer(const Frame& frame);
  void move_choice();
  void choose(Frame& frame, const scene::CommandMatch& match);
  void remember(const std::string& line);

  std::string text_;
  std::string searched_;  ///< what matches_ answers
  std::vector<scene::CommandMatch> matches_;
  std::size_t chosen_ = 0;
  std::string sent_;  ///< emitted in the last frame
  bool focus_ = false;
  bool entered_ = false;
  bool caret_to_end_ = false;
  bool scroll_ = false;
};

}  // namespace aomd::ui
