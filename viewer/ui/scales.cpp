#include "viewer/ui/scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "viewer/base/text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr float bar_ems = 0.9f;      // wide
constexpr float tick_ems = 0.3f;     // long
constexpr float most_high_ems = 15;  // of the bar
constexpr float least_high_ems = 5;
constexpr float words_ems = 11;  // of title and unit, at most wide

void plate(const Frame& frame, ImVec2 from, ImVec2 to) {
  ImVec4 color = frame.colors.panel;
  color.w = 0.88f;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(from, to, ImGui::GetColorU32(color), 0.3f * em());
  list.AddRect(from, to, ImGui::GetColorU32(frame.colors.border), 0.3f * em());
}

/// The end of the scale is at the top.
void draw_bar(const scene::FieldScale& scale, ImVec2 from, float height) {
  constexpr int parts = 32;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float right = from.x + bar_ems * em();
  const auto y = [&](double part) { return from.y + height * static_cast<float>(1 - part); };
  const int count = scale.steps > 0 ? scale.steps : parts;
  for (int k = 0; k < count; ++k) {
    const double low = static_cast<double>(k) / count, high = (k + 1.0) / count;
    const double middle = 0.5 * (low + high);
    const ImU32 below = scale.color_at(scale.steps > 0 ? middle : low);
    const ImU32 above = scale.color_at(scale.steps > 0 ? middle : high);
    list.AddRectFilledMultiColor({from.x, y(high)}, {right, y(low)}, above, above, below, below);
  }
}

void draw_ticks(const Frame& frame, const std::vector<scene::ScaleTick>& ticks, ImVec2 from,
                float height) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImU32 color = ImGui::GetColorU32(frame.colors.text);
  const float x = from.x + bar_ems * em();
  for (const scene::ScaleTick& tick : ticks) {
    const float y = std::round(from.y + height * static_cast<float>(1 - tick.part));
    list.AddLine({x, y}, {x + tick_ems * em(), y}, color);
    list.AddText({x + (tick_ems + 0.25f) * em(), y - 0.5f * em()}, color, tick.text.c_str());
  }
}

float widest(const std::vector<scene::ScaleTick>& ticks) {
  float width = 0;
  for (const scene::ScaleTick& tick : ticks)
    width = std::max(width, ImGui::CalcTextSize(tick.text.c_str()).x);
  return width;
}

/// The field that the present mesh is coloured by; null where there is nothing to tell.
const scene::ScalarField* shown_field(const Frame& frame) {
  const scene::View& view = frame.session.view;
  const bool shown = view.scale && (view.surface || view.interior_edges);
  if (!shown || !scene::is_field(view.coloring) || !frame.has_mesh()) return nullptr;
  const scene::ScalarField* field = frame.session.sheet().field();
  return field != nullptr && field->scale.high > field->scale.low ? field : nullptr;
}

/// 1, 2 or 5 times a power of ten: the largest that is not above.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double each : {5.0, 2.0})
    if (each * power <= most) return each * power;
  return power;
}

}  // namespace

