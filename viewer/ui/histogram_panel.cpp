#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/drawing/histogram_keeper.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using measure::Histogram;
using scene::grouped;
using scene::HistogramKind;

/// How one quantity is named.
struct Words {
  HistogramKind kind;
  const char* command;  ///< of `mark`
  std::string title, help;
  const char* things;
  const char* unit;
  const char* worst;  ///< which end is worst
  bool worst_is_least;
  bool whole;       ///< its values are whole numbers, a bin each
  bool open_above;  ///< what is larger counts in the last bin
};

std::array<Words, 3> words_of(const scene::Histograms& all) {
  const Words angle =
      all.volume
          ? Words{HistogramKind::Angle,
                  "angle",
                  "Smallest dihedral angle",
                  "The smallest angle between two sides of each region; 70.5 degrees in a regular "
                  "tetrahedron, 90 in a cube.",
                  "regions",
                  "\u00b0",
                  "worst",
                  true,
                  false,
                  true}
          : Words{HistogramKind::Angle,
                  "angle",
                  "Smallest angle",
                  "The smallest angle of each face; 60 degrees in a regular triangle.",
                  "faces",
                  "\u00b0",
                  "worst",
                  true,
                  false,
                  true};
  const char* lengths =
      all.wanted_lengths
          ? "The length of each edge over the mean spacing at its ends: 1 is as long as it should "
            "be."
          : "The length of each edge over the mean length of the edges as loaded: the present "
            "options give no spacing.";
  return {angle,
          {HistogramKind::Length, "length",
           all.wanted_lengths ? "Edge length / spacing" : "Edge length / mean", lengths, "edges",
           "", "longest", false, false, true},
          {HistogramKind::Valence, "valence", "Edges at a vertex",
           "The valence: 6 inside a regular surface of triangles, 4 at its border.", "vertices", "",
           "most", false, true, true}};
}

std::string bin_text(const Words& words, const Histogram& h, std::size_t bin) {
  const bool last = bin + 1 == h.counts.size();
  std::string low = scene::short_number(h.bound(bin), 2);
  if (last && words.open_above) return low + words.unit + " and more";
  if (words.whole) return low;
  return low + " to " + scene::short_number(h.bound(bin + 1), 2) + words.unit;
}

double share(const Histogram& h, std::size_t bin) {
  return h.total == 0 ? 0 : static_cast<double>(h.counts[bin]) / static_cast<double>(h.total);
}

std::string count_text(const Words& words, const Histogram& h, std::size_t bin) {
  return grouped(h.counts[bin]) + " of " + grouped(h.total) + " " + words.things + " (" +
         scene::short_number(100 * share(h, bin), 1) + " %)";
}

/// Where the bars of one chart stand.
struct Chart {
  ImVec2 from, to;
  std::size_t bins = 1;
  double highest = 1;

  [[nodiscard]] float x(std::size_t bin) const {
    return from.x + (to.x - from.x) * static_cast<float>(bin) / static_cast<float>(bins);
  }
  [[nodiscard]] float y(double part) const {
    return to.y - (to.y - from.y) * static_cast<float>(part / highest);
  }
};

ImU32 before_color(const Frame& frame) { return ImGui::GetColorU32(frame.colors.text_muted); }

ImU32 now_color(const Frame& frame, bool pointed_at) {
  ImVec4 color = frame.colors.accent;
  color.w = pointed_at ? 1.0f : 0.72f;
  return ImGui::GetColorU32(color);
}

void draw_bars(const Frame& frame, const Chart& chart, const Histogram& now,
               std::optional<std::size_t> marked) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t bin = 0; bin < now.counts.size(); ++bin) {
    if (marked == bin)
      list.AddRectFilled({chart.x(bin), chart.from.y}, {chart.x(bin + 1), chart.to.y},
                         ImGui::GetColorU32(ImGuiCol_Text, 0.14f));
    if (now.counts[bin] == 0) continue;
    // However few they are, they are seen.
    const float top = std::min(chart.y(share(now, bin)), chart.to.y - 1.5f);
    list.AddRectFilled({chart.x(bin) + 0.5f, top}, {chart.x(bin + 1) - 0.5f, chart.to.y},
                       now_color(frame, marked == bin));
  }
}

