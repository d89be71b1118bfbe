// Joins the rows of the groups into the one table.

#include <array>
#include <iterator>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

/// In the order in which the commands are listed.
constexpr std::array groups = {
    file_commands,      output_commands, work_commands,      aim_commands,       option_commands,
    adjacency_commands, tensor_commands, edit_commands,      history_commands,   playing_commands,
    branch_commands,    run_commands,    selection_commands, neighbour_commands, class_commands,
    camera_commands,    view_commands,   scale_commands,     compare_commands,   lesson_commands,
    script_commands};

std::vector<Command> joined() {
  std::vector<Command> table;
  for (const auto group : groups) {
    std::vector<Command> rows = group();
    table.insert(table.end(), std::make_move_iterator(rows.begin()),
                 std::make_move_iterator(rows.end()));
  }
  return table;
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> table = joined();
  return table;
}

}  // namespace aomd::scene
