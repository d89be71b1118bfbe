#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "viewer/base/text.h"
#include "viewer/document/adjacency.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::array<const char*, 4> level_names = {"0 Vertex", "1 Edge", "2 Face", "3 Region"};

/// How a cell looks, in the order of the key below the table.
enum class State { Set, Requested, Implied, Absent };

State state_of(const scene::AdjacencyCell& cell) {
  if (!cell.stored) return State::Absent;
  return cell.set ? State::Set : cell.requests > 0 ? State::Requested : State::Implied;
}

struct Look {
  ImVec4 fill, border, text;
};

Look look_of(const Frame& frame, State state) {
  const ThemeColors& c = frame.colors;
  const ImVec4 accent = c.accent;
  switch (state) {
    case State::Set:
      return {accent, accent, on_accent(frame)};
    case State::Requested:
      return {{accent.x, accent.y, accent.z, 0.24f}, accent, c.text};
    case State::Implied:
      return {ImGui::GetStyleColorVec4(ImGuiCol_FrameBg), c.text_muted, c.text};
    case State::Absent:
      break;
  }
  return {{0, 0, 0, 0}, c.border, c.text_muted};
}

void draw_box(const Look& look, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = std::min(0.25f * em(), 0.25f * (to.y - from.y));
  list.AddRectFilled(from, to, ImGui::GetColorU32(look.fill), radius);
  list.AddRect(from, to, ImGui::GetColorU32(look.border), radius);
}

/// In the middle of a width, in the present font.
void draw_centered(ImVec2 from, float width, const std::string& s, const ImVec4& color) {
  const float left = from.x + 0.5f * (width - ImGui::CalcTextSize(s.c_str()).x);
  ImGui::GetWindowDrawList()->AddText({left, from.y}, ImGui::GetColorU32(color), s.c_str());
}

/// "71.9 KB", or "71.9K" where there is less room.
std::string short_bytes(std::size_t bytes, float width) {
  std::string text = scene::bytes_text(bytes);
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  text.erase(text.find(' '), 1);
  if (text.size() > 1) text.pop_back();
  return text;
}

struct Grid {
  float label = 0;  ///< width of the rows' names
  ImVec2 cell;
  float gap = 0;
};

Grid make_grid() {
  Grid grid;
  grid.gap = 0.22f * em();
  for (const char* name : level_names)
    grid.label = std::max(grid.label, ImGui::CalcTextSize(name).x);
  grid.label += 0.5f * em();
  grid.cell = {(ImGui::GetContentRegionAvail().x - grid.label - 3 * grid.gap) / 4, 2.3f * em()};
  return grid;
}

/// Lights up the entities of a level around the selected one, or lets go of them.
std::string neighbours_line(const Frame& frame, int j) {
  const bool lit = frame.session.view.neighbours == j;
  return std::string("neighbours ") + (lit ? "off" : entity_name(j));
}

/// The selected entity where it has neighbours of that level.
EntityRef centre_for(const Frame& frame, int j) {
  const EntityRef e = frame.session.sheet().selection.single();
  return e.valid() && e.dimension != j ? e : EntityRef();
}

/// Numbers and names, or numbers where a name is too wide. While one entity is selected they light
/// up what is around it.
void column_titles(Frame& frame, const Grid& grid) {
  ImGui::PushFont(frame.fonts.small);
  bool wide = true;
  for (const char* name : level_names)
    wide = wide && ImGui::CalcTextSize(name).x <= grid.cell.x + grid.gap;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  for (std::size_t j = 0; j < level_names.size(); ++j) {
    const float left = corner.x + grid.label + static_cast<float>(j) * (grid.cell.x + grid.gap);
    const int level = static_cast<int>(j);
    const EntityRef centre = centre_for(frame, level);
    const bool lit = centre.valid() && frame.session.view.neighbours == level;
    draw_centered({left, corner.y}, grid.cell.x,
                  wide ? level_names[j] : std::string(1, level_names[j][0]),
                  lit              ? frame.colors.text
                  : centre.valid() ? frame.colors.accent
                                   : frame.colors.text_muted);
    if (!centre.valid()) continue;
    ImGui::SetCursorScreenPos({left, corner.y});
    if (ImGui::InvisibleButton(level_names[j], {grid.cell.x, ImGui::GetFontSize()}))
      frame.emit(neighbours_line(frame, level));
    tooltip("Lights up those around " + scene::entity_title(centre) + ".");
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({1, ImGui::GetFontSize() - 0.3f * em()});
  ImGui::PopFont();
}

void diagonal_cell(const Frame& frame, const Grid& grid) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 middle{at.x + 0.5f * grid.cell.x, at.y + 0.5f * grid.cell.y};
  ImGui::GetWindowDrawList()->AddLine({middle.x - 0.3f * em(), middle.y},
                                      {middle.x + 0.3f * em(), middle.y},
                                      ImGui::GetColorU32(frame.colors.border), 0.1f * em());
  ImGui::Dummy(grid.cell);
}

