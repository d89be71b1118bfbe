// The page about what is selected: what it is, what is adjacent, and why it stays.

#include <algorithm>
#include <array>
#include <string>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/document/adjacency.h"
#include "viewer/drawing/scalar_field.h"
#include "viewer/drawing/selection_drawing.h"
#include "viewer/explain/entity_verdict.h"
#include "viewer/explain/measures.h"
#include "viewer/ui/class_controls.h"
#include "viewer/ui/link_flow.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::size_t most_links = 400;

void level_choice(Frame& frame) {
  constexpr std::array<Choice, 5> levels = {
      {{"automatic", "The vertex or edge that is near, else the face, else the region."},
       {"vertex", "The nearest vertex."},
       {"edge", "The nearest edge."},
       {"face", "The face."},
       {"region", "The region behind it."}}};
  ImGui::AlignTextToFramePadding();
  muted(frame, "A click takes");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (const auto chosen =
          choice_control("level", levels, static_cast<std::size_t>(frame.session.view.pick_level)))
    frame.emit(std::string("pick-level ") + levels[*chosen].name);
}

void facts_table(Frame& frame, const scene::EntityFacts& inspection) {
  const ModelRef model = frame.document().mesh().classification(inspection.entity);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.25f * em(), 0.1f * em()));
  if (ImGui::BeginTable("facts", 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 6.6f * em());
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [name, value] : inspection.facts) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      muted(frame, fitted(name, 6.6f * em()));
      if (name == "Spacing") tooltip(scene::field_text(scene::Coloring::Spacing, false).help);
      ImGui::TableNextColumn();
      if (name == "Lies on" && model.valid())
        LinkFlow(frame).add(value, "highlight " + scene::model_entity_text(model),
                            "Show this model entity");
      else
        wrapped(value, frame.colors.text);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

/// Lights a level up in the picture, or stores the relation that leads to it.
void neighbour_links(const Frame& frame, LinkFlow& flow, int i, const scene::AdjacentLevel& level) {
  const bool lit = frame.session.view.neighbours == level.level;
  const std::string name = entity_name(level.level);
  if (level.known)
    flow.add(lit ? "[hide]" : "[show]", "neighbours " + (lit ? "off" : name),
             "Lights them up in the picture: stored ones solid, derived ones dashed, with the path "
             "to them.");
  else
    flow.add("[store " + relation_name(i, level.level) + "]",
             "adjacency " + std::to_string(i) + " " + std::to_string(level.level) + " on",
             "Nothing that is stored leads there: stores this relation.");
}

void adjacent_section(Frame& frame, const scene::EntityFacts& inspection) {
  heading(frame, "Adjacent");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.2f * em()});
  for (const scene::AdjacentLevel& level : inspection.adjacent) {
    ImGui::PushID(level.level);
    const std::string relation = relation_name(inspection.entity.dimension, level.level);
    muted(frame, capitalized(entity_plural(level.level)) +
                     (level.known ? " " + std::to_string(level.ids.size()) : ""));
    ImGui::SameLine();
    const std::string how = level.stored ? "stored" : level.known ? "derived" : "not stored";
    ImGui::PushFont(frame.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text,
                          level.known ? frame.colors.text_muted : frame.colors.warning);
    text_right(relation + " " + how);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    tooltip(level.stored ? "The row of " + relation + " as it is stored."
                         : relation + ": " + level.how);
    LinkFlow flow(frame);
    neighbour_links(frame, flow, inspection.entity.dimension, level);
    const char* help = level.forwards.empty()
                           ? "Select it"
                           : "Select it. + or -: used along its own direction, or against it";
    for (std::size_t i = 0; i < level.ids.size(); ++i)
      flow.add(scene::adjacent_text(level, i), EntityRef(level.level, level.ids[i]), help);
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
}

