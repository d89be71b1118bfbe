#include "viewer/commands/look_lines.h"

#include <array>

#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

/// In the order of Page.
constexpr std::array<std::string_view, 4> pages = {"decimation", "adjacency", "histograms",
                                                   "selection"};

void add_side(const Panels& panels, std::vector<std::string>& lines) {
  const std::string name(pages[static_cast<std::size_t>(panels.page)]);
  if (panels.page != Panels().page) lines.push_back("panel " + name + " on");
  if (!panels.side) lines.push_back("panel " + name + " off");
}

}  // namespace

std::vector<std::string> look_lines(const View& view) {
  const Panels& panels = view.panels;
  std::vector<std::string> lines;
  if (view.theme == Theme::Dark) lines.emplace_back("theme dark");
  if (view.text_scale != 1) lines.push_back("text-size " + short_number(100 * view.text_scale, 4));
  if (view.occlusion) lines.emplace_back("show occlusion on");
  if (view.ground) lines.emplace_back("show ground on");
  add_side(panels, lines);
  if (!panels.mesh) lines.emplace_back("panel mesh off");
  if (!panels.timeline) lines.emplace_back("panel timeline off");
  if (panels.runs) lines.emplace_back("panel runs on");
  if (panels.mesh_ems > 0) lines.push_back("panel-width mesh " + short_number(panels.mesh_ems, 6));
  if (panels.side_ems > 0) lines.push_back("panel-width side " + short_number(panels.side_ems, 6));
  return lines;
}

}  // namespace aomd::scene