/// The outline of the bars as loaded, where there is something in them.
void draw_steps(const Frame& frame, const Chart& chart, const Histogram& before) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float half = std::max(0.5f, std::round(0.05f * em()));
  const auto line = [&](ImVec2 a, ImVec2 b) {
    list.AddRectFilled({std::min(a.x, b.x) - half, std::min(a.y, b.y) - half},
                       {std::max(a.x, b.x) + half, std::max(a.y, b.y) + half}, before_color(frame));
  };
  const float bottom = std::round(chart.to.y);
  float last = bottom;
  for (std::size_t bin = 0; bin <= before.counts.size(); ++bin) {
    const bool end = bin == before.counts.size();
    const float x = std::round(chart.x(bin));
    const float y = end ? bottom : std::round(chart.y(share(before, bin)));
    if (y != last) line({x, last}, {x, y});
    if (!end && before.counts[bin] > 0) line({x, y}, {std::round(chart.x(bin + 1)), y});
    last = y;
  }
}

void axis_numbers(const Frame& frame, const Words& words, const Histogram& h) {
  const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
  const auto put = [&](float at, const std::string& text, float align) {
    ImGui::SetCursorPosX(
        left + std::clamp(at * width - align * ImGui::CalcTextSize(text.c_str()).x, 0.0f, width));
    muted(frame, text);
  };
  ImGui::PushFont(frame.fonts.small);
  if (words.whole) {
    const auto bins = static_cast<float>(h.counts.size());
    for (std::size_t bin = 0; bin < h.counts.size(); bin += 2) {
      if (bin > 0) ImGui::SameLine();
      const bool last = bin + 1 == h.counts.size();
      put((static_cast<float>(bin) + 0.5f) / bins,
          scene::short_number(h.bound(bin), 0) + (last ? "+" : ""), 0.5f);
    }
  } else {
    // Whole numbers, also where the range depends on the mesh.
    const double step = std::ceil(h.high / (words.unit[0] != 0 ? 3 : 4));
    for (double value = 0; value <= h.high; value += step) {
      if (value > 0) ImGui::SameLine();
      const auto part = static_cast<float>(value / h.high);
      put(part, scene::short_number(value, 0) + words.unit, part);
    }
  }
  ImGui::PopFont();
}

/// What one of the two came to, behind the sign that it is drawn with.
void numbers_line(const Frame& frame, const Words& words, const Histogram& h, bool now) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float side = 0.7f * em(), y = at.y + 0.5f * ImGui::GetTextLineHeight();
  if (now)
    list.AddRectFilled({at.x, y - 0.5f * side}, {at.x + side, y + 0.5f * side},
                       now_color(frame, false));
  else
    list.AddRectFilled({at.x, y - 0.06f * em()}, {at.x + side, y + 0.06f * em()},
                       before_color(frame));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.1f * em());
  const double worst = words.worst_is_least ? h.least : h.largest;
  std::string line = (now ? "now" : frame.session.sheet().reference_name()) + ": ";
  if (h.total == 0)
    line += "none";
  else
    line += "mean " + scene::significant(h.mean) + words.unit + ", " + words.worst + " " +
            scene::significant(worst) + words.unit;
  muted(frame, fitted(line, ImGui::GetContentRegionAvail().x));
}

std::optional<std::size_t> marked_bin(const Frame& frame, const Words& words, const Histogram& h) {
  const auto& marked = frame.session.view.marked;
  if (!marked || marked->kind != words.kind) return {};
  return h.bin(marked->value);
}

/// What the mouse is over: says it, and brightens it in the picture. A click selects it.
bool point_at(Frame& frame, const Words& words, const scene::Histograms& all, const Chart& chart) {
  if (!ImGui::IsItemHovered()) return false;
  const scene::HistogramPair& pair = all.of(words.kind);
  const float part = (ImGui::GetIO().MousePos.x - chart.from.x) / (chart.to.x - chart.from.x);
  const auto bin = static_cast<std::size_t>(
      std::clamp(part * static_cast<float>(chart.bins), 0.0f, static_cast<float>(chart.bins - 1)));
  std::string text = bin_text(words, pair.now, bin) + "\nnow: " + count_text(words, pair.now, bin);
  if (all.changed)
    text +=
        "\n" + frame.session.sheet().reference_name() + ": " + count_text(words, pair.before, bin);
  tooltip(text + "\nClick to select them.");
  const double middle = 0.5 * (pair.now.bound(bin) + pair.now.bound(bin + 1));
  const std::string bar = std::string(words.command) + " " + scene::short_number(middle, 4);
  if (ImGui::IsItemClicked() && !frame.document().running()) frame.emit("select bar " + bar);
  if (marked_bin(frame, words, pair.now) != bin) frame.emit("mark " + bar);
  return true;
}

