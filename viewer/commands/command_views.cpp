// What is shown, and how.

#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void color(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, Coloring>, 8> choices = {
      {{"classification", Coloring::Classification},
       {"spacing", Coloring::Spacing},
       {"quality", Coloring::Quality},
       {"distance", Coloring::Distance},
       {"curvature", Coloring::Curvature},
       {"verdict", Coloring::Verdict},
       {"texture", Coloring::Texture},
       {"none", Coloring::None}}};
  session.view.coloring = arguments.choice(choices);
  arguments.end();
}

void show(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, bool View::*>, 15> choices = {
      {{"surface", &View::surface},
       {"hidden-lines", &View::hidden_lines},
       {"scale", &View::scale},
       {"length-scale", &View::length_scale},
       {"edges", &View::edges},
       {"model-edges", &View::model_edges},
       {"model-vertices", &View::model_vertices},
       {"interfaces", &View::interfaces},
       {"interior-edges", &View::interior_edges},
       {"original", &View::original},
       {"axes", &View::axes},
       {"light", &View::light},
       {"occlusion", &View::occlusion},
       {"ground", &View::ground},
       {"operation", &View::operation}}};
  bool& shown = session.view.*arguments.choice(choices);
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
  session.view.theme = arguments.choice(choices);
  arguments.end();
}

void panel(Session& session, Arguments& arguments) {
  enum class Which { Mesh, Decimation, Adjacency, Histograms, Selection, Timeline, Runs, All };
  constexpr std::array<std::pair<std::string_view, Which>, 8> choices = {
      {{"mesh", Which::Mesh},
       {"decimation", Which::Decimation},
       {"adjacency", Which::Adjacency},
       {"histograms", Which::Histograms},
       {"selection", Which::Selection},
       {"timeline", Which::Timeline},
       {"runs", Which::Runs},
       {"all", Which::All}}};
  Panels& panels = session.view.panels;
  const Which which = arguments.choice(choices);
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
  if (which == Which::Selection) turn_page(Page::Selection);
  if (which == Which::Histograms) turn_page(Page::Histograms);
  if (which == Which::Timeline) panels.timeline = arguments.flag(panels.timeline);
  if (which == Which::Runs) panels.runs = arguments.flag(panels.runs);
  if (which == Which::All) panels.mesh = panels.side = panels.timeline = arguments.flag(any);
  if (which == Which::All && !panels.mesh) panels.runs = false;
  arguments.end();
}

/// The next of these sizes, in percent.
double next_text_size(double present, bool larger) {
  constexpr std::array<double, 11> sizes = {50, 67, 80, 90, 100, 110, 125, 150, 200, 250, 300};
  constexpr double hair = 0.5;
  double next = present;
  for (const double size : sizes) {
    if (larger && size > present + hair) return size;
    if (!larger && size < present - hair) next = size;
  }
  return next;
}

void detail(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, Detail>, 3> choices = {
      {{"auto", Detail::Automatic}, {"full", Detail::Full}, {"coarse", Detail::Coarse}}};
  session.view.detail = arguments.choice(choices);
  arguments.end();
}

void light(Session& session, Arguments& arguments) {
  const std::string word = arguments.one_of({"follow", "stay", "toggle"});
  arguments.end();
  View& view = session.view;
  const bool stays = word == "stay" || (word == "toggle" && !view.light_from);
  if (stays)
    view.light_from = view.camera;
  else
    view.light_from.reset();
}

void text_size(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  const std::string word = again.word("percent, larger, smaller or usual");
  double percent = 100;
  if (word == "larger" || word == "smaller") {
    percent = next_text_size(100 * session.view.text_scale, word == "larger");
    arguments = again;
  } else if (word == "usual") {
    arguments = again;
  } else {
    percent = arguments.number("percent", 100 * least_text_scale, 100 * largest_text_scale);
  }
  arguments.end();
  session.view.text_scale = percent / 100;
  session.status = "Text at " + short_number(percent, 1) + " % of its usual size";
}

/// A lesson's page stays: that is what is presented.
void presentation(Session& session, Arguments& arguments) {
  View& view = session.view;
  const bool on = arguments.flag(view.presenting.has_value());
  arguments.end();
  if (on == view.presenting.has_value()) return;
  if (!on) {
    view.panels = *view.presenting;
    view.presenting.reset();
    return;
  }
  view.presenting = view.panels;
  view.panels.menus = view.panels.side = view.panels.timeline = view.panels.runs = false;
  view.panels.mesh = session.lesson.lesson() != nullptr;
}

void dialog(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, Dialog>, 9> choices = {
      {{"open", Dialog::Open},
       {"save", Dialog::Save},
       {"screenshot", Dialog::Screenshot},
       {"shortcuts", Dialog::Shortcuts},
       {"about", Dialog::About},
       {"unsaved", Dialog::Unsaved},
       {"recovery", Dialog::Recovery},
       {"lessons", Dialog::Lessons},
       {"none", Dialog::None}}};
  const Dialog wanted = arguments.choice(choices);
  arguments.end();
  if (session.view.dialog == Dialog::Palette) session.error.clear();  // it was shown there
  session.view.dialog = wanted;
  if (wanted == Dialog::Lessons) session.lesson.suggested = LessonPlayer::Hint::None;
  if (wanted != Dialog::Save) session.asked.clear();
}

