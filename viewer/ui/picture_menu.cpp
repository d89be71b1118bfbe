#include "viewer/ui/picture_menu.h"

#include <array>
#include <string>

#include "viewer/commands/arguments.h"
#include "viewer/explain/entity_facts.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

void title(const Frame& frame, const scene::Selection& selection) {
  const EntityRef e = selection.single();
  muted(frame, e.valid()           ? scene::entity_title(e)
               : selection.empty() ? std::string("Nothing is selected")
                                   : scene::selection_text(selection));
  ImGui::Separator();
}

void neighbours_menu(Frame& frame, bool enabled) {
  if (!ImGui::BeginMenu("Neighbours", enabled)) return;
  constexpr std::array<const char*, 4> names = {"Vertices", "Edges", "Faces", "Regions"};
  const std::optional<int> present = frame.session.view.neighbours;
  for (int level = 0; level < 4; ++level)
    command_item(frame, names[static_cast<std::size_t>(level)],
                 std::string("neighbours ") + entity_name(level), present == level,
                 frame.document().mesh().count(level) > 0);
  command_item(frame, "None", "neighbours off", false, present.has_value());
  ImGui::EndMenu();
}

/// What lies on the same model entity as the only one that is selected.
void class_items(Frame& frame, EntityRef e) {
  const ModelRef model = e.valid() ? frame.document().mesh().classification(e) : ModelRef();
  if (model.valid()) {
    const std::string name = scene::model_entity_text(model), words = scene::model_words(model);
    ImGui::Separator();
    command_item(frame, ("Select all on " + words).c_str(), "select class " + name);
    command_item(frame, ("Hide " + words).c_str(), "hide " + name + " on");
  }
  if (!frame.session.view.hidden.empty()) command_item(frame, "Show what is hidden", "hide");
}

void items(Frame& frame) {
  const scene::Selection& selection = frame.session.sheet().selection;
  const EntityRef e = selection.single();
  const bool some = !selection.empty();
  title(frame, selection);
  command_item(frame, e.valid() && e.dimension == 1 ? "Why is it not collapsed?" : "About it",
               "panel selection on", false, some);
  neighbours_menu(frame, e.valid());
  command_item(frame, "Grow the selection", "select grow", false, some);
  command_item(frame, "Zoom to it", "fit selection", false, some);
  class_items(frame, e);
  ImGui::Separator();
  command_item(frame, selection.size() > 1 ? "Copy the ids" : "Copy the id", "copy selection",
               false, some);
  command_item(frame, "Clear the selection", "select none", false, some);
}

}  // namespace

void picture_menu(Frame& frame, const Area& picture, PictureMenuState& state) {
  const std::optional<glm::dvec2> wanted = frame.session.view.menu;
  if (!wanted) return state.shown.reset();
  const bool lost = !frame.interactive && !ImGui::IsPopupOpen("##picture menu");
  if (state.shown != wanted || lost) ImGui::OpenPopup("##picture menu");
  state.shown = wanted;
  const auto part = [](double ndc) { return static_cast<float>(0.5 * (1 + ndc)); };
  ImGui::SetNextWindowPos({picture.position.x + part(wanted->x) * picture.size.x,
                           picture.position.y + part(-wanted->y) * picture.size.y},
                          ImGuiCond_Appearing);
  if (ImGui::BeginPopup("##picture menu")) {
    items(frame);
    ImGui::EndPopup();
    return;
  }
  state.shown.reset();
  frame.emit("menu off");
}

}  // namespace aomd::ui
