#include <array>
#include <string>

#include "viewer/scene/command_handlers.h"

namespace aomd::scene::handle {
namespace {

template <typename T, std::size_t N>
T choose(Arguments& arguments, const std::array<std::pair<std::string_view, T>, N>& choices) {
  std::string names;
  for (const auto& choice : choices) names += (names.empty() ? "" : ", ") + std::string(choice.first);
  const std::string text = arguments.word("one of " + names);
  for (const auto& [name, value] : choices)
    if (text == name) return value;
  arguments.fail("'" + text + "' is none of " + names);
}

}  // namespace

void color(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, Coloring>, 3> choices = {
      {{"classification", Coloring::Classification},
       {"spacing", Coloring::Spacing},
       {"none", Coloring::None}}};
  session.view.coloring = choose(arguments, choices);
  arguments.end();
}

void camera(Session& session, Arguments& arguments) {
  need_mesh(session);
  const std::string text = arguments.rest("a view or its parameters");
  const CameraSpec spec =
      parse_camera(text, session.view.camera, session.document.content().bounds, session.view.aspect);
  if (!spec.camera) arguments.fail(spec.error);
  session.view.camera = *spec.camera;
}

void fit(Session& session, Arguments& arguments) {
  arguments.end();
  need_mesh(session);
  session.view.camera.fit(session.document.content().bounds, session.view.aspect);
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

void show(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, bool View::*>, 6> choices = {
      {{"surface", &View::surface},
       {"edges", &View::edges},
       {"model-edges", &View::model_edges},
       {"model-vertices", &View::model_vertices},
       {"interfaces", &View::interfaces},
       {"operation", &View::operation}}};
  bool& shown = session.view.*choose(arguments, choices);
  shown = arguments.flag(shown);
  arguments.end();
}

void highlight(Session& session, Arguments& arguments) {
  if (arguments.done()) {
    session.view.highlighted.reset();
    return;
  }
  const ModelRef ref = arguments.model_entity();
  arguments.end();
  session.view.highlighted = ref;
}

void hide(Session& session, Arguments& arguments) {
  if (arguments.done()) {
    session.view.hidden.clear();
    return;
  }
  const ModelRef ref = arguments.model_entity();
  const bool off = arguments.done() || arguments.flag(session.view.hidden.contains(ref));
  arguments.end();
  if (off)
    session.view.hidden.insert(ref);
  else
    session.view.hidden.erase(ref);
}

void theme(Session& session, Arguments& arguments) {
  const Theme other = session.view.theme == Theme::Light ? Theme::Dark : Theme::Light;
  const std::array<std::pair<std::string_view, Theme>, 3> choices = {
      {{"light", Theme::Light}, {"dark", Theme::Dark}, {"toggle", other}}};
  session.view.theme = choose(arguments, choices);
  arguments.end();
}

void panel(Session& session, Arguments& arguments) {
  enum class Which { Mesh, Decimation, Adjacency, Timeline, All };
  constexpr std::array<std::pair<std::string_view, Which>, 5> choices = {{{"mesh", Which::Mesh},
                                                                          {"decimation", Which::Decimation},
                                                                          {"adjacency", Which::Adjacency},
                                                                          {"timeline", Which::Timeline},
                                                                          {"all", Which::All}}};
  Panels& panels = session.view.panels;
  const Which which = choose(arguments, choices);
  const bool any = panels.mesh || panels.side || panels.timeline;
  const auto turn_page = [&](Page page) {
    const bool up = panels.side && panels.page == page;
    const bool on = arguments.flag(up);
    if (on) panels.page = page;
    panels.side = on || (panels.side && !up);
  };
  if (which == Which::Mesh) panels.mesh = arguments.flag(panels.mesh);
  if (which == Which::Decimation) turn_page(Page::Decimation);
  if (which == Which::Adjacency) turn_page(Page::Adjacency);
  if (which == Which::Timeline) panels.timeline = arguments.flag(panels.timeline);
  if (which == Which::All) panels.mesh = panels.side = panels.timeline = arguments.flag(any);
  arguments.end();
}

void dialog(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, Dialog>, 6> choices = {{{"open", Dialog::Open},
                                                                           {"save", Dialog::Save},
                                                                           {"screenshot", Dialog::Screenshot},
                                                                           {"shortcuts", Dialog::Shortcuts},
                                                                           {"about", Dialog::About},
                                                                           {"none", Dialog::None}}};
  session.view.dialog = choose(arguments, choices);
  arguments.end();
}

void dismiss(Session& session, Arguments& arguments) {
  arguments.end();
  session.error.clear();
}

}  // namespace aomd::scene::handle