void dismiss(Session& session, Arguments& arguments) {
  arguments.end();
  session.error.clear();
}

std::vector<Command> surface_commands() {
  return {
      {"color",
       "classification|spacing|quality|distance|curvature|verdict|texture|none",
       "What the surface's colours mean: what it lies on, how long decimation wants edges to be, "
       "the "
       "smallest angle of each face, its distance to the mesh as loaded, how strongly the surface "
       "bends, "
       "why each edge would be refused now, or the pictures and colours of its materials.",
       CommandGroup::View,
       color,
       {{"C", "color classification"}, {"N", "color none"}, {"Y", "color verdict"}}},
      {"show",
       "surface|hidden-lines|edges|model-edges|model-vertices|interfaces|interior-edges|original|"
       "axes|light|scale|length-scale|operation|occlusion|ground [on|off|toggle]",
       "interfaces are the faces between two model regions, seen where something is hidden; "
       "interior-edges "
       "are those inside a volume, whose surface turns to glass; original is the mesh as loaded "
       "(or what "
       "compare with says), as glass over the present one; axes is where x, y and z point; without "
       "light colours are as they are; without "
       "the surface edges show alone, and hidden-lines are those that it would hide; scale is that "
       "of the colours, length-scale says how long things are without perspective; "
       "operation is what "
       "the last single step "
       "touched; occlusion makes folds and cavities darker, ground is a grid below the mesh with "
       "its "
       "shadow, seen from above.",
       CommandGroup::View,
       show,
       {{"E", "show edges toggle"},
        {"B", "show model-edges toggle"},
        {"V", "show model-vertices toggle"},
        {"O", "show operation toggle"}}},
      {"highlight",
       "[vertex|edge|face|region:TAG]",
       "Brightens what lies on one model entity; none without a word.",
       CommandGroup::View,
       highlight,
       {}},
      {"hide",
       "[vertex|edge|face|region:TAG [on|off|toggle]]",
       "Hides what lies on one model entity; shows everything without a word. Behind a hidden "
       "region its "
       "neighbours show.",
       CommandGroup::View,
       hide,
       {{"H", "hide"}}},
  };
}

std::vector<Command> look_commands() {
  return {
      {"theme",
       "light|dark|toggle",
       "The colours of panels and background.",
       CommandGroup::View,
       theme,
       {{"T", "theme toggle"}}},
      {"light",
       "follow|stay|toggle",
       "Whether the light follows the camera, as at first, or stays where it is and the camera "
       "goes round.",
       CommandGroup::View,
       light,
       {}},
      {"detail",
       "auto|full|coarse",
       "How many faces are drawn of a surface that has very many. auto: all, but in a window about "
       "50,000 while the camera moves, where drawing all takes long; coarse: always so many.",
       CommandGroup::View,
       detail,
       {}},
      {"text-size",
       "PERCENT|larger|smaller|usual",
       "How large text and controls are, of what suits the screen: 50 to 300.",
       CommandGroup::View,
       text_size,
       {{"Ctrl+=", "text-size larger"},
        {"Ctrl++", "text-size larger"},
        {"Ctrl+-", "text-size smaller"},
        {"Ctrl+0", "text-size usual"}}},
      {"presentation",
       "[on|off|toggle]",
       "For who shows something to others: no menus and panels but for the page of a lesson, and "
       "text, lines and dots are larger. Keys work as ever, and those of panels open them.",
       CommandGroup::View,
       presentation,
       {{"F11", "presentation toggle"}}},
  };
}

std::vector<Command> panel_commands() {
  return {
      {"panel",
       "mesh|decimation|adjacency|histograms|selection|timeline|runs|all [on|off|toggle]",
       "Which panels are there; decimation, adjacency, histograms and selection share the one on "
       "the right. "
       "runs, the table of what runs came to, stands below the picture; all does not open it.",
       CommandGroup::View,
       panel,
       {{"Tab", "panel all toggle"},
        {"D", "panel decimation on"},
        {"A", "panel adjacency on"},
        {"G", "panel histograms on"},
        {"U", "panel runs toggle"},
        {"P", "panel selection on"}}},
      {"dialog",
       "open|save|screenshot|shortcuts|about|unsaved|recovery|lessons|none",
       "Opens one of the dialogs. unsaved asks what is to become of unsaved work; recovery lists "
       "what "
       "programs that died have left; lessons lists the lessons.",
       CommandGroup::View,
       dialog,
       {{"F1", "dialog shortcuts"}, {"F2", "dialog lessons"}}},
      {"dismiss", "", "Closes the message about an error.", CommandGroup::View, dismiss, {}},
  };
}

}  // namespace

std::vector<Command> view_commands() {
  std::vector<Command> all = surface_commands();
  for (std::vector<Command>& more : std::array{look_commands(), panel_commands()})
    std::move(more.begin(), more.end(), std::back_inserter(all));
  return all;
}

}  // namespace aomd::scene