void color_scale(const Frame& frame, const Area& picture) {
  const scene::ScalarField* field = shown_field(frame);
  const float room = picture.size.y - 9 * em();
  if (field == nullptr || room < least_high_ems * em() || picture.size.x < 3 * words_ems * em())
    return;
  ImGui::PushFont(frame.fonts.small);
  const float height = std::round(std::min(most_high_ems * em(), 0.8f * room));
  const auto ticks = scene::scale_ticks(field->scale, static_cast<int>(height / (2.4f * em())));
  const scene::FieldText words =
      scene::field_text(field->kind, frame.document().content().volume());
  const std::string title = broken_at_blanks(words.title, words_ems * em());
  const std::string unit = broken_at_blanks(words.unit, words_ems * em());
  const ImVec2 title_size = ImGui::CalcTextSize(title.c_str());
  const ImVec2 unit_size = ImGui::CalcTextSize(unit.c_str());
  const float pad = 0.55f * em();
  const float width =
      std::max({title_size.x, unit_size.x, (bar_ems + tick_ems + 0.25f) * em() + widest(ticks)});
  const float above = title_size.y + unit_size.y + 0.9f * em();
  const ImVec2 size{width + 2 * pad, above + height + 0.5f * em() + 2 * pad};
  const ImVec2 from{std::round(picture.position.x + picture.size.x - size.x - 0.6f * em()),
                    std::round(picture.position.y + 0.5f * (picture.size.y - size.y))};
  plate(frame, from, {from.x + size.x, from.y + size.y});
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 at{from.x + pad, from.y + pad};
  list.AddText(at, ImGui::GetColorU32(frame.colors.text), title.c_str());
  list.AddText({at.x, at.y + title_size.y}, ImGui::GetColorU32(frame.colors.text_muted),
               unit.c_str());
  draw_bar(field->scale, {at.x, at.y + above}, height);
  draw_ticks(frame, ticks, {at.x, at.y + above}, height);
  ImGui::PopFont();
}

namespace {

/// A bar of a round length, with its words above.
struct LengthBar {
  std::string words;
  float width = 0;  ///< 0: there is none
};

LengthBar length_bar(const Frame& frame, const Area& picture) {
  const scene::View& view = frame.session.view;
  if (!view.length_scale || !view.camera.orthographic || !frame.has_mesh()) return {};
  const double unit_px = picture.size.y / (2 * view.camera.half_height());
  const double most_px = std::min(9.0 * em(), 0.3 * picture.size.x);
  if (!(most_px > 2 * em()) || !std::isfinite(unit_px) || !(unit_px > 0)) return {};
  const double length = round_length(most_px / unit_px);
  return {scene::significant(length), static_cast<float>(length * unit_px)};
}

/// With the plate around it, for the font that is pushed.
Area area_of(const LengthBar& bar, const Area& picture, float bottom) {
  const ImVec2 words = ImGui::CalcTextSize(bar.words.c_str());
  const float pad = 0.5f * em(), half = 0.3f * em();
  const float wide = std::max(bar.width, words.x);
  const float x = std::round(picture.position.x + 0.5f * (picture.size.x - bar.width));
  return {{x + 0.5f * (bar.width - wide) - pad, bottom - words.y - half - 0.2f * em()},
          {wide + 2 * pad, words.y + 2 * half + 0.4f * em()}};
}

float bottom_of(const Area& picture) {
  return std::round(picture.position.y + picture.size.y - 1.1f * em());
}

}  // namespace

Area length_scale_area(const Frame& frame, const Area& picture) {
  const LengthBar bar = length_bar(frame, picture);
  if (!(bar.width > 0)) return {};
  ImGui::PushFont(frame.fonts.small);
  const Area area = area_of(bar, picture, bottom_of(picture));
  ImGui::PopFont();
  return area;
}

void length_scale(const Frame& frame, const Area& picture) {
  const LengthBar bar = length_bar(frame, picture);
  if (!(bar.width > 0)) return;
  ImGui::PushFont(frame.fonts.small);
  const float y = bottom_of(picture), half = 0.3f * em();
  const Area area = area_of(bar, picture, y);
  plate(frame, area.position, {area.position.x + area.size.x, area.position.y + area.size.y});
  const ImVec2 size = ImGui::CalcTextSize(bar.words.c_str());
  const float x = std::round(picture.position.x + 0.5f * (picture.size.x - bar.width));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImU32 color = ImGui::GetColorU32(frame.colors.text);
  list.AddText({x + 0.5f * (bar.width - size.x), y - size.y - half}, color, bar.words.c_str());
  list.AddLine({x, y}, {x + bar.width, y}, color, 0.12f * em());
  for (const float end : {x, x + bar.width})
    list.AddLine({end, y - half}, {end, y + half}, color, 0.12f * em());
  ImGui::PopFont();
}

}  // namespace aomd::ui
