#include "viewer/ui/menu_bar.h"

#include <string>

#include <imgui_internal.h>  // ClosePopupToLevel

#include "core/samples/samples.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

void recent_menu(Frame& frame, const RecentFiles& recent) {
  if (!ImGui::BeginMenu("Recent files", !recent.paths().empty())) return;
  for (const std::filesystem::path& path : recent.paths()) {
    if (ImGui::MenuItem((path.filename().string() + "##" + path.string()).c_str()))
      frame.emit("open " + scene::in_quotes(path.string()));
    tooltip(path.string());
  }
  ImGui::EndMenu();
}

void samples_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Samples")) return;
  for (const SampleInfo& sample : samples()) {
    command_item(frame, std::string(sample.name).c_str(), "sample " + std::string(sample.name));
    tooltip(sample.description);
  }
  ImGui::EndMenu();
}

/// Where to and how many is asked for in the palette, which has the whole line ready.
void export_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Export pictures", frame.has_mesh())) return;
  command_item(frame, "Of a turn\u2026", "palette export turntable ~/turntable 60");
  command_item(frame, "Of the history\u2026", "palette export history ~/history 60", false,
               frame.document().journal().size() > 0);
  ImGui::EndMenu();
}

void copy_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Copy as text", frame.has_mesh())) return;
  command_item(frame, "Counts", "copy counts");
  command_item(frame, "Classification", "copy legend");
  command_item(frame, "Adjacencies", "copy adjacency");
  command_item(frame, "Refusals of the last sweep", "copy refusals");
  command_item(frame, "All sweeps", "copy sweeps");
  command_item(frame, "Runs", "copy runs");
  ImGui::EndMenu();
}

void file_menu(Frame& frame, const RecentFiles& recent) {
  if (!ImGui::BeginMenu("File")) return;
  command_item(frame, "Open\u2026", "dialog open");
  recent_menu(frame, recent);
  samples_menu(frame);
  ImGui::Separator();
  const bool from_file = frame.has_mesh() && !frame.document().content().file.empty();
  command_item(frame, "Reload", "reload", false, from_file);
  command_item(frame, "Watch the file", "watch toggle", frame.session.watching(), from_file);
  ImGui::Separator();
  command_item(frame, "Save as\u2026", "dialog save", false, frame.has_mesh());
  command_item(frame, "Screenshot\u2026", "dialog screenshot");
  export_menu(frame);
  ImGui::Separator();
  if (!frame.session.found_work.works.empty()) {
    command_item(frame, "Recover unsaved work\u2026", "dialog recovery");
    ImGui::Separator();
  }
  command_item(frame, "Quit", "quit");
  ImGui::EndMenu();
}

void edit_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Edit")) return;
  command_item(frame, "Undo", "undo", false, frame.document().can_undo());
  command_item(frame, "Redo", "redo", false, frame.document().can_redo());
  command_item(frame, "Reset", "reset", false, frame.document().can_undo());
  ImGui::Separator();
  copy_menu(frame);
  ImGui::Separator();
  command_item(frame, "Step", "step", false, frame.can_decimate());
  command_item(frame, "Step back", "step -1", false, frame.document().can_undo());
  command_item(frame, "Sweep", "sweep", false, frame.can_decimate());
  command_item(frame, "Swap", "swap", false, frame.can_decimate());
  command_item(frame, "Smooth", "smooth", false, frame.can_decimate());
  command_item(frame, "Improve", "improve", false, frame.can_decimate());
  ImGui::Separator();
  command_item(frame, "Select nothing", "select none", false,
               !frame.session.sheet().selection.empty());
  command_item(frame, "Grow selection", "select grow", false,
               !frame.session.sheet().selection.empty());
  ImGui::Separator();
  command_item(frame, "Run", "run", false, frame.can_decimate());
  command_item(frame, "Cancel", "cancel", false, !frame.session.idle());
  ImGui::EndMenu();
}

/// "45° round, 30° up, at 2.4"
std::string camera_words(const scene::Camera& camera) {
  const auto degrees = [](double value) { return scene::short_number(value, 0) + "\u00b0"; };
  return degrees(camera.azimuth_deg) + " round, " + degrees(camera.elevation_deg) + " up, at " +
         scene::significant(camera.distance) + (camera.orthographic ? ", orthographic" : "");
}

void recent_cameras(Frame& frame) {
  const auto& cameras = frame.session.cameras_before();
  if (!ImGui::BeginMenu("Before the last jumps", !cameras.empty())) return;
  for (std::size_t i = 0; i < cameras.size(); ++i)
    command_item(frame, (camera_words(cameras[i]) + "##" + std::to_string(i)).c_str(),
                 i == 0 ? "camera recent" : "camera recent " + std::to_string(i + 1));
  ImGui::EndMenu();
}

