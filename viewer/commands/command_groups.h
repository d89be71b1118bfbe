#pragma once
// The table of commands in parts: each source file has the handlers of its commands and, below
// them, their rows. A new command is a handler and a row in one of these files; docs/COMMANDS.md is
// then generated anew.

#include <compare>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/commands/arguments.h"
#include "viewer/commands/commands.h"
#include "viewer/session/session.h"

namespace aomd::scene {

// The rows of each file, in the order in which they are listed. commands() joins them once.
[[nodiscard]] std::vector<Command> file_commands();       // command_files.cpp
[[nodiscard]] std::vector<Command> aim_commands();        // command_aims.cpp
[[nodiscard]] std::vector<Command> option_commands();     // command_options.cpp
[[nodiscard]] std::vector<Command> adjacency_commands();  // command_adjacency.cpp
[[nodiscard]] std::vector<Command> tensor_commands();     // command_tensor.cpp
[[nodiscard]] std::vector<Command> edit_commands();       // command_edits.cpp
[[nodiscard]] std::vector<Command> history_commands();    // command_history.cpp
[[nodiscard]] std::vector<Command> playing_commands();    // command_playing.cpp
[[nodiscard]] std::vector<Command> branch_commands();     // command_branches.cpp
[[nodiscard]] std::vector<Command> run_commands();        // command_runs.cpp
[[nodiscard]] std::vector<Command> selection_commands();  // command_selection.cpp
[[nodiscard]] std::vector<Command> neighbour_commands();  // command_neighbours.cpp
[[nodiscard]] std::vector<Command> class_commands();      // command_classes.cpp
[[nodiscard]] std::vector<Command> camera_commands();     // command_camera.cpp
[[nodiscard]] std::vector<Command> view_commands();       // command_views.cpp
[[nodiscard]] std::vector<Command> scale_commands();      // command_scales.cpp
[[nodiscard]] std::vector<Command> output_commands();     // command_outputs.cpp
[[nodiscard]] std::vector<Command> work_commands();       // command_work.cpp
[[nodiscard]] std::vector<Command> compare_commands();    // command_compare.cpp
[[nodiscard]] std::vector<Command> lesson_commands();     // command_lessons.cpp
[[nodiscard]] std::vector<Command> script_commands();     // command_scripts.cpp

// What handlers of several files need.

/// No count that a line gives is larger.
inline constexpr long long largest_count = 1'000'000'000;
/// A file as a line names it: ~/ is the user's own folder. In command_files.cpp.
[[nodiscard]] std::filesystem::path expanded(const std::string& text);
/// Throws CommandError where there is no mesh yet. In command_files.cpp.
void need_mesh(const Session& session);
/// Throws CommandError where there is no mesh, or one that cannot be decimated. In
/// command_files.cpp.
void need_decimable(const Session& session);
/// "angle", "length" or "valence" and a value in the bar. In command_compare.cpp.
[[nodiscard]] MarkedBar bar_of_histogram(Arguments& arguments);
/// The number of a kept state. Throws CommandError where there is none. In command_runs.cpp.
[[nodiscard]] KeptRun kept_run(const Session& session, Arguments& arguments);
/// "vertex", "edge", "face" or "region" and the ids that follow it. In command_selection.cpp.
[[nodiscard]] std::vector<EntityRef> listed_entities(Session& session, Arguments& arguments);
/// The rest of `expect adjacency I J = on|off`; throws ExpectationMissed. In command_adjacency.cpp.
void expect_adjacency(Session& session, Arguments& arguments);
/// "=", "<", ">", "<=" or ">=". In command_expectations.cpp.
[[nodiscard]] std::string comparison(Arguments& arguments);
/// Whether a value and its bound, compared, are as it says. In command_expectations.cpp.
[[nodiscard]] bool holds(std::string_view sign, std::partial_ordering compared);
/// What `expect` knows besides counts. False: the next word is none of it, and nothing has been
/// read. Throws ExpectationMissed. In command_expectations.cpp.
[[nodiscard]] bool expect_other(Session& session, Arguments& arguments);

}  // namespace aomd::scene
