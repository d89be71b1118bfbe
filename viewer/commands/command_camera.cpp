// From where the mesh is seen.

#include <algorithm>
#include <string>

#include "viewer/commands/command_groups.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene {
namespace {

constexpr std::size_t longest_camera_text = 1000;  // whatever else the clipboard may hold

/// One of those before the last jumps. A key: where there was none a word is enough.
void recent_camera(Session& session, Arguments& arguments) {
  const auto count = static_cast<long long>(session.cameras_before().size());
  const long long number = arguments.done() || count == 0
                               ? 1
                               : arguments.integer("a number of a recent camera", 1, count);
  arguments.end();
  if (count == 0)
    session.status = "The camera has not jumped yet";
  else
    session.jump_back(static_cast<std::size_t>(number - 1));
}

void camera(Session& session, Arguments& arguments) {
  need_mesh(session);
  Arguments again = arguments;
  if (!again.done() && again.word("a view or its parameters") == "recent")
    return recent_camera(session, again);
  std::string text = arguments.rest("a view or its parameters");
  if (text == "copy") {
    session.clipboard.set(session.view.camera.to_text());
    session.status = "Copied the camera";
    return;
  }
  const bool pasted = text == "paste";
  if (pasted) text = session.clipboard.get().substr(0, longest_camera_text);
  const CameraSpec spec = parse_camera(text, session.view.camera,
                                       session.document().content().bounds, session.view.aspect);
  if (!spec.camera && pasted) throw CommandError("the clipboard holds no camera: " + spec.error);
  if (!spec.camera) arguments.fail(spec.error);
  session.note_jump();
  session.view.camera = *spec.camera;
  if (pasted) session.status = "Pasted the camera";
}

/// The middle of entities, so near that what is around them shows with `context` times as much.
void look_at(Session& session, std::span<const EntityRef> entities,
             std::span<const EntityRef> around, double context) {
  const Mesh& mesh = session.document().mesh();
  Camera& camera = session.view.camera;
  const double far = camera.distance;
  camera.fit(box_of(mesh, around), session.view.aspect);
  camera.target = box_of(mesh, entities).center();
  camera.distance = std::min(far, context * camera.distance);
}

/// Entities with what is around them, which matters as much.
void fit_entities(Session& session, std::span<const EntityRef> entities) {
  constexpr double context = 5, around_vertex = 2.5;
  if (entities.empty())
    return session.view.camera.fit(session.document().content().bounds, session.view.aspect);
  if (entities.size() > 1 || entities[0].dimension != 0)
    return look_at(session, entities, entities, context);
  Selection one;
  one.replace({entities[0]});
  look_at(session, entities, grown(session.document().mesh(), one), around_vertex);
}

void fit_selection(Session& session) {
  constexpr double around_ring = 1.4;
  const auto selected = session.sheet().selection.entities();
  if (const Neighbours* lit = session.sheet().inquiry().neighbours(); lit && !lit->entities.empty())
    return look_at(session, selected, lit->entities, around_ring);
  fit_entities(session, selected);
}

/// All that lies on a model entity, large in the picture.
void fit_model_entity(Session& session, Arguments& arguments) {
  constexpr double margin = 1.25;
  const ModelRef ref = arguments.model_entity();
  arguments.end();
  const Mesh& mesh = session.document().mesh();
  std::vector<EntityRef> entities;
  for (const std::uint32_t id : mesh.class_lists()->entities(ref.dimension(), ref))
    entities.emplace_back(ref.dimension(), id);
  if (entities.empty()) arguments.fail("nothing lies on " + model_entity_text(ref));
  if (ref.dimension() == 0) return fit_entities(session, entities);
  session.view.camera.fit(box_of(mesh, entities), session.view.aspect);
  session.view.camera.distance *= margin;
}

void fit(Session& session, Arguments& arguments) {
  need_mesh(session);
  session.note_jump();
  if (arguments.done())
    return session.view.camera.fit(session.document().content().bounds, session.view.aspect);
  Arguments ahead = arguments;
  const std::string word = ahead.word("selection or an entity");
  if (word.find(':') != std::string::npos) return fit_model_entity(session, arguments);
  if (word != "selection") return fit_entities(session, listed_entities(session, arguments));
  ahead.end();
  fit_selection(session);
}

void orbit(Session& session, Arguments& arguments) {
  const double azimuth = arguments.number("degrees to the right");
  const double elevation = arguments.number("degrees upward");
  arguments.end();
  session.view.camera.orbit(azimuth, elevation);
}

void pan(Session& session, Arguments& arguments) {
  const double x = arguments.number("a shift to the right");
  const double y = arguments.number("a shift upward");
  arguments.end();
  session.view.camera.pan({0, 0}, {2 * x, 2 * y}, session.view.aspect);
}

void zoom(Session& session, Arguments& arguments) {
  const double factor = arguments.number("a factor", 1e-6, 1e6);
  glm::dvec2 at{0, 0};
  if (!arguments.done()) {
    at.x = arguments.number("a place from left (-1) to right (1)", -1, 1);
    at.y = arguments.number("a place from bottom (-1) to top (1)", -1, 1);
  }
  arguments.end();
  session.view.camera.zoom(1 / factor, at, session.view.aspect);
}

}  // namespace

std::vector<Command> camera_commands() {
  return {
      {"camera",
       "VIEW|SPEC|copy|paste|recent [N]",
       "iso, front, back, left, right, top, bottom; or azimuth=DEG elevation=DEG distance=L "
       "target=X,Y,Z "
       "zoom=F fov=DEG up=y|z perspective orthographic fit. copy and paste: the present one as "
       "such a text, "
       "through the clipboard. recent: back to where the camera stood before its last jump, or "
       "before the Nth last.",
       CommandGroup::View,
       camera,
       {{"1", "camera front"},
        {"2", "camera right"},
        {"3", "camera back"},
        {"4", "camera left"},
        {"5", "camera top"},
        {"6", "camera bottom"},
        {"7", "camera iso"},
        {"Backspace", "camera recent"},
        {"Ctrl+Shift+C", "camera copy"},
        {"Ctrl+Shift+V", "camera paste"}}},
      {"fit",
       "[selection | KIND:TAG | KIND ID [ID...]]",
       "Shows the whole mesh from the present direction, all that lies on a model entity, or what "
       "is "
       "selected or named with its surroundings.",
       CommandGroup::View,
       fit,
       {{"F", "fit"}, {"Shift+F", "fit selection"}}},
      {"orbit",
       "X Y",
       "Turns the camera to the right and upward, degrees.",
       CommandGroup::View,
       orbit,
       {}},
      {"pan",
       "X Y",
       "Shifts the picture to the right and upward, as parts of its width and height.",
       CommandGroup::View,
       pan,
       {}},
      {"zoom",
       "F [X Y]",
       "Shows things F times larger, around a place in -1..1 that stays.",
       CommandGroup::View,
       zoom,
       {{"+", "zoom 1.25"}, {"=", "zoom 1.25"}, {"-", "zoom 0.8"}}},
  };
}

}  // namespace aomd::scene
