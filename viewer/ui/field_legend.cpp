#include <array>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

void ramp_bar(const scene::FieldScale& scale) {
  constexpr int even_parts = 14;
  const int parts = scale.steps > 0 ? scale.steps : even_parts;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.8f * em();
  const auto color_at = [&](float i) { return scale.color_at(static_cast<double>(i) / parts); };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < parts; ++i) {
    const auto at = static_cast<float>(i);
    const auto x = [&](float k) { return from.x + width * k / static_cast<float>(parts); };
    const bool even = scale.steps == 0;
    const ImU32 left = color_at(even ? at : at + 0.5f), right = color_at(even ? at + 1 : at + 0.5f);
    list.AddRectFilledMultiColor({x(at), from.y}, {x(at + 1), from.y + height}, left, right, right,
                                 left);
  }
  ImGui::Dummy({width, height});
}

/// The smallest value, the one in the middle of the colours, and the largest.
void ramp_numbers(const scene::FieldScale& scale) {
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  for (const float part : {0.0f, 0.5f, 1.0f}) {
    std::string text = scene::significant(scale.at(part));
    if (scale.beyond && part == 0) text = "\u2264 " + text;
    if (scale.beyond && part == 1) text = "\u2265 " + text;
    if (part > 0) ImGui::SameLine();
    ImGui::SetCursorPosX(left + part * (width - ImGui::CalcTextSize(text.c_str()).x));
    ImGui::TextUnformatted(text.c_str());
  }
}

/// What else the scale may look like.
void scale_menu(Frame& frame, const scene::ScaleChoice& choice, const scene::FieldScale& scale) {
  using Range = scene::ScaleChoice::Range;
  if (!ImGui::BeginPopup("scale")) return;
  const auto number = [](double value) { return scene::short_number(value, 6); };
  command_item(frame, "As the values do", "range auto", choice.range == Range::Automatic);
  command_item(frame, "Without outliers", "range percentile 98", choice.range == Range::Percentile);
  command_item(frame, "From and to\u2026",
               "palette range " + number(scale.low) + " " + number(scale.high),
               choice.range == Range::Fixed);
  ImGui::Separator();
  command_item(frame, "Without steps", "scale steps 0", choice.steps == 0);
  command_item(frame, "5 steps", "scale steps 5", choice.steps == 5);
  command_item(frame, "10 steps", "scale steps 10", choice.steps == 10);
  command_item(frame, "By the logarithm",
               scale.logarithmic ? "scale spread linear" : "scale spread log", scale.logarithmic);
  ImGui::Separator();
  for (const char* name : {"viridis", "magma", "cividis", "grey"})
    command_item(frame, name, std::string("scale map ") + name);
  ImGui::Separator();
  command_item(frame, "In the picture too", "show scale toggle", frame.session.view.scale);
  ImGui::EndPopup();
}

void scale_button(Frame& frame, const scene::ScaleChoice& choice, const scene::FieldScale& scale) {
  same_line_right(ImGui::CalcTextSize("Scale").x + 2 * ImGui::GetStyle().FramePadding.x);
  if (ImGui::SmallButton("Scale")) ImGui::OpenPopup("scale");
  tooltip("Where it begins and ends, its steps and its colours.");
  scale_menu(frame, choice, scale);
}

const char* why_none(scene::Coloring coloring) {
  if (coloring == scene::Coloring::Distance)
    return "Nothing to compare: this mesh is not decimated and stays as loaded.";
  return "This mesh is not decimated: nothing is wanted of it.";
}

/// What is grey beside the scale, inside of a volume that is cut open or pulled apart.
void grey_inside(const Frame& frame) {
  const scene::View& view = frame.session.view;
  const bool inside = frame.document().content().volume() && (view.clip || view.shrink > 0);
  if (inside && view.coloring == scene::Coloring::Distance)
    muted(frame, "Grey: inside, on no model face.");
  if (inside && view.coloring == scene::Coloring::Curvature)
    muted(frame, "Grey: inside, where nothing bends.");
}

}  // namespace

void field_legend(Frame& frame) {
  const scene::Coloring coloring = frame.session.view.coloring;
  if (!scene::is_field(coloring)) return;
  const bool volume = frame.has_mesh() && frame.document().content().volume();
  const scene::FieldText words = scene::field_text(coloring, volume);
  const scene::ScalarField* field = frame.session.sheet().field();
  heading(frame, std::string(words.title).c_str());
  tooltip(words.help);
  if (field != nullptr) scale_button(frame, *frame.session.view.scale_choice(), field->scale);
  ImGui::PushTextWrapPos(0);
  if (field == nullptr) {
    muted(frame, why_none(coloring));
  } else if (field->scale.empty()) {
    muted(frame, coloring == scene::Coloring::Spacing ? "No limit."
                                                      : "Flat all over, or not measured yet.");
  } else if (coloring == scene::Coloring::Distance && field->scale.high == 0) {
    muted(frame, "None: all faces lie on it.");
  } else {
    ramp_bar(field->scale);
    ramp_numbers(field->scale);
    muted(frame, words.unit);
  }
  if (field != nullptr) grey_inside(frame);
  ImGui::PopTextWrapPos();
  gap();
}

}  // namespace aomd::ui
