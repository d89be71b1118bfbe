#include <string>

#include "core/mesh/names.h"
#include "viewer/commands/command_groups.h"
#include "viewer/document/adjacency.h"

namespace aomd::scene {
namespace {

struct Cell {
  int i = 0, j = 0;
};

Cell cell(Arguments& arguments) {
  constexpr const char* level = "a level from 0 (vertices) to 3 (regions)";
  const auto next = [&] {
    const long long value = arguments.integer(level);
    if (value < 0 || value > 3) arguments.fail("'" + std::to_string(value) + "' is not " + level);
    return static_cast<int>(value);
  };
  const int i = next();
  const int j = next();
  if (i == j) arguments.fail("I and J are two different levels: T has no relation on its diagonal");
  return {i, j};
}

void adjacency(Session& session, Arguments& arguments) {
  const auto [i, j] = cell(arguments);
  need_mesh(session);
  const bool on = arguments.flag(adjacency_cell(session.document().mesh(), i, j).set);
  arguments.end();
  const AdjacencyChange& change = session.document().set_adjacency(i, j, on);
  session.status = change_words(session.document().mesh(), change);
}

}  // namespace

void expect_adjacency(Session& session, Arguments& arguments) {
  static_cast<void>(arguments.word("adjacency"));
  const auto [i, j] = cell(arguments);
  if (const std::string sign = arguments.word("="); sign != "=")
    arguments.fail("'" + sign + "' is not =");
  const std::string text = arguments.one_of({"on", "off"});
  arguments.end();
  const bool stored = session.document().mesh().stored(i, j);
  if (stored != (text == "on"))
    throw ExpectationMissed("expected " + relation_name(i, j) + " to be " + text + ", but it is " +
                            (stored ? "on" : "off"));
}

std::vector<Command> adjacency_commands() {
  return {
      {"adjacency",
       "I J [on|off|toggle]",
       "Stores the relation T(I,J) of levels 0 (vertices) to 3 (regions), or lets go of it. It "
       "stays stored "
       "while an algorithm needs it or where it defines entities. Not part of the history.",
       CommandGroup::Options,
       adjacency,
       {}},
  };
}

}  // namespace aomd::scene
