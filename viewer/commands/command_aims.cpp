// What a decimation goes for: its strategy, and how far it goes.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

/// A length factor, no limit, a number of faces and a spacing exclude each other.
void no_other_aim(DecimationOptions& options) {
  options.coarsest = false;
  options.target_faces = 0;
  options.spacing.reset();
}

std::int64_t tetrahedra(const MeshFacts& facts) {
  return facts.shapes[static_cast<std::size_t>(Shape::Tetrahedron)];
}

/// Sets a strategy or an aim. An angle that is the usual one follows.
void set_with_angle(Session& session, DecimationOptions options) {
  const DecimationOptions& before = session.document().options();
  if (before.angle_deg == usual_angle_deg(before.strategy, before.coarsest))
    options.angle_deg = usual_angle_deg(options.strategy, options.coarsest);
  session.document().set_options(options);
}

void strategy(Session& session, Arguments& arguments) {
  const std::string text = arguments.one_of({"paper", "quality"});
  arguments.end();
  DecimationOptions options = session.document().options();
  options.strategy = text == "paper" ? Strategy::Paper : Strategy::Quality;
  const double before = options.angle_deg;
  set_with_angle(session, options);
  if (const double now = session.document().options().angle_deg; now != before)
    session.status =
        "The angle limit is " + short_number(now) + " degrees now, as usual for " + text;
}

void regularity(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.regularity = arguments.number("a regularity", 0, 1);
  arguments.end();
  session.document().set_options(options);
}

void factor(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.factor = arguments.number("a factor", 1, 1e6);
  arguments.end();
  no_other_aim(options);
  set_with_angle(session, options);
}

void coarsest(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  const bool on = arguments.flag(options.coarsest);
  arguments.end();
  if (on) no_other_aim(options);
  options.coarsest = on;
  set_with_angle(session, options);
}

/// "25%" of what the present mesh had as loaded, at least one.
std::uint32_t share_of_cells(const Session& session, const std::string& text) {
  need_mesh(session);
  const double percent = Arguments("target-faces", "N|P%|off", text.substr(0, text.size() - 1))
                             .number("percent of the faces as loaded", 0, 100);
  const MeshFacts& facts = session.sheet().loaded_facts();
  const auto cells = static_cast<double>(facts.regions > 0 ? tetrahedra(facts) : facts.faces);
  return static_cast<std::uint32_t>(std::max(1.0, std::round(percent / 100 * cells)));
}

void target_faces(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("a number of faces, percent of them, or off");
  DecimationOptions options = session.document().options();
  if (text != "off") no_other_aim(options);
  if (text == "off")
    options.target_faces = 0;
  else if (text.ends_with('%'))
    options.target_faces = share_of_cells(session, text);
  else
    options.target_faces = static_cast<std::uint32_t>(
        Arguments("target-faces", "N|P%|off", text).integer("a number of faces", 1, largest_count));
  arguments.end();
  set_with_angle(session, options);
}

void spacing(Session& session, Arguments& arguments) {
  const std::string text = arguments.rest("a file, a formula, curvature, surface or off");
  DecimationOptions options = session.document().options();
  if (text == "off") {
    options.spacing.reset();
    session.document().set_options(options);
    return;
  }
  need_decimable(session);
  session.play(false);
  try {
    session.document().set_spacing(expanded(text).string());
  } catch (const std::invalid_argument& error) {
    throw CommandError(error.what());
  }
  no_other_aim(options);
  options.spacing = session.document().options().spacing;
  set_with_angle(session, options);
}

}  // namespace

std::vector<Command> aim_commands() {
  return {
      {"strategy",
       "paper|quality",
       "paper is the loop as printed; quality collapses what costs least first, places the vertex "
       "that "
       "stays, then fits the mesh to the original. paper at first.",
       CommandGroup::Options,
       strategy,
       {}},
      {"regularity",
       "W",
       "For quality: 0 accuracy first to 1 regular faces first; 0.5 at first.",
       CommandGroup::Options,
       regularity,
       {}},
      {"factor",
       "F",
       "How many times longer edges become where the angle does not bind; 1 and up, 4 at first. "
       "Ends other "
       "aims: coarsest, target-faces, spacing.",
       CommandGroup::Options,
       factor,
       {}},
      {"coarsest",
       "[on|off]",
       "No limit on length. Ends other aims; without it the factor holds again.",
       CommandGroup::Options,
       coarsest,
       {}},
      {"target-faces",
       "N|P%|off",
       "Goes down to this many faces, of a volume tetrahedra, or to so many percent of those as "
       "loaded, or as far as the limits let it. Ends "
       "other aims.",
       CommandGroup::Options,
       target_faces,
       {}},
      {"spacing",
       "FILE|EXPR|curvature|surface|off",
       "How long edges become, in the units of the mesh as loaded: a file with a number for each "
       "vertex; "
       "curvature: longer where it is flatter; surface: of a volume, factor times what they are on "
       "model faces, growing inside; or a formula of x, y, z, h (mean length of the "
       "edges there), "
       "k (curvature) and diag (diagonal of the box). Ends other aims; another mesh drops it.",
       CommandGroup::Options,
       spacing,
       {}},
  };
}

}  // namespace aomd::scene