void camera_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Camera", frame.has_mesh())) return;
  for (const char* name : {"Iso", "Front", "Back", "Left", "Right", "Top", "Bottom"}) {
    std::string line = std::string("camera ") + name;
    line[7] = static_cast<char>(line[7] - 'A' + 'a');
    command_item(frame, name, line);
  }
  ImGui::Separator();
  const scene::Camera& camera = frame.session.view.camera;
  command_item(frame, "Orthographic",
               camera.orthographic ? "camera perspective" : "camera orthographic",
               camera.orthographic);
  const bool z_up = camera.up_axis == scene::UpAxis::Z;
  command_item(frame, "Z is up", z_up ? "camera up=y" : "camera up=z", z_up);
  ImGui::Separator();
  command_item(frame, "Copy", "camera copy");
  command_item(frame, "Paste", "camera paste");
  recent_cameras(frame);
  ImGui::EndMenu();
}

void color_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Colours")) return;
  const scene::Coloring present = frame.session.view.coloring;
  const auto item = [&](const char* name, const char* line, scene::Coloring coloring,
                        bool enabled = true) {
    command_item(frame, name, line, present == coloring, enabled);
  };
  item("Classification", "color classification", scene::Coloring::Classification);
  item("Spacing", "color spacing", scene::Coloring::Spacing, frame.can_decimate());
  item("Smallest angle", "color quality", scene::Coloring::Quality);
  item("Distance to the original", "color distance", scene::Coloring::Distance,
       frame.can_decimate());
  item("Curvature", "color curvature", scene::Coloring::Curvature);
  item("Verdict on each edge", "color verdict", scene::Coloring::Verdict, frame.can_decimate());
  const bool looks = frame.has_mesh() && scene::has_looks(frame.document().content().appearance);
  item("Texture", "color texture", scene::Coloring::Texture, looks);
  item("One colour", "color none", scene::Coloring::None);
  ImGui::EndMenu();
}

void clip_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Clip and shrink", frame.has_mesh())) return;
  const scene::View& view = frame.session.view;
  for (const char* axis : {"x", "y", "z"})
    command_item(frame, (std::string("Across ") + axis).c_str(),
                 std::string("clip ") + axis + " 0.5");
  command_item(frame, "Whole cells across x", "clip x 0.5 cells");
  command_item(frame, "No clipping", "clip off", false, view.clip.has_value());
  ImGui::Separator();
  command_item(frame, "Shrunken cells", view.shrink > 0 ? "shrink 0" : "shrink 0.3",
               view.shrink > 0);
  ImGui::EndMenu();
}

void light_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Light and detail")) return;
  const scene::View& view = frame.session.view;
  command_item(frame, "Shaded surface", "show light toggle", view.light);
  command_item(frame, "Darker folds", "show occlusion toggle", view.occlusion);
  command_item(frame, "Ground and shadow", "show ground toggle", view.ground);
  command_item(frame, "Light stays", "light toggle", view.light_from.has_value());
  ImGui::Separator();
  using scene::Detail;
  command_item(frame, "Fewer faces while turning", "detail auto", view.detail == Detail::Automatic);
  command_item(frame, "Always all faces", "detail full", view.detail == Detail::Full);
  command_item(frame, "Always fewer faces", "detail coarse", view.detail == Detail::Coarse);
  ImGui::EndMenu();
}

void operation_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Last operation")) return;
  const scene::View& view = frame.session.view;
  const scene::StepSides sides = view.step_sides;
  command_item(frame, "Shown", "show operation toggle", view.operation);
  ImGui::Separator();
  command_item(frame, "What was there before", "operation before", !sides.after, view.operation);
  command_item(frame, "What is there after", "operation after", !sides.before, view.operation);
  command_item(frame, "Both", "operation both", sides.before && sides.after, view.operation);
  ImGui::EndMenu();
}

void text_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Size of text")) return;
  const double scale = frame.session.view.text_scale;
  command_item(frame, "Larger", "text-size larger", false, scale < scene::largest_text_scale);
  command_item(frame, "Smaller", "text-size smaller", false, scale > scene::least_text_scale);
  command_item(frame, "As at first", "text-size usual", scale == 1);
  ImGui::EndMenu();
}

void surface_items(Frame& frame) {
  const scene::View& view = frame.session.view;
  command_item(frame, "Surface", "show surface toggle", view.surface);
  command_item(frame, "    Edges that it hides", "show hidden-lines toggle", view.hidden_lines,
               !view.surface);
  command_item(frame, "Edges", "show edges toggle", view.edges);
  command_item(frame, "Model edges", "show model-edges toggle", view.model_edges);
  command_item(frame, "Model vertices", "show model-vertices toggle", view.model_vertices);
}

