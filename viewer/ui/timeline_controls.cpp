#include "viewer/ui/timeline_controls.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::Bookmark;
using scene::grouped;
using scene::HistoryBranch;
using scene::HistoryTree;
using scene::PlaySpeed;

float x_of(const Frame& frame, std::size_t step, ImVec2 from, ImVec2 to) {
  const auto size = static_cast<float>(frame.document().journal().size());
  return from.x + (to.x - from.x) * std::min(1.0f, static_cast<float>(step) / size);
}

/// A list that drops down from a text of its own; `width` wide.
void drop_down(const char* id, const std::string& shown, float width, const char* help,
               const std::function<void()>& rows) {
  ImGui::SetNextItemWidth(width);
  if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLarge)) return tooltip(help);
  rows();
  ImGui::EndCombo();
}

void row(Frame& frame, const std::string& label, const std::string& line, bool present = false) {
  if (ImGui::Selectable(label.c_str(), present) && !present) frame.emit(line);
}

void speeds(Frame& frame) {
  const PlaySpeed& now = frame.session.view.play_speed;
  for (const double seconds : {6.0, 12.0, 30.0, 60.0}) {
    const PlaySpeed speed{0, seconds};
    row(frame, speed.words(), "play-speed whole " + scene::short_number(seconds), speed == now);
  }
  for (const double per_s : {1.0, 5.0, 20.0, 100.0, 500.0, 2000.0, 10000.0}) {
    const PlaySpeed speed{per_s, now.whole_s};
    row(frame, speed.words(), "play-speed " + scene::short_number(per_s), speed == now);
  }
}

void bookmarks(Frame& frame) {
  const HistoryTree& tree = frame.document().tree();
  row(frame, "Set one here", "bookmark");
  command_tooltip("bookmark");
  if (tree.bookmarks().empty()) return;
  ImGui::Separator();
  for (const Bookmark& b : tree.bookmarks()) {
    const std::string where = b.branch == 0 ? "" : ", branch " + std::to_string(b.branch);
    row(frame, b.name + ": operation " + grouped(b.step) + where,
        "seek bookmark " + scene::as_rest(b.name));
  }
  ImGui::Separator();
  for (const Bookmark& b : tree.bookmarks())
    row(frame, "Remove " + b.name, "bookmark remove " + scene::as_rest(b.name));
}

std::string branch_words(const HistoryTree& tree, const HistoryBranch& b) {
  return "Branch " + std::to_string(b.id) + ": " + scene::counted(b.size(), "operation") +
         ", leaves branch " + std::to_string(b.from == 0 ? tree.present() : b.from) + " at " +
         grouped(b.fork);
}

void branches(Frame& frame) {
  const HistoryTree& tree = frame.document().tree();
  row(frame,
      "Branch " + std::to_string(tree.present()) + ": " +
          scene::counted(frame.document().journal().size(), "operation") + ", the present one",
      "", true);
  for (const HistoryBranch& b : tree.branches())
    row(frame, branch_words(tree, b), "branch switch " + std::to_string(b.id));
  ImGui::Separator();
  for (const HistoryBranch& b : tree.branches())
    row(frame,
        "Remove branch " + std::to_string(b.id) + " (" + scene::bytes_text(b.part.bytes()) + ")",
        "branch remove " + std::to_string(b.id));
}

/// Where the line of a branch ends: as long as its own operations, at least so that it is seen.
float end_of(const Frame& frame, const HistoryBranch& b, ImVec2 from, ImVec2 to) {
  const float begin = x_of(frame, b.fork, from, to);
  return std::min(to.x, std::max(begin + 0.7f * em(), x_of(frame, b.size(), from, to)));
}

}  // namespace

void timeline_controls(Frame& frame) {
  const HistoryTree& tree = frame.document().tree();
  const float wide = 12.5f * em(), narrow = 8.5f * em(), space = 0.5f * em();
  const bool branched = !tree.branches().empty();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.5f * em(), 0.12f * em()});
  same_line_right(wide + (branched ? 2 : 1) * (narrow + space));
  const std::size_t marks = tree.bookmarks().size();
  drop_down("##bookmarks", marks == 0 ? "Bookmarks" : scene::counted(marks, "bookmark"), narrow,
            "Named places of the history: go there, or name the present one (Ctrl+B).",
            [&] { bookmarks(frame); });
  ImGui::SameLine(0, space);
  if (branched) {
    drop_down("##branches", grouped(tree.branches().size() + 1) + " branches", narrow,
              "What was ahead where something new was done is kept. Choosing a branch goes back to "
              "where it "
              "leaves and forward to its end.",
              [&] { branches(frame); });
    ImGui::SameLine(0, space);
  }
  drop_down("##speed", frame.session.view.play_speed.words(), wide,
            "How fast the history is played, in operations a second or as a whole. Full stop is "
            "faster, comma "
            "slower.",
            [&] { speeds(frame); });
  ImGui::PopStyleVar();
}

void draw_places(const Frame& frame, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 line = ImGui::GetColorU32(frame.colors.text_muted);
  for (const HistoryBranch& b : frame.document().tree().branches()) {
    if (b.from != 0) continue;
    const float x = x_of(frame, b.fork, from, to), y = to.y + 0.38f * em();
    list.AddLine({x, from.y}, {x, y}, line, 1.5f);
    list.AddLine({x - 0.75f, y}, {end_of(frame, b, from, to), y}, line, 2.5f);
  }
  const ImU32 flag = ImGui::GetColorU32(frame.colors.warning);
  for (const Bookmark& b : frame.document().tree().bookmarks()) {
    if (b.branch != 0) continue;
    const float x = x_of(frame, b.step, from, to), top = from.y - 0.5f * em();
    list.AddLine({x, top}, {x, to.y}, flag, 1.5f);
    const float length = (x + 0.6f * em() > to.x ? -0.6f : 0.6f) * em();
    list.AddTriangleFilled({x, top}, {x + length, top + 0.24f * em()}, {x, top + 0.48f * em()},
                           flag);
  }
}

std::string place_tooltip(const Frame& frame, ImVec2 from, ImVec2 to) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const HistoryTree& tree = frame.document().tree();
  for (const Bookmark& b : tree.bookmarks()) {
    const float x = x_of(frame, b.step, from, to);
    if (b.branch == 0 && mouse.y < from.y && mouse.x > x - 0.3f * em() && mouse.x < x + 0.7f * em())
      return "Bookmark " + b.name + ": operation " + grouped(b.step);
  }
  for (const HistoryBranch& b : tree.branches())
    if (b.from == 0 && mouse.y > to.y && mouse.x > x_of(frame, b.fork, from, to) - 2 &&
        mouse.x < end_of(frame, b, from, to) + 2)
      return branch_words(tree, b);
  return {};
}

}  // namespace aomd::ui
