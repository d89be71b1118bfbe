#include "viewer/ui/dialogs.h"

#include <algorithm>
#include <string>

#include "viewer/commands/arguments.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/line_help.h"
#include "viewer/ui/lessons_dialog.h"
#include "viewer/ui/widgets.h"
#include "viewer/ui/work_dialogs.h"

namespace aomd::ui {
namespace {

using scene::Dialog;

std::string stem_of(const scene::Session& session) {
  if (session.document().empty()) return "mesh";
  return std::filesystem::path(session.document().content().name).stem().string();
}

std::string suggested_name(const scene::Session& session) {
  const bool volume = !session.document().empty() && session.document().content().volume();
  return stem_of(session) + (volume ? "-copy.msh" : "-decimated.ply");
}

BrowserPurpose purpose_of(Dialog dialog, const scene::Session& session, PictureChoices& picture) {
  const std::vector<std::string> meshes = {".obj", ".off",  ".ply",   ".stl", ".gltf", ".glb",
                                           ".msh", ".mesh", ".meshb", ".vtk", ".vtu",  ".su2"};
  switch (dialog) {
    case Dialog::Save:
      return {"Save the mesh", "Save", meshes, false, suggested_name(session)};
    case Dialog::Screenshot:
      return {"Save a picture",
              "Save",
              {".png"},
              false,
              stem_of(session) + ".png",
              [&](Frame& frame) { picture_choices(frame, picture); },
              PictureChoices::rows,
              picture_problem(picture)};
    default:
      return {"Open a mesh", "Open", meshes};
  }
}

const char* title_of(Dialog dialog) {
  switch (dialog) {
    case Dialog::Open:
      return "Open a mesh";
    case Dialog::Save:
      return "Save the mesh as";
    case Dialog::Screenshot:
      return "Save a picture";
    case Dialog::Shortcuts:
      return "Keyboard and mouse";
    case Dialog::Palette:
      return "Commands";
    case Dialog::Unsaved:
      return "Unsaved changes";
    case Dialog::Recovery:
      return "Recover unsaved work";
    case Dialog::Lessons:
      return "Lessons";
    default:
      return "About AOMD Studio";
  }
}

std::string line_for(Dialog dialog, const std::filesystem::path& file) {
  const char* command = dialog == Dialog::Open   ? "open"
                        : dialog == Dialog::Save ? "save"
                                                 : "screenshot";
  return std::string(command) + " " + scene::in_quotes(file.string());
}

void draw_browser(Frame& frame, DialogState& state, bool appearing) {
  const Dialog dialog = frame.session.view.dialog;
  FileBrowser& browser = dialog == Dialog::Screenshot ? state.pictures : state.meshes;
  const BrowserPurpose purpose = purpose_of(dialog, frame.session, state.picture);
  if (appearing) browser.begin(purpose);
  const auto file = browser.draw(frame, purpose);
  if (!file) return;
  frame.emit(line_for(dialog, *file) +
             (dialog == Dialog::Screenshot ? picture_words(state.picture) : ""));
}

void shortcut_row(const Frame& frame, std::string_view keys, std::string_view what,
                  std::string_view line = {}) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(frame.fonts.mono);
  text(keys);
  ImGui::PopFont();
  ImGui::TableNextColumn();
  text(what);
  ImGui::PushFont(frame.fonts.small);
  if (!line.empty()) muted(frame, line);
  ImGui::PopFont();
}

void draw_mouse(const Frame& frame) {
  shortcut_row(frame, "Drag", "Turn");
  shortcut_row(frame, "Right or middle drag", "Shift the picture; also Shift + drag");
  shortcut_row(frame, "Wheel", "Nearer and farther, at the mouse");
  shortcut_row(frame, "Click", "Select; beside the mesh nothing");
  shortcut_row(frame, "Shift + click", "Add to the selection, or take away");
  shortcut_row(frame, "Ctrl + drag", "Select what can be seen in a box; with Shift add it");
  shortcut_row(frame, "Double click", "Nearer to what is there; beside the mesh show all of it");
  shortcut_row(frame, "Ctrl + click", "On a slider's field: type a value");
  shortcut_row(frame, "Drag a border",
               "Of a side panel: wider or narrower; double click: as at first");
}

void draw_keys(const Frame& frame) {
  for (const scene::Command& command : scene::commands())
    for (const scene::Shortcut& s : command.shortcuts)
      shortcut_row(frame, s.chord, scene::line_help(s.line), s.line);
}

void draw_shortcuts(const Frame& frame) {
  const float below = ImGui::GetFrameHeightWithSpacing() + 1.2f * em();
  const auto flags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("keys", 2, flags, {0, ImGui::GetContentRegionAvail().y - below})) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 11 * em());
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  ImGui::PushTextWrapPos(0);
  draw_mouse(frame);
  draw_keys(frame);
  ImGui::PopTextWrapPos();
  ImGui::EndTable();
}

