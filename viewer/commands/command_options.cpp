// What limits each operation of a decimation, and what goes with it.

#include <string>

#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void angle(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.angle_deg = arguments.number("an angle in degrees", 0, 180);
  arguments.end();
  session.document().set_options(options);
}

void min_angle(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.min_angle_deg = arguments.number("an angle in degrees", 0, 60);
  arguments.end();
  session.document().set_options(options);
}

void min_dihedral(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.min_dihedral_deg = arguments.number("an angle in degrees", 0, 70);
  arguments.end();
  session.document().set_options(options);
}

/// In units of the mesh from here on: those of the mesh that is there.
void max_distance(Session& session, Arguments& arguments) {
  need_mesh(session);
  DecimationOptions options = session.document().options();
  const double percent = arguments.number("percent of the diagonal", 0, 100);
  arguments.end();
  options.max_distance = percent / 100 * session.document().content().bounds.diagonal();
  session.document().set_options(options);
}

void no_intersections(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.no_intersections = arguments.flag(options.no_intersections);
  arguments.end();
  session.document().set_options(options);
}

void volume(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.keep_volumes = arguments.one_of({"keep", "free"}) == "keep";
  arguments.end();
  session.document().set_options(options);
}

void feature_angle(Session& session, Arguments& arguments) {
  ClassifyOptions options = session.document().classify_options();
  const std::string text = arguments.word("an angle in degrees, or off");
  if (text == "off")
    options.feature_angle_deg.reset();
  else
    options.feature_angle_deg =
        Arguments("feature-angle", "DEG|off", text).number("an angle in degrees", 0, 180);
  arguments.end();
  // Of a volume all faces between regions would have to be there: no history can bring them.
  const bool volume = !session.document().empty() && session.document().content().volume();
  if (volume && !session.document().mesh().complete(2))
    throw CommandError(
        "this mesh of regions has the model faces and edges that its file says: 'aomd classify "
        "IN OUT --replace --angle DEG' derives others");
  session.play(false);
  session.sheet().point_out({});
  session.document().end_trial();
  session.document().reclassify(options);
}

void topology(Session& session, Arguments& arguments) {
  const std::string text = arguments.one_of({"safe", "paper"});
  arguments.end();
  if (text == "paper" && !session.document().empty() && session.document().content().volume())
    throw CommandError("tetrahedra always keep the topology: topology paper is for surfaces");
  DecimationOptions options = session.document().options();
  options.topology = text == "paper" ? TopologyRule::Paper : TopologyRule::Safe;
  session.document().set_options(options);
  // The paper's loop knows no rule for edges with more than two faces.
  ClassifyOptions classify = session.document().classify_options();
  classify.nonmanifold_edges = options.topology == TopologyRule::Safe;
  const bool differs =
      classify.nonmanifold_edges != session.document().classify_options().nonmanifold_edges;
  if (differs && !session.document().empty() && session.sheet().facts().nonmanifold > 0)
    session.document().reclassify(classify);
  else
    session.document().set_classify_options(classify);
}

void improve_passes(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document().options();
  options.improve_passes = static_cast<int>(arguments.integer("a number of passes", 0, 1000));
  arguments.end();
  session.document().set_options(options);
}

void snap(Session& session, Arguments& arguments) {
  const std::string text = arguments.one_of({"none", "model"});
  arguments.end();
  session.document().set_snapping(text == "model");
}

}  // namespace

std::vector<Command> option_commands() {
  return {
      {"angle",
       "DEG",
       "How far a face's normal may turn in one operation, degrees. 10 at first; while it is not "
       "changed, 60 "
       "for quality unless coarsest.",
       CommandGroup::Options,
       angle,
       {}},
      {"min-angle",
       "DEG",
       "No collapse gives a face a smaller angle, degrees, unless it had one; 0 at first.",
       CommandGroup::Options,
       min_angle,
       {}},
      {"min-dihedral",
       "DEG",
       "Of tetrahedra: none gets an angle between two faces below it, degrees, unless one as bad "
       "was around it; 0 at first.",
       CommandGroup::Options,
       min_dihedral,
       {}},
      {"max-distance",
       "PCT",
       "No operation takes the surface farther than this from the mesh as loaded, percent of the "
       "diagonal of "
       "its box; 0, as at first, is no limit. Runs take several times as long.",
       CommandGroup::Options,
       max_distance,
       {}},
      {"no-intersections",
       "[on|off|toggle]",
       "No operation makes faces cut each other that did not. Runs take several times as long.",
       CommandGroup::Options,
       no_intersections,
       {}},
      {"volume",
       "keep|free",
       "For quality on tetrahedra. keep, as at first: no model region changes by more than 0.1 % "
       "of "
       "its volume; free: none of that is asked.",
       CommandGroup::Options,
       volume,
       {}},
      {"feature-angle",
       "DEG|off",
       "Derives the classification anew: edges past this angle become model edges. What the file "
       "says still "
       "wins; what was edited by hand is lost until undo.",
       CommandGroup::Options,
       feature_angle,
       {}},
      {"topology",
       "safe|paper",
       "safe keeps the topology (link condition); paper leaves that check out, and edges with more "
       "than two "
       "faces are not model edges.",
       CommandGroup::Options,
       topology,
       {}},
      {"improve-passes",
       "N",
       "For paper: how many sweeps are followed by swaps and smoothing.",
       CommandGroup::Options,
       improve_passes,
       {}},
      {"snap",
       "none|model",
       "model: smoothing puts vertices back onto the model, or onto the facets of the mesh as "
       "opened where "
       "none is given. none at first.",
       CommandGroup::Options,
       snap,
       {}},
  };
}

}  // namespace aomd::scene
