// How numbers become colours.

#include <array>
#include <string>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

constexpr double widest = 1e300;
constexpr int most_steps = 20;

/// That of what the colours mean now.
ScaleChoice& scale_of(Session& session) {
  const View& view = session.view;
  if (view.scale_choice() == nullptr)
    throw CommandError(
        "the colours are no numbers now: color spacing, quality, distance or "
        "curvature first");
  return session.view.scales[static_cast<std::size_t>(view.scale_choice() - view.scales.data())];
}

void range(Session& session, Arguments& arguments) {
  ScaleChoice& scale = scale_of(session);
  ScaleChoice wanted = scale;
  Arguments again = arguments;
  const std::string word = again.word("two numbers, auto or percentile");
  if (word == "auto") {
    wanted.range = ScaleChoice::Range::Automatic;
    arguments = again;
  } else if (word == "percentile") {
    wanted.range = ScaleChoice::Range::Percentile;
    wanted.percentile = again.number("percent of the values", 50, 100);
    arguments = again;
  } else {
    wanted.range = ScaleChoice::Range::Fixed;
    wanted.low = arguments.number("the start of the scale", -widest, widest);
    wanted.high = arguments.number("the end of the scale", -widest, widest);
    if (!(wanted.low < wanted.high)) arguments.fail("the end of a scale is larger than its start");
  }
  arguments.end();
  scale = wanted;
}

void choose_map(ScaleChoice& scale, Arguments& arguments) {
  using Map = std::optional<ColorMap>;
  constexpr std::array<std::pair<std::string_view, Map>, 5> maps = {{{"auto", Map()},
                                                                     {"viridis", ColorMap::Viridis},
                                                                     {"magma", ColorMap::Magma},
                                                                     {"cividis", ColorMap::Cividis},
                                                                     {"grey", ColorMap::Grey}}};
  scale.map = arguments.choice(maps);
}

void choose_spread(ScaleChoice& scale, Arguments& arguments) {
  using Spread = std::optional<bool>;
  constexpr std::array<std::pair<std::string_view, Spread>, 3> spreads = {
      {{"auto", Spread()}, {"linear", false}, {"log", true}}};
  scale.logarithmic = arguments.choice(spreads);
}

void scale(Session& session, Arguments& arguments) {
  ScaleChoice& present = scale_of(session);
  ScaleChoice wanted = present;
  const std::string what = arguments.one_of({"map", "steps", "spread"});
  if (what == "map") choose_map(wanted, arguments);
  if (what == "spread") choose_spread(wanted, arguments);
  if (what == "steps")
    wanted.steps = static_cast<int>(arguments.integer("a number of colours", 0, most_steps));
  arguments.end();
  present = wanted;
}

}  // namespace

std::vector<Command> scale_commands() {
  return {
      {"range",
       "MIN MAX|auto|percentile P",
       "Where the scale of the present colours begins and ends, in its unit: at two numbers, as "
       "the "
       "values do (auto, as at first), or so that P percent of them lie below its end and as many "
       "above its start. Values beyond have the colour of the end. Kept for each kind of colours, "
       "over runs and files.",
       CommandGroup::View,
       range,
       {}},
      {"scale",
       "map auto|viridis|magma|cividis|grey | steps N | spread auto|linear|log",
       "How the present colours follow their numbers: along which map (each is even and reads "
       "without seeing colours), in how many steps (up to 20; 0: none), and evenly or by the "
       "logarithm.",
       CommandGroup::View,
       scale,
       {}},
  };
}

}  // namespace aomd::scene
