// What lies around the selected entity, through T(I,J).

#include <string>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

std::optional<int> level_or_off(Arguments& arguments) {
  const std::string word = arguments.one_of({"vertex", "edge", "face", "region", "off"});
  arguments.end();
  return level_named(word);
}

void neighbours(Session& session, Arguments& arguments) {
  const std::optional<int> level = level_or_off(arguments);
  if (level) need_mesh(session);
  session.view.neighbours = level;
  if (!level) {
    session.status = "Neighbours off";
    return;
  }
  session.refresh();
  session.status = session.sheet().inquiry().neighbours()
                       ? session.sheet().inquiry().neighbours()->words
                       : "Neighbours: select one entity to see what lies around it";
}

}  // namespace

std::vector<Command> neighbour_commands() {
  return {
      {"neighbours",
       "vertex|edge|face|region|off",
       "Lights up the entities of a level around the selected one: stored ones solid, derived ones "
       "dashed, "
       "with the path of stored relations that leads to them. Stays on while the selection "
       "changes.",
       CommandGroup::Selection,
       neighbours,
       {}},
  };
}

}  // namespace aomd::scene
