#include "viewer/ui/class_controls.h"

#include <algorithm>
#include <string>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/ui/link_flow.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::size_t most_ids = 24, most_neighbours = 12, most_choices = 40;

std::string more(std::size_t count) { return "\u2026 and " + scene::grouped(count) + " more"; }

void links(Frame& frame, const char* title, const std::vector<ModelRef>& refs, const char* help) {
  if (refs.empty()) return;
  muted(frame, std::string(title) + " " + std::to_string(refs.size()));
  tooltip(help);
  LinkFlow flow(frame);
  for (std::size_t i = 0; i < std::min(refs.size(), most_neighbours); ++i)
    flow.add(scene::model_entity_label(refs[i]), "highlight " + scene::model_entity_text(refs[i]),
             "Show this model entity");
  if (refs.size() > most_neighbours) muted(frame, more(refs.size() - most_neighbours));
}

void counts(const Frame& frame, const scene::ModelEntityFacts& facts) {
  if (!begin_values("model entity", 2)) return;
  for (std::size_t level = 0; level < 4; ++level)
    if (facts.counts[level] > 0)
      value_row(frame, capitalized(entity_plural(static_cast<int>(level))).c_str(),
                scene::grouped(facts.counts[level]),
                "Mesh entities of this kind that lie on it; not those that only bound it.");
  for (const auto& [name, value] : facts.facts)
    value_row(frame, name.c_str(), value,
              "Of all its mesh entities together, in units of the mesh.");
  end_values();
}

void entity_links(Frame& frame, const scene::ModelEntityFacts& facts) {
  if (facts.ids.empty()) return;
  const int dim = facts.ref.dimension();
  muted(frame, std::string("Mesh ") + entity_plural(dim));
  LinkFlow flow(frame);
  for (std::size_t i = 0; i < std::min(facts.ids.size(), most_ids); ++i)
    flow.add(std::to_string(facts.ids[i]), EntityRef(dim, facts.ids[i]), "Select it");
  if (facts.ids.size() > most_ids) muted(frame, more(facts.ids.size() - most_ids));
}

void model_entity_buttons(Frame& frame, const scene::ModelEntityFacts& facts) {
  const std::string name = scene::model_entity_text(facts.ref);
  const float width = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x) / 4;
  command_button(frame, "Show", "fit " + name, width);
  ImGui::SameLine();
  command_button(frame, "Select", "select class " + name, width);
  ImGui::SameLine();
  const bool hidden = frame.session.view.hidden.contains(facts.ref);
  command_button(frame, hidden ? "Unhide" : "Hide", "hide " + name + (hidden ? " off" : " on"),
                 width);
  ImGui::SameLine();
  if (ImGui::Button("Copy##model", {width, 0}))
    ImGui::SetClipboardText(scene::model_entity_text(facts).c_str());
  tooltip("All of this as text, with the ids of all its mesh entities.");
}

/// Model entities that the selection could be put onto.
void assign_choices(Frame& frame, int dim) {
  const std::string kind = entity_name(dim);
  if (ImGui::MenuItem(("A new model " + kind).c_str())) frame.emit("assign " + kind + ":new");
  if (dim == 2 && ImGui::MenuItem("A new model face, its border as model edges"))
    frame.emit("assign face:new border");
  ImGui::Separator();
  std::size_t left = most_choices;
  for (const ModelRef ref : frame.document().mesh().class_lists()->models(dim)) {
    if (ref.dimension() != dim || left-- == 0) continue;
    if (ImGui::MenuItem(scene::model_entity_title(ref).c_str()))
      frame.emit("assign " + scene::model_entity_text(ref));
  }
}

}  // namespace

void model_entity_section(Frame& frame) {
  const scene::ModelEntityFacts* facts = frame.session.sheet().inquiry().model_entity();
  if (facts == nullptr) return;
  heading(frame, scene::model_entity_title(facts->ref).c_str());
  same_line_right(ImGui::CalcTextSize("Close").x + 2 * ImGui::GetStyle().FramePadding.x);
  if (ImGui::SmallButton("Close")) frame.emit("highlight");
  tooltip("Ends the highlight.");
  counts(frame, *facts);
  model_entity_buttons(frame, *facts);
  links(frame, "Bounded by", facts->bounded_by,
        "Model edges and vertices at its ends or around it.");
  links(frame, "Bounds", facts->bounds,
        "Model entities of higher dimension that it lies at the end or border of.");
  links(frame, "Beside", facts->beside,
        "Of its own dimension, with a part of the border in common.");
  entity_links(frame, *facts);
  if (facts->ref.dimension() == 2 && !frame.document().content().skin)
    command_button(frame, "Split where model edges cut it",
                   "split-face " + scene::model_entity_text(facts->ref), -1);
  gap();
}

void class_edits(Frame& frame) {
  if (frame.document().content().skin || frame.session.sheet().selection.empty()) return;
  gap(0.2f);
  heading(frame, "Classification");
  tooltip(
      "What the selection lies on. Collapses keep model edges and model vertices. An edit that "
      "would break a "
      "rule is refused, with the rule and what breaks it.");
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  command_button(frame, "Promote", "promote", width);
  ImGui::SameLine();
  command_button(frame, "Demote", "demote", width);
  ImGui::SameLine();
  const int dim = frame.session.sheet().selection.entities().back().dimension;
  if (ImGui::Button("Put on ...", {width, 0})) ImGui::OpenPopup("assign");
  command_tooltip("assign");
  if (!ImGui::BeginPopup("assign")) return;
  assign_choices(frame, dim);
  ImGui::EndPopup();
}

void model_entity_menu(Frame& frame, ModelRef ref) {
  if (!ImGui::BeginPopupContextItem("model entity")) return;
  const std::string name = scene::model_entity_text(ref);
  const bool hidden = frame.session.view.hidden.contains(ref);
  command_item(frame, "Show", "fit " + name);
  if (ImGui::MenuItem("Details")) {
    frame.emit("highlight " + name);
    frame.emit("panel selection on");
  }
  command_item(frame, "Select what lies on it", "select class " + name);
  command_item(frame, hidden ? "Unhide" : "Hide", "hide " + name + (hidden ? " off" : " on"));
  if (!frame.document().content().skin) {
    ImGui::Separator();
    command_item(frame, "Put the selection on it", "assign " + name, false,
                 !frame.session.sheet().selection.empty());
    if (ref.dimension() == 2)
      command_item(frame, "Split where model edges cut it", "split-face " + name);
  }
  ImGui::EndPopup();
}

}  // namespace aomd::ui