void draw_cell(const Frame& frame, const Grid& grid, const scene::AdjacencyCell& cell,
               bool hovered) {
  const ImVec2 from = ImGui::GetItemRectMin();
  Look look = look_of(frame, state_of(cell));
  if (hovered) look.border = frame.colors.text;
  draw_box(look, from, ImGui::GetItemRectMax());
  if (!cell.stored) return;
  ImGui::PushFont(frame.fonts.small);
  const float line = ImGui::GetFontSize();
  const float lines = cell.requests > 0 ? 2 : 1;
  ImVec2 at{from.x, from.y + 0.5f * (grid.cell.y - lines * line)};
  draw_centered(at, grid.cell.x, short_bytes(cell.bytes, grid.cell.x - 0.3f * em()), look.text);
  at.y += line;
  if (cell.requests > 0)
    draw_centered(at, grid.cell.x, "\u00d7" + std::to_string(cell.requests), look.text);
  ImGui::PopFont();
}

/// What a click does to a cell, and one with the right button.
void cell_help(const Frame& frame, const scene::AdjacencyCell& cell, int i, int j) {
  std::string help = cell.set ? "Click to let go of it." : "Click to keep it stored.";
  if (const EntityRef centre = centre_for(frame, j); centre.valid() && centre.dimension == i)
    help += " A right click lights up what it gives at " + scene::entity_title(centre) + ".";
  tooltip(help);
}

/// True while the mouse is over it.
bool relation_cell(Frame& frame, const Grid& grid, int i, int j) {
  const scene::Document& document = frame.document();
  const scene::AdjacencyCell cell = scene::adjacency_cell(document.mesh(), i, j);
  const std::string place = std::to_string(i) + " " + std::to_string(j);
  if (ImGui::InvisibleButton(place.c_str(), grid.cell))
    frame.emit("adjacency " + place + (cell.set ? " off" : " on"));
  const bool hovered = ImGui::IsItemHovered();
  draw_cell(frame, grid, cell, hovered);
  if (!hovered) return false;
  const EntityRef centre = centre_for(frame, j);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && centre.valid() && centre.dimension == i)
    frame.emit(neighbours_line(frame, j));
  cell_help(frame, cell, i, j);
  return true;
}

struct Place {
  int i = 0, j = 0;
};

/// The cell under the mouse.
std::optional<Place> table(Frame& frame) {
  const Grid grid = make_grid();
  std::optional<Place> hovered;
  column_titles(frame, grid);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid.gap, grid.gap});
  for (int i = 0; i < 4; ++i) {
    const float left = ImGui::GetCursorPosX();
    const float top = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(top + 0.5f * (grid.cell.y - em()));
    muted(frame, level_names[static_cast<std::size_t>(i)]);
    for (int j = 0; j < 4; ++j) {
      ImGui::SetCursorPos(
          {left + grid.label + static_cast<float>(j) * (grid.cell.x + grid.gap), top});
      if (i == j)
        diagonal_cell(frame, grid);
      else if (relation_cell(frame, grid, i, j))
        hovered = Place{i, j};
    }
  }
  ImGui::PopStyleVar();
  return hovered;
}

