#include <string>

#include "viewer/base/entity_text.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/document/history_places.h"

namespace aomd::scene {
namespace {

std::size_t count_or_one(Arguments& arguments, std::string_view what) {
  if (arguments.done()) return 1;
  const auto count = static_cast<std::size_t>(arguments.integer(what, 1, largest_count));
  arguments.end();
  return count;
}

void say(Session& session, const std::string& name, std::size_t made) {
  const std::string size = size_words(session.document().mesh());
  if (made == 0)
    session.status = name + ": nothing left to do with these settings, " + size;
  else
    session.status = name + ": " + counted(made, "operation") + ", " + size;
}

void start_edit(Session& session, Arguments& arguments) {
  arguments.end();
  need_decimable(session);
  session.play(false);
}

void step(Session& session, Arguments& arguments) {
  const long long count =
      arguments.done() ? 1 : arguments.integer("a number of steps", -largest_count, largest_count);
  start_edit(session, arguments);
  Document& document = session.document();
  if (count >= 0) {
    say(session, "Step", document.step(static_cast<std::size_t>(count)));
    return;
  }
  const auto back = static_cast<std::size_t>(-count);
  const std::size_t cursor = document.journal().cursor();
  document.seek(back < cursor ? cursor - back : 0);
  session.status = "Step back: " + place_words(document.journal());
}

void sweep(Session& session, Arguments& arguments) {
  const std::size_t count = count_or_one(arguments, "a number of sweeps");
  start_edit(session, arguments);
  say(session, "Sweep", session.document().sweep(count));
}

void swap_edges(Session& session, Arguments& arguments) {
  start_edit(session, arguments);
  say(session, "Swap", session.document().swap());
}

void smooth(Session& session, Arguments& arguments) {
  start_edit(session, arguments);
  say(session, "Smooth", session.document().smooth());
}

void improve(Session& session, Arguments& arguments) {
  start_edit(session, arguments);
  say(session, "Improve", session.document().improve());
}

void run(Session& session, Arguments& arguments) {
  start_edit(session, arguments);
  session.document().start_run();
  session.status =
      session.document().running() ? "Running ..." : "Run: nothing left to do with these settings";
}

void cancel(Session& session, Arguments& arguments) {
  arguments.end();
  if (session.document().running()) session.status = "Run cancelled: undo takes back what it did";
  session.document().cancel_run();
  session.cancel_loading();
  session.cancel_series();
  session.cancel_comparison();
  session.cancel_measuring();
  session.play(false);
}

}  // namespace

std::vector<Command> edit_commands() {
  return {
      {"step",
       "[N]",
       "N new single operations; -N goes back as many.",
       CommandGroup::Operations,
       step,
       {{"Left", "step -1"}, {"Shift+Left", "step -100"}}},
      {"sweep",
       "[N]",
       "Collapses edges to the end of the present sweep.",
       CommandGroup::Operations,
       sweep,
       {{"S", "sweep"}}},
      {"swap",
       "",
       "One pass of edge swaps.",
       CommandGroup::Operations,
       swap_edges,
       {{"W", "swap"}}},
      {"smooth",
       "",
       "One pass of vertex smoothing.",
       CommandGroup::Operations,
       smooth,
       {{"M", "smooth"}}},
      {"improve",
       "",
       "One pass of swaps, then one of smoothing.",
       CommandGroup::Operations,
       improve,
       {{"I", "improve"}}},
      {"run",
       "",
       "Sweeps and improves until nothing is left to do. The window stays live.",
       CommandGroup::Operations,
       run,
       {{"R", "run"}}},
      {"cancel",
       "",
       "Stops a run between two operations, drops what is being loaded, stops playing, exporting, "
       "comparing "
       "and measuring.",
       CommandGroup::Operations,
       cancel,
       {{"Escape", "cancel"}}},
  };
}

}  // namespace aomd::scene