const char* check_help(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 9> help = {
      {{"Length", "Is the edge shorter than half the spacing?"},
       {"Kept", "Does the user want the vertex to stay?"},
       {"Model", "Does the vertex stay on the model entity that it lies on?"},
       {"Topology", "The link condition: is the surface neither pinched, doubled nor torn?"},
       {"Faces", "Do the stretched faces keep area, direction and angles?"},
       {"Model edge", "Does the model edge keep its direction?"},
       {"Tetrahedra", "Do the stretched tetrahedra stay upright and of a good shape?"},
       {"Distance", "Does the surface stay near the original?"},
       {"Intersections", "Does the surface cut itself no more than before?"}}};
  for (const auto& [check, words] : help)
    if (check == name) return words;
  return "";
}

/// The checks in their order: green is passed, red decided, grey was not reached.
void checks_line(const Frame& frame, const std::vector<CheckResult>& checks) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(frame.fonts.small);
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const CheckResult& c = checks[i];
    const float width = ImGui::CalcTextSize(c.name).x;
    if (i > 0 && ImGui::GetItemRectMax().x + 0.5f * em() + width < right)
      ImGui::SameLine(0, 0.5f * em());
    const ImVec4 color = c.state == CheckResult::State::Passed   ? frame.colors.good
                         : c.state == CheckResult::State::Failed ? frame.colors.bad
                                                                 : frame.colors.text_muted;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    text(c.name);
    ImGui::PopStyleColor();
    if (c.state == CheckResult::State::Failed)
      ImGui::GetWindowDrawList()->AddLine({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y},
                                          ImGui::GetItemRectMax(), ImGui::GetColorU32(color), 1.5f);
    const char* outcome = c.state == CheckResult::State::Passed   ? "Passed. "
                          : c.state == CheckResult::State::Failed ? "This one decided. "
                                                                  : "Not reached. ";
    ImGui::PopFont();
    tooltip(std::string(outcome) + check_help(c.name));
    ImGui::PushFont(frame.fonts.small);
  }
  ImGui::PopFont();
}

void way_section(Frame& frame, const scene::CollapseWay& way, std::size_t number, bool shown) {
  ImGui::PushID(static_cast<int>(number));
  if (number > 1) gap(0.25f);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  if (ImGui::RadioButton(scene::way_title(way).c_str(), shown))
    frame.emit("preview " + std::to_string(number));
  ImGui::PopStyleVar();
  tooltip("Draw the faces that this would leave.");
  const bool yes = way.outlook.verdict.accepted();
  wrapped(way.words, yes ? frame.colors.good : frame.colors.bad);
  checks_line(frame, way.checks);
  if (way.outlook.cost) {
    const glm::dvec3& p = way.outlook.contraction.position;
    muted(frame, "Cost " + scene::significant(*way.outlook.cost));
    tooltip(
        "What orders the collapses: the error that it adds, as a part of the mesh's diagonal, and "
        "a little "
        "for its length. The cheapest goes first.");
    wrapped(frame, "Kept vertex at " + scene::significant(p.x) + ", " + scene::significant(p.y) +
                       ", " + scene::significant(p.z));
  }
  ImGui::PopID();
}

void swap_choice(Frame& frame, const scene::EntityVerdict& judgement) {
  const EdgePair& pair = judgement.swap->pair;
  if (!pair.f.valid() || !pair.g.valid()) return;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
  const std::string label = scene::entity_title(pair.c) + " to " + name_of(pair.d);
  if (ImGui::RadioButton(label.c_str(), frame.session.view.preview &&
                                            frame.session.sheet().inquiry().previewed_way(
                                                frame.session.view) == judgement.ways.size()))
    frame.emit("preview swap");
  ImGui::PopStyleVar();
  tooltip("Draw the faces that this would make.");
}

/// What the colours of a preview among tetrahedra mean.
void preview_key(const Frame& frame) {
  ImGui::PushFont(frame.fonts.small);
  const auto entry = [](scene::Color color, const char* word, const char* help) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = 0.6f * em(), y = at.y + 0.5f * (ImGui::GetTextLineHeight() - side);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side}, color);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side + 0.3f * em());
    text(word);
    tooltip(help);
  };
  entry(scene::vanishing_color(), "goes", "Tetrahedra around the edge: they vanish.");
  ImGui::SameLine(0, 0.8f * em());
  entry(scene::ghost_color(), "stretches", "Edges as they would be afterwards.");
  ImGui::SameLine(0, 0.8f * em());
  entry(scene::deciding_style().color, "decides", "What stands against it, as it would be.");
  ImGui::PopFont();
}