void key(const Frame& frame) {
  constexpr std::array<std::pair<State, const char*>, 4> entries = {
      {{State::Set, "Set"},
       {State::Requested, "Requested \u00d7 n"},
       {State::Implied, "Implied"},
       {State::Absent, "Not stored"}}};
  constexpr std::array<const char*, 4> help = {
      "You asked for it, or the mesh was made with it: it stays until you let go of it.",
      "Algorithms and the viewer hold it with n requests: it goes when the last one ends.",
      "Nobody asked for it, but it is all that defines its entities.", "It takes no memory."};
  const float side = 0.7f * em();
  const float column = 0.42f * ImGui::GetContentRegionAvail().x;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k % 2 == 1) ImGui::SameLine(column);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + 0.5f * (em() - side);
    draw_box(look_of(frame, entries[k].first), {at.x, top}, {at.x + side, top + side});
    ImGui::Dummy({side, em()});
    ImGui::SameLine(0, 0.4f * em());
    muted(frame, entries[k].second);
    tooltip(help[k]);
  }
}

void totals(const Frame& frame) {
  const Mesh& mesh = frame.document().mesh();
  const std::size_t adjacency = mesh.adjacency_bytes();
  const std::size_t entities = mesh.entity_bytes();
  const int top = mesh.count(3) > 0 ? 3 : 2;
  if (!begin_values("totals", 2)) return;
  value_row(frame, "Adjacencies", scene::bytes_text(adjacency),
            "All stored relations and hash sets");
  value_row(frame, "Entities", scene::bytes_text(entities), entity_memory_help);
  if (mesh.count(top) > 0)
    value_row(frame, top == 3 ? "Both, per region" : "Both, per face",
              scene::bytes_text((adjacency + entities) / mesh.count(top)),
              "Adjacencies and entities together, divided by the entities of the highest level");
  end_values();
}

/// What the last change came to: a refusal stands out.
void last_change(const Frame& frame) {
  const scene::AdjacencyChange* change = frame.document().last_adjacency_change();
  if (change == nullptr) return;
  std::string words = scene::change_words(frame.document().mesh(), *change);
  if (frame.interactive && change->refusal.empty())
    words += " (" + scene::short_number(change->ms, change->ms < 10 ? 2 : 0) + " ms)";
  ImGui::PushTextWrapPos(0);
  ImGui::PushStyleColor(ImGuiCol_Text,
                        change->refusal.empty() ? frame.colors.text : frame.colors.bad);
  text(words + ".");
  ImGui::PopStyleColor();
  if (!change->refusal.empty()) muted(frame, "Nothing has changed.");
  ImGui::PopTextWrapPos();
}

/// The cell under the mouse, else what lights up, else the one that was changed last.
std::optional<Place> explained_cell(const Frame& frame, const std::optional<Place>& hovered) {
  if (hovered) return hovered;
  const scene::Neighbours* n = frame.session.sheet().inquiry().neighbours();
  if (n && n->level != n->of.dimension) return Place{n->of.dimension, n->level};
  if (const scene::AdjacencyChange* c = frame.document().last_adjacency_change())
    return Place{c->i, c->j};
  return {};
}

/// What is known of one cell. Takes as much room for every cell, so that nothing jumps below.
void explanation(const Frame& frame, const std::optional<Place>& place) {
  const float top = ImGui::GetCursorPosY();
  ImGui::PushTextWrapPos(0);
  if (place)
    text(scene::adjacency_words(frame.document().mesh(), place->i, place->j, frame.interactive));
  else
    muted(frame, "Point at a cell to see how it is stored, for whom, and what it costs.");
  ImGui::PopTextWrapPos();
  const float least = 6 * ImGui::GetTextLineHeight(), used = ImGui::GetCursorPosY() - top;
  if (place && used < least) ImGui::Dummy({1, least - used});
}

}  // namespace

void adjacency_panel(Frame& frame) {
  if (!frame.has_mesh()) return;
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - 1.7f * em());
  muted(frame, "T(I,J): what is stored for each entity of a row. Click a cell to change it.");
  ImGui::PopTextWrapPos();
  copy_button(frame, "adjacency");
  gap(0.1f);
  const std::optional<Place> hovered = table(frame);
  gap(0.1f);
  key(frame);
  gap(0.2f);
  last_change(frame);
  explanation(frame, explained_cell(frame, hovered));
  gap(0.1f);
  totals(frame);
  gap(0.2f);
  tensor_sections(frame);
}

}  // namespace aomd::ui
