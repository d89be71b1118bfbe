// What a decimation is told.

#include <stdexcept>
#include <string>

#include "viewer/scene/command_handlers.h"

namespace aomd::scene::handle {
namespace {

constexpr double largest_count = 1e9;

/// A length factor, no limit, a number of faces and a spacing exclude each other.
void no_other_aim(DecimationOptions& options) {
  options.coarsest = false;
  options.target_faces = 0;
  options.spacing.reset();
}

/// Sets a strategy or an aim. An angle that is the usual one follows.
void set_with_angle(Session& session, DecimationOptions options) {
  const DecimationOptions& before = session.document.options();
  if (before.angle_deg == usual_angle_deg(before.strategy, before.coarsest))
    options.angle_deg = usual_angle_deg(options.strategy, options.coarsest);
  session.document.set_options(options);
}

}  // namespace

void factor(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  options.factor = arguments.number("a factor", 1, 1e6);
  arguments.end();
  no_other_aim(options);
  set_with_angle(session, options);
}

void angle(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  options.angle_deg = arguments.number("an angle in degrees", 0, 180);
  arguments.end();
  session.document.set_options(options);
}

void coarsest(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  const bool on = arguments.flag(options.coarsest);
  arguments.end();
  if (on) no_other_aim(options);
  options.coarsest = on;
  set_with_angle(session, options);
}

void target_faces(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("a number of faces, or off");
  DecimationOptions options = session.document.options();
  if (text != "off") no_other_aim(options);
  options.target_faces =
      text == "off"
          ? 0
          : static_cast<std::uint32_t>(
                Arguments("target-faces", "N|off", text).number("a number of faces", 1, largest_count));
  arguments.end();
  set_with_angle(session, options);
}

void spacing(Session& session, Arguments& arguments) {
  const std::string text = arguments.rest("a file, a formula, curvature or off");
  DecimationOptions options = session.document.options();
  if (text == "off") {
    options.spacing.reset();
    session.document.set_options(options);
    return;
  }
  need_decimable(session);
  session.play(false);
  try {
    session.document.set_spacing(expanded(text).string());
  } catch (const std::invalid_argument& error) {
    throw CommandError(error.what());
  }
  no_other_aim(options);
  options.spacing = session.document.options().spacing;
  set_with_angle(session, options);
}

void strategy(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("paper or quality");
  arguments.end();
  if (text != "paper" && text != "quality") arguments.fail("'" + text + "' is neither paper nor quality");
  DecimationOptions options = session.document.options();
  options.strategy = text == "paper" ? Strategy::Paper : Strategy::Quality;
  set_with_angle(session, options);
}

void regularity(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  options.regularity = arguments.number("a regularity", 0, 1);
  arguments.end();
  session.document.set_options(options);
}

void min_angle(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  options.min_angle_deg = arguments.number("an angle in degrees", 0, 60);
  arguments.end();
  session.document.set_options(options);
}

void feature_angle(Session& session, Arguments& arguments) {
  ClassifyOptions options = session.document.classify_options();
  const std::string text = arguments.word("an angle in degrees, or off");
  if (text == "off")
    options.feature_angle_deg.reset();
  else
    options.feature_angle_deg =
        Arguments("feature-angle", "DEG|off", text).number("an angle in degrees", 0, 180);
  arguments.end();
  session.play(false);
  session.document.reclassify(options);
}

void topology(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("safe or paper");
  arguments.end();
  if (text != "safe" && text != "paper") arguments.fail("'" + text + "' is neither safe nor paper");
  DecimationOptions options = session.document.options();
  options.topology = text == "paper" ? TopologyRule::Paper : TopologyRule::Safe;
  session.document.set_options(options);
  // The paper's loop knows no rule for edges with more than two faces.
  ClassifyOptions classify = session.document.classify_options();
  classify.nonmanifold_edges = options.topology == TopologyRule::Safe;
  const bool differs = classify.nonmanifold_edges != session.document.classify_options().nonmanifold_edges;
  if (differs && !session.document.empty() && session.facts().nonmanifold > 0)
    session.document.reclassify(classify);
  else
    session.document.set_classify_options(classify);
}

void improve_passes(Session& session, Arguments& arguments) {
  DecimationOptions options = session.document.options();
  options.improve_passes = static_cast<int>(arguments.number("a number of passes", 0, 1000));
  arguments.end();
  session.document.set_options(options);
}

void snap(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("none or model");
  arguments.end();
  if (text != "none" && text != "model") arguments.fail("'" + text + "' is neither none nor model");
  session.document.set_snapping(text == "model");
}

}  // namespace aomd::scene::handle
