// Which entities light up around the selected one, and how they are known, over the picture.

#include <algorithm>
#include <string>
#include <vector>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr float pad_ems = 0.5f, swatch_ems = 2.0f;
constexpr float axes_ems = 6.5f;  // the left corner belongs to the axes

/// A line as it looks in the picture, or none, and what it means.
struct LegendRow {
  const scene::OverlayStyle* style;
  std::string words;
};

std::vector<LegendRow> rows_of(const scene::Neighbours& n) {
  static const scene::OverlayStyle selected = scene::selected_style(),
                                   stored = scene::stored_style(), derived = scene::derived_style(),
                                   between = scene::between_style();
  std::vector<LegendRow> rows{{nullptr, n.words}};
  if (!n.known) return rows;
  rows.push_back({&selected, name_of(n.of)});
  std::array<std::size_t, 4> count{};
  count[static_cast<std::size_t>(n.level)] = n.entities.size();
  const std::string what = n.entities.empty() ? "none" : scene::counts_text(count);
  rows.push_back({n.stored() ? &stored : &derived, what + (n.stored() ? ", stored" : ", derived")});
  if (n.between.empty()) return rows;
  std::array<std::size_t, 4> passed{};
  for (const EntityRef e : n.between) ++passed[e.dimension];
  rows.push_back({&between, "on the way: " + scene::counts_text(passed)});
  return rows;
}

void draw_swatch(const scene::OverlayStyle& style, ImVec2 from) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float y = from.y + 0.5f * em(), width = (swatch_ems - 0.6f) * em(),
              line = 0.08f * style.line_px * em();
  const int parts = style.hollow ? 3 : 1;
  const float step = width / (static_cast<float>(parts) - (parts > 1 ? 0.4f : 0.0f));
  for (int k = 0; k < parts; ++k) {
    const float x = from.x + static_cast<float>(k) * step;
    list.AddRectFilled({x, y - 0.5f * line},
                       {x + (parts > 1 ? 0.6f * step : width), y + 0.5f * line}, style.color,
                       0.4f * line);
  }
}

/// Long words stand in several lines.
std::vector<LegendRow> broken(std::vector<LegendRow> rows, float width) {
  for (LegendRow& row : rows)
    row.words = broken_at_blanks(row.words, row.style ? width - swatch_ems * em() : width);
  return rows;
}

}  // namespace

void neighbour_legend(const Frame& frame, const Area& viewport) {
  const scene::Neighbours* neighbours = frame.session.sheet().inquiry().neighbours();
  if (neighbours == nullptr || viewport.size.x < 2 * axes_ems * em()) return;
  const float pad = pad_ems * em(),
              most = std::min(26 * em(), viewport.size.x - (axes_ems + 1) * em());
  const std::vector<LegendRow> rows = broken(rows_of(*neighbours), most - 2 * pad);
  ImVec2 size{0, 0};
  for (const LegendRow& row : rows) {
    const ImVec2 words = ImGui::CalcTextSize(row.words.c_str());
    size = {std::max(size.x, words.x + (row.style ? swatch_ems * em() : 0)), size.y + words.y};
  }
  const ImVec2 from{viewport.position.x + viewport.size.x - size.x - 2 * pad - 0.6f * em(),
                    viewport.position.y + viewport.size.y - size.y - 2 * pad - 0.6f * em()};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImVec4 plate = frame.colors.panel;
  plate.w = 0.92f;
  const ImVec2 to{from.x + size.x + 2 * pad, from.y + size.y + 2 * pad};
  list.AddRectFilled(from, to, ImGui::GetColorU32(plate), 0.3f * em());
  list.AddRect(from, to, ImGui::GetColorU32(frame.colors.border), 0.3f * em());
  ImVec2 at{from.x + pad, from.y + pad};
  for (const LegendRow& row : rows) {
    if (row.style) draw_swatch(*row.style, at);
    list.AddText({at.x + (row.style ? swatch_ems * em() : 0), at.y},
                 ImGui::GetColorU32(frame.colors.text), row.words.c_str());
    at.y += ImGui::CalcTextSize(row.words.c_str()).y;
  }
}

}  // namespace aomd::ui