void judgement_section(Frame& frame, const scene::EntityVerdict& judgement) {
  if (!judgement.ways.empty()) {
    gap(0.2f);
    heading(frame, "Collapse");
    if (frame.document().content().volume()) preview_key(frame);
    for (std::size_t i = 0; i < judgement.ways.size(); ++i)
      way_section(frame, judgement.ways[i], i + 1,
                  frame.session.view.preview &&
                      frame.session.sheet().inquiry().previewed_way(frame.session.view) == i);
  }
  const auto section = [&](const char* title, const std::string& words, bool accepted, bool known) {
    if (words.empty()) return;
    gap(0.2f);
    heading(frame, title);
    if (judgement.swap) swap_choice(frame, judgement);
    wrapped(words, !known     ? frame.colors.text_muted
                   : accepted ? frame.colors.good
                              : frame.colors.bad);
  };
  section("Swap", judgement.swap_words, judgement.swap && judgement.swap->verdict.accepted(),
          judgement.swap.has_value());
  section("Smoothing", judgement.move_words, judgement.move && judgement.move->verdict.accepted(),
          judgement.move.has_value());
}

void buttons(Frame& frame, const std::string& copied) {
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  command_button(frame, "Show", "fit selection", width);
  ImGui::SameLine();
  command_button(frame, "Grow", "select grow", width);
  ImGui::SameLine();
  if (ImGui::Button("Copy", {width, 0})) ImGui::SetClipboardText(copied.c_str());
  tooltip("All of this page as text.");
}

void one_entity(Frame& frame, const scene::EntityFacts& inspection) {
  const scene::EntityVerdict* judgement = frame.session.sheet().inquiry().verdict();
  heading(frame, scene::entity_title(inspection.entity).c_str());
  facts_table(frame, inspection);
  buttons(frame, scene::entity_facts_text(inspection, judgement));
  class_edits(frame);
  if (judgement) judgement_section(frame, *judgement);
  if (!judgement && frame.document().running()) muted(frame, "Judged once the run has ended.");
  gap(0.2f);
  adjacent_section(frame, inspection);
}

void measures_table(const Frame& frame, const scene::Measures& measures) {
  if (measures.facts.empty() || !begin_values("measures", 2)) return;
  for (const auto& [name, value] : measures.facts) value_row(frame, name.c_str(), value, "");
  end_values();
}

void many_entities(Frame& frame, const scene::Selection& selection) {
  const scene::Measures measures = scene::measure_selection(frame.document().mesh(), selection);
  heading(frame, scene::selection_text(selection).c_str());
  measures_table(frame, measures);
  std::string copied;
  for (const auto& [name, value] : measures.facts) copied += name + "\t" + value + "\n";
  for (const EntityRef e : selection.entities()) copied += name_of(e) + "\n";
  buttons(frame, copied);
  class_edits(frame);
  LinkFlow flow(frame);
  std::size_t left = most_links;
  for (const EntityRef e : selection.entities()) {
    if (left-- == 0) break;
    flow.add(scene::entity_label(e), e, "Select it alone");
  }
  if (selection.size() > most_links)
    muted(frame, "and " + scene::grouped(selection.size() - most_links) + " more");
}

}  // namespace

void inspector_panel(Frame& frame) {
  if (!frame.has_mesh()) return;
  level_choice(frame);
  gap(0.2f);
  model_entity_section(frame);
  if (frame.session.sheet().selection.empty())
    wrapped(frame,
            "Nothing is selected. Click a vertex, an edge or a face to see what it lies on, what "
            "is adjacent and "
            "why decimation leaves it. Shift adds, a drag with Ctrl takes a box, Escape lets go. "
            "Two or "
            "three vertices measure distances and angles.");
  else if (const scene::EntityFacts* inspection = frame.session.sheet().inquiry().facts())
    one_entity(frame, *inspection);
  else
    many_entities(frame, frame.session.sheet().selection);
}

}  // namespace aomd::ui
