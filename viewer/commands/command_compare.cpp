// Before and after, and the inside of volumes.

#include <array>
#include <string>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

constexpr double most_shrunk = 0.9;

void compare_with(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  const bool original = again.word("a run's number, or original") == "original";
  session.sheet().runs.set_reference(original ? 0 : kept_run(session, arguments).number);
  (original ? again : arguments).end();
  session.status =
      "Compared with " + (original ? "the mesh as loaded" : session.sheet().reference_name());
}

void compare(Session& session, Arguments& arguments) {
  const std::string how =
      arguments.done() ? "toggle" : arguments.one_of({"side", "off", "toggle", "with"});
  if (how == "with") return compare_with(session, arguments);
  arguments.end();
  session.view.side_by_side = how == "toggle" ? !session.view.side_by_side : how == "side";
}

int axis_of(const std::string& word, const Arguments& arguments) {
  const std::string names = "xyzXYZ";
  const std::size_t at = word.size() == 1 ? names.find(word[0]) : std::string::npos;
  if (at == std::string::npos) arguments.fail("'" + word + "' is none of x, y, z, off");
  return static_cast<int>(at % 3);
}

void clip(Session& session, Arguments& arguments) {
  const std::string axis = arguments.word("x, y, z or off");
  if (axis == "off") {
    arguments.end();
    session.view.clip.reset();
    return;
  }
  Clip clip;
  clip.axis = axis_of(axis, arguments);
  clip.position = arguments.number("a position from 0 to 1", 0, 1);
  while (!arguments.done()) {
    const std::string word = arguments.one_of({"cut", "cells", "flip"});
    if (word == "flip")
      clip.flip = true;
    else
      clip.cells = word == "cells";
  }
  session.view.clip = clip;
}

void shrink(Session& session, Arguments& arguments) {
  session.view.shrink = arguments.number("a part from 0 to 0.9", 0, most_shrunk);
  arguments.end();
}

void mark(Session& session, Arguments& arguments) {
  Arguments ahead = arguments;
  if (ahead.word("angle, length, valence or off") == "off") {
    ahead.end();
    session.view.marked.reset();
    return;
  }
  need_mesh(session);
  session.view.marked = bar_of_histogram(arguments);
}

}  // namespace

MarkedBar bar_of_histogram(Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, HistogramKind>, 3> kinds = {
      {{"angle", HistogramKind::Angle},
       {"length", HistogramKind::Length},
       {"valence", HistogramKind::Valence}}};
  MarkedBar bar;
  bar.kind = arguments.choice(kinds);
  bar.value = arguments.number("a value in the bar");
  arguments.end();
  return bar;
}

std::vector<Command> compare_commands() {
  return {
      {"compare",
       "side|off|toggle|with N|original",
       "side: the mesh as loaded on the left, the present one on the right, seen by one camera. "
       "with puts "
       "run "
       "N (see runs) in the place of the mesh as loaded, there, in show original and in "
       "histograms; original "
       "puts that back.",
       CommandGroup::View,
       compare,
       {{"K", "compare toggle"}}},
      {"clip",
       "x|y|z|off POSITION [cut|cells] [flip]",
       "Hides what lies beyond a plane across an axis; POSITION goes from 0 to 1 through the box "
       "of the mesh "
       "as loaded. cut goes through the faces and shows the section of a volume; cells takes whole "
       "faces and "
       "regions, by their middles. flip hides the other side.",
       CommandGroup::View,
       clip,
       {{"X", "clip x 0.5"}, {"Shift+X", "clip off"}}},
      {"shrink",
       "F",
       "Pulls every face, of a volume every region, towards its middle: 0 not at all, up to 0.9.",
       CommandGroup::View,
       shrink,
       {}},
      {"mark",
       "angle|length|valence|off VALUE",
       "Brightens what the bar of a histogram counts that VALUE lies in: faces by their smallest "
       "angle, "
       "of a volume regions by their smallest dihedral angle; edges by their length over the "
       "spacing, "
       "vertices by their number of edges.",
       CommandGroup::View,
       mark,
       {}},
  };
}

}  // namespace aomd::scene
