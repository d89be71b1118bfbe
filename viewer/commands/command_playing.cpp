// The history as a film.

#include <string>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void play(Session& session, Arguments& arguments) {
  const bool on = arguments.done() || arguments.flag(session.sheet().playing());
  arguments.end();
  need_mesh(session);
  session.play(on);
  if (on && !session.sheet().playing())
    session.status = "Nothing to play: step, sweep or run first";
}

void pause(Session& session, Arguments& arguments) {
  arguments.end();
  session.play(false);
}

void play_speed(Session& session, Arguments& arguments) {
  PlaySpeed& speed = session.view.play_speed;
  PlaySpeed wanted = speed;
  const std::string text = arguments.word("operations a second, or whole, faster or slower");
  if (text == "faster" || text == "slower") {
    const std::size_t size = session.document().empty() ? 0 : session.document().journal().size();
    wanted = speed.beside(size, text == "faster");
  } else if (text == "whole") {
    wanted = {0, speed.whole_s};
    if (!arguments.done())
      wanted.whole_s = arguments.number("seconds", PlaySpeed::shortest_s, PlaySpeed::longest_s);
  } else {
    wanted.per_s = Arguments("play-speed", "N|whole [SECONDS]|faster|slower", text)
                       .number("operations a second", PlaySpeed::slowest, PlaySpeed::fastest);
  }
  arguments.end();
  speed = wanted;
  session.status = "Playing: " + speed.words();
}

void operation(Session& session, Arguments& arguments) {
  const std::string sides = arguments.one_of({"before", "after", "both"});
  arguments.end();
  session.view.step_sides = {sides != "after", sides != "before"};
  session.view.operation = true;
}

}  // namespace

std::vector<Command> playing_commands() {
  return {
      {"play",
       "[on|off|toggle]",
       "Plays the history from where it stands; from the start when it is at the end.",
       CommandGroup::History,
       play,
       {{"Space", "play toggle"}}},
      {"pause", "", "Stops playing.", CommandGroup::History, pause, {}},
      {"play-speed",
       "N|whole [SECONDS]|faster|slower",
       "How fast the history is played: N operations a second (0.5 to 1000000), or the whole "
       "history in so "
       "many seconds, however long it is; faster and slower go to the next of 1, 2, 5, 10 ...",
       CommandGroup::History,
       play_speed,
       {{".", "play-speed faster"}, {",", "play-speed slower"}}},
      {"operation",
       "before|after|both",
       "What is pointed at of the last single operation: what stood there before it (blue), what "
       "stands "
       "there after it (pink), or both.",
       CommandGroup::History,
       operation,
       {}},
  };
}

}  // namespace aomd::scene