void inside_menu(Frame& frame) {
  const bool volume = frame.has_mesh() && frame.document().content().volume();
  if (!ImGui::BeginMenu("Inside of a volume", volume)) return;
  const scene::View& view = frame.session.view;
  command_item(frame, "Interfaces", "show interfaces toggle", view.interfaces);
  command_item(frame, "Interior edges", "show interior-edges toggle", view.interior_edges);
  ImGui::EndMenu();
}

void beside_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Axes, scales and ids")) return;
  const scene::View& view = frame.session.view;
  command_item(frame, "Axes", "show axes toggle", view.axes);
  command_item(frame, "Scale of the colours", "show scale toggle", view.scale);
  command_item(frame, "Scale of lengths", "show length-scale toggle", view.length_scale,
               view.camera.orthographic);
  command_item(frame, "Ids at the selection", "labels toggle", view.labels);
  ImGui::EndMenu();
}

void page_item(Frame& frame, const char* label, const std::string& name, scene::Page page) {
  const auto& panels = frame.session.view.panels;
  const bool up = panels.side && panels.page == page;
  command_item(frame, label, "panel " + name + (up ? " off" : " on"), up);
}

void panels_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Panels")) return;
  const auto& panels = frame.session.view.panels;
  command_item(frame, "Mesh panel", "panel mesh toggle", panels.mesh);
  page_item(frame, "Decimation", "decimation", scene::Page::Decimation);
  page_item(frame, "Adjacencies T(I,J)", "adjacency", scene::Page::Adjacency);
  page_item(frame, "Histograms", "histograms", scene::Page::Histograms);
  page_item(frame, "Selection", "selection", scene::Page::Selection);
  command_item(frame, "Timeline", "panel timeline toggle", panels.timeline);
  command_item(frame, "Runs", "panel runs toggle", panels.runs);
  ImGui::Separator();
  command_item(frame, "All panels", "panel all toggle");
  ImGui::EndMenu();
}

/// No higher than a window of 600 pixels.
void view_menu(Frame& frame) {
  if (!ImGui::BeginMenu("View")) return;
  const scene::View& view = frame.session.view;
  command_item(frame, "Show all of it", "fit", false, frame.has_mesh());
  command_item(frame, "Show what is selected", "fit selection", false,
               !frame.session.sheet().selection.empty());
  camera_menu(frame);
  color_menu(frame);
  clip_menu(frame);
  light_menu(frame);
  ImGui::Separator();
  surface_items(frame);
  inside_menu(frame);
  beside_menu(frame);
  ImGui::Separator();
  command_item(frame, "Original over it", "show original toggle", view.original,
               frame.can_decimate());
  command_item(frame, "Original beside it", "compare toggle", view.side_by_side,
               frame.can_decimate());
  operation_menu(frame);
  command_item(frame, "Preview of the collapse", view.preview ? "preview off" : "preview on",
               view.preview);
  ImGui::Separator();
  panels_menu(frame);
  text_menu(frame);
  command_item(frame, "Presentation", "presentation toggle", view.presenting.has_value());
  command_item(frame, "Dark theme", "theme toggle", view.theme == scene::Theme::Dark);
  ImGui::EndMenu();
}

void help_menu(Frame& frame) {
  if (!ImGui::BeginMenu("Help")) return;
  command_item(frame, "Lessons\u2026", "dialog lessons");
  ImGui::Separator();
  command_item(frame, "All commands\u2026", "palette");
  command_item(frame, "Keyboard and mouse", "dialog shortcuts");
  command_item(frame, "About", "dialog about");
  ImGui::EndMenu();
}

}  // namespace

void menu_bar(Frame& frame, const RecentFiles& recent, MenuBarState& state) {
  const std::string& wanted = frame.session.view.bar_menu;
  // Nobody closes one without a window, but pictures without panels that come in between.
  const bool lost = !frame.interactive && !ImGui::IsPopupOpen(wanted.c_str());
  if (!wanted.empty() && (state.shown != wanted || lost)) ImGui::OpenPopup(wanted.c_str());
  // What a command has opened another one closes.
  if (wanted.empty() && !state.shown.empty() && ImGui::IsPopupOpen(state.shown.c_str()))
    ImGui::ClosePopupToLevel(0, true);
  const bool closed = !wanted.empty() && !ImGui::IsPopupOpen(wanted.c_str());
  state.shown = wanted;
  file_menu(frame, recent);
  edit_menu(frame);
  view_menu(frame);
  help_menu(frame);
  if (closed) frame.emit("menu off");
}

}  // namespace aomd::ui