void draw_about(const Frame& frame) {
  ImGui::PushTextWrapPos(0);
  text(
      "A mesh database whose stored adjacencies follow the algorithm, decimation on top of it, and "
      "a viewer "
      "in which "
      "every operation can be watched, reversed and replayed.");
  gap();
  muted(frame,
        "After B. K. Karamete, \"An Algorithm Oriented Mesh Database (AOMD) Application: "
        "Decimation\".");
  gap();
  muted(frame, "Version " AOMD_VERSION
               ". Everything in the menus is also a command: aomd-view --help lists them, and a "
               "script of them is a test.");
  ImGui::PopTextWrapPos();
}

void draw_content(Frame& frame, DialogState& state, bool appearing) {
  switch (frame.session.view.dialog) {
    case Dialog::Shortcuts:
      draw_shortcuts(frame);
      break;
    case Dialog::About:
      draw_about(frame);
      break;
    case Dialog::Recovery:
      recovery_dialog(frame);
      break;
    case Dialog::Lessons:
      lessons_dialog(frame);
      break;
    case Dialog::Unsaved:
      return unsaved_dialog(frame);
    case Dialog::Palette:
      if (appearing) state.palette.begin(frame);
      return state.palette.draw(frame);
    default:
      return draw_browser(frame, state, appearing);
  }
  gap(0.2f);
  const float width = 6 * em();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
  if (ImGui::Button("Close", {width, 0})) frame.emit("dialog none");
}

ImVec2 size_of(Dialog dialog) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 ems = dialog == Dialog::About      ? ImVec2(30, 15)
                     : dialog == Dialog::Unsaved  ? ImVec2(27, 10)
                     : dialog == Dialog::Recovery ? ImVec2(36, 18)
                     : dialog == Dialog::Lessons  ? ImVec2(42, 53)
                     : dialog == Dialog::Palette  ? ImVec2(42, 27)
                                                  : ImVec2(44, 34);
  return {std::min(ems.x * em(), display.x - 2 * em()),
          std::min(ems.y * em(), display.y - 2 * em())};
}

void draw_loading(Frame& frame) {
  if (frame.interactive) {
    const float angle = static_cast<float>(ImGui::GetTime()) * 5;
    const ImVec2 c = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PathArcTo({c.x + 0.5f * em(), c.y + 0.85f * em()}, 0.42f * em(), angle, angle + 4.4f, 20);
    list.PathStroke(ImGui::GetColorU32(frame.colors.accent), false, 0.15f * em());
    ImGui::Dummy({1.4f * em(), em()});
    ImGui::SameLine();
  }
  ImGui::AlignTextToFramePadding();
  text("Loading " + fitted(frame.session.loading_name(), 16 * em()) + " \u2026");
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) frame.emit("cancel");
}

void draw_error(Frame& frame) {
  const ImVec2 from = ImGui::GetWindowPos();
  const float height = ImGui::GetWindowHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(
      from, {from.x + 0.35f * em(), from.y + height}, ImGui::GetColorU32(frame.colors.bad),
      ImGui::GetStyle().WindowRounding, ImDrawFlags_RoundCornersLeft);
  ImGui::Indent(0.4f * em());
  ImGui::PushTextWrapPos(30 * em());
  text(frame.session.error);
  ImGui::PopTextWrapPos();
  if (frame.has_mesh()) muted(frame, "The present mesh is unchanged.");
  if (ImGui::Button("Dismiss")) frame.emit("dismiss");
  command_tooltip("dismiss");
  ImGui::Unindent(0.4f * em());
}

}  // namespace

void draw_dialogs(Frame& frame, DialogState& state) {
  const Dialog wanted = frame.session.view.dialog;
  const bool appearing = wanted != state.shown;
  state.shown = wanted;
  if (wanted == Dialog::None) return;
  const char* title = title_of(wanted);
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size_of(wanted));
  bool open = true;
  const auto flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoScrollbar;
  if (!ImGui::BeginPopupModal(title, &open, flags)) return;
  draw_content(frame, state, appearing);
  ImGui::EndPopup();
  if (!open) frame.emit("dialog none");
}

void draw_messages(Frame& frame, const Area& viewport) {
  const bool in_palette = frame.session.view.dialog == scene::Dialog::Palette;
  if (!frame.session.loading() && (frame.session.error.empty() || in_palette)) return;
  ImGui::SetNextWindowPos(
      {viewport.position.x + 0.5f * viewport.size.x, viewport.position.y + em()}, ImGuiCond_Always,
      {0.5f, 0});
  const auto flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##message", nullptr, flags)) {
    if (frame.session.loading()) draw_loading(frame);
    if (!frame.session.error.empty() && !in_palette) draw_error(frame);
  }
  ImGui::End();
}

}  // namespace aomd::ui