/// True while one of its bars is pointed at.
bool chart(Frame& frame, const Words& words, const scene::Histograms& all, float height) {
  const scene::HistogramPair& pair = all.of(words.kind);
  heading(frame, words.title.c_str());
  tooltip(words.help);
  Chart chart;
  chart.from = ImGui::GetCursorScreenPos();
  chart.to = {chart.from.x + ImGui::GetContentRegionAvail().x, chart.from.y + height};
  chart.bins = pair.now.counts.size();
  chart.highest = 1e-9;
  for (std::size_t bin = 0; bin < chart.bins; ++bin)
    chart.highest = std::max(
        {chart.highest, share(pair.now, bin), all.changed ? share(pair.before, bin) : 0.0});
  ImGui::InvisibleButton(words.command, {chart.to.x - chart.from.x, height});
  const bool pointed_at = point_at(frame, words, all, chart);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(chart.from, chart.to, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5f));
  draw_bars(frame, chart, pair.now, marked_bin(frame, words, pair.now));
  if (all.changed) draw_steps(frame, chart, pair.before);
  axis_numbers(frame, words, pair.now);
  numbers_line(frame, words, pair.now, true);
  if (all.changed) numbers_line(frame, words, pair.before, false);
  gap(0.3f);
  return pointed_at;
}

std::string percent_text(double percent) {
  const double shown = std::abs(percent) < 0.00005 ? 0 : percent;
  return (shown > 0 ? "+" : "") + scene::short_number(shown, 4) + " %";
}

void region_row(Frame& frame, const scene::RegionChange& region, bool changed) {
  const ModelRef model = region.now.model.valid() ? region.now.model : region.before.model;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string name = scene::model_entity_text(model);
  const bool on = frame.session.view.highlighted == model && model.valid();
  const std::string label = model.valid() ? scene::model_entity_label(model) : "Unclassified";
  if (ImGui::Selectable(label.c_str(), on) && !name.empty())
    frame.emit(on ? "highlight" : "highlight " + name);
  tooltip("Click to highlight it.");
  ImGui::TableNextColumn();
  text_right(scene::grouped(region.now.count));
  if (changed)
    tooltip(frame.session.sheet().reference_name() + ": " + scene::grouped(region.before.count));
  ImGui::TableNextColumn();
  text_right(scene::significant(region.now.volume));
  tooltip(scene::short_number(region.now.volume, 9) + " cubed units of the mesh" +
          (changed ? "; " + frame.session.sheet().reference_name() + ": " +
                         scene::short_number(region.before.volume, 9)
                   : std::string()));
  if (!changed) return;
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, region.large() ? frame.colors.bad : frame.colors.text_muted);
  text_right(percent_text(region.percent()));
  ImGui::PopStyleColor();
  tooltip(region.large() ? "More than 0.1 %: decimation with --volume keep allows less."
                         : "Change of the volume.");
}

/// Model regions: how many regions of the mesh, what volume, how that changed.
void region_table(Frame& frame, const scene::Histograms& all) {
  heading(frame, "Volumes by region");
  tooltip("What each model region holds, and how its volume has changed; in red above 0.1 %.");
  const int columns = all.changed ? 4 : 3;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.25f * em(), 0.12f * em()));
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  const float rows = static_cast<float>(all.regions.size()) + 1.2f;
  const float height = std::min(rows * (ImGui::GetTextLineHeight() + 0.24f * em()),
                                ImGui::GetContentRegionAvail().y);
  if (ImGui::BeginTable("regions", columns, flags, {0, std::max(height, 3 * em())})) {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Region", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("Count");
    ImGui::TableSetupColumn("Volume");
    if (all.changed) ImGui::TableSetupColumn("Change");
    ImGui::TableHeadersRow();
    for (const scene::RegionChange& region : all.regions) region_row(frame, region, all.changed);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

/// What is left when titles and numbers have their places, for `charts`.
float chart_height(int charts, bool changed) {
  const float lines = (changed ? 4.6f : 3.4f) * ImGui::GetTextLineHeight();
  const float left = ImGui::GetContentRegionAvail().y / static_cast<float>(charts) - lines -
                     5 * ImGui::GetStyle().ItemSpacing.y;
  return std::clamp(left, 2.2f * em(), 6.5f * em());
}

}  // namespace

void histogram_panel(Frame& frame, HistogramDrafts& drafts) {
  const scene::Histograms* all = frame.session.sheet().histograms();
  if (all == nullptr) {
    muted(frame, frame.has_mesh() ? "Counted when nothing runs." : "No mesh yet.");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0.2f * em()});
  const int charts = all->volume ? 1 : 3;
  const float height = chart_height(charts, all->changed);
  const std::array<Words, 3> words = words_of(*all);
  bool pointing = false;
  for (int i = 0; i < charts; ++i)
    pointing = chart(frame, words[static_cast<std::size_t>(i)], *all, height) || pointing;
  if (all->volume) region_table(frame, *all);
  ImGui::PopStyleVar();
  if (drafts.pointing && !pointing && frame.session.view.marked) frame.emit("mark off");
  drafts.pointing = pointing;
}

}  // namespace aomd::ui
