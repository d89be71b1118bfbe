#include <algorithm>
#include <cmath>
#include <string>

#include "viewer/base/text.h"
#include "viewer/document/history_places.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/timeline_controls.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::grouped;

ImU32 kind_color(const Frame& frame, StepKind kind) {
  switch (kind) {
    case StepKind::Collapse:
      return ImGui::GetColorU32(frame.colors.accent);
    case StepKind::Swap:
      return ImGui::GetColorU32(frame.colors.good);
    case StepKind::Smooth:
      return ImGui::GetColorU32(frame.colors.warning);
    case StepKind::Classify:
    case StepKind::Edit:
      break;
  }
  return ImGui::GetColorU32(frame.colors.text_muted);
}

void transport_button(Frame& frame, const char* id, Icon icon, const std::string& line,
                      bool enabled) {
  if (icon_button(id, icon, enabled)) frame.emit(line);
  command_tooltip(line);
  ImGui::SameLine(0, 0.25f * em());
}

void transport(Frame& frame) {
  const scene::Document& document = frame.document();
  const bool back = document.can_undo();
  const bool forward = document.can_redo();
  const bool still = !document.running();
  const bool playing = frame.session.sheet().playing();
  transport_button(frame, "first", Icon::First, "seek 0", back && still);
  transport_button(frame, "back", Icon::Back, "step -1", back && still);
  transport_button(frame, "play", playing ? Icon::Pause : Icon::Play, "play toggle",
                   (back || forward) && still);
  transport_button(frame, "forward", Icon::Forward, "forward",
                   still && (forward || frame.can_decimate()));
  transport_button(frame, "last", Icon::Last, "seek end", forward && still);
  ImGui::Dummy({0.4f * em(), 0});
  ImGui::SameLine();
  transport_button(frame, "undo", Icon::Undo, "undo", back);
  transport_button(frame, "redo", Icon::Redo, "redo", forward);
}

/// "Operation 12 of 345: collapse of edge 678, in sweep"
std::string where(const scene::Document& document) {
  const Journal& journal = document.journal();
  std::string result = scene::place_words(journal);
  result.front() = 'O';
  if (journal.cursor() == 0) return result + (journal.size() == 0 ? "" : ": as loaded");
  const JournalStep& step = journal.step(journal.cursor() - 1);
  result += std::string(": ") + step_name(step.kind);
  if (step.entity.valid())
    result += std::string(" of ") + entity_name(step.entity.dimension) + " " +
              std::to_string(step.entity.index);
  return result + ", in " + document.mark_of(journal.cursor() - 1).label;
}

void where_line(const Frame& frame) {
  ImGui::SameLine(0, em());
  ImGui::AlignTextToFramePadding();
  const std::string line = where(frame.document());
  text(fitted(line, ImGui::GetContentRegionAvail().x));
}

/// One stroke a pixel column: the kind of the operation that stands there, paler where it is not
/// applied.
void draw_operations(const Frame& frame, ImVec2 from, ImVec2 to) {
  const Journal& journal = frame.document().journal();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int width = static_cast<int>(to.x - from.x);
  const auto step_at = [&](int x) {
    return static_cast<std::size_t>(x) * journal.size() / static_cast<std::size_t>(width);
  };
  for (int x = 0; x < width;) {
    const std::size_t step = step_at(x);
    const bool applied = step < journal.cursor();
    const StepKind kind = journal.step(step).kind;
    int end = x + 1;
    while (end < width && journal.step(step_at(end)).kind == kind &&
           (step_at(end) < journal.cursor()) == applied)
      ++end;
    const ImU32 color = kind_color(frame, kind);
    const ImU32 alpha = applied ? 0xd0000000u : 0x48000000u;
    list.AddRectFilled({from.x + static_cast<float>(x), from.y},
                       {from.x + static_cast<float>(end), to.y}, (color & 0x00ffffffu) | alpha);
    x = end;
  }
}

void draw_marks(const Frame& frame, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto size = static_cast<float>(frame.document().journal().size());
  float last = from.x;
  for (const scene::HistoryMark& mark : frame.document().marks()) {
    const float x = from.x + (to.x - from.x) * static_cast<float>(mark.begin) / size;
    if (x - last < 4) continue;  // too close to tell apart
    list.AddLine({x, from.y - 0.18f * em()}, {x, to.y + 0.18f * em()},
                 ImGui::GetColorU32(ImGuiCol_Text, 0.55f));
    last = x;
  }
}

void draw_handle(const Frame& frame, ImVec2 from, ImVec2 to) {
  const Journal& journal = frame.document().journal();
  const float share = static_cast<float>(journal.cursor()) / static_cast<float>(journal.size());
  const float x = from.x + (to.x - from.x) * share;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float w = 0.22f * em();
  const float over = 0.22f * em();
  list.AddRectFilled({x - w, from.y - over}, {x + w, to.y + over},
                     ImGui::GetColorU32(ImGuiCol_Text), w);
  list.AddRect({x - w, from.y - over}, {x + w, to.y + over}, ImGui::GetColorU32(frame.colors.panel),
               w);
}

std::string strip_tooltip(const scene::Document& document, std::size_t step) {
  if (step >= document.journal().size()) return {};
  return "Operation " + grouped(step + 1) + ": " + step_name(document.journal().step(step).kind) +
         ", in " + document.mark_of(step).label + ". Drag to scrub.";
}

void strip(Frame& frame) {
  const Journal& journal = frame.document().journal();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = 1.5f * em();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 from{corner.x + 0.3f * em(), corner.y + 0.3f * em()};
  const ImVec2 to{corner.x + width - 0.3f * em(), corner.y + height - 0.3f * em()};
  ImGui::GetWindowDrawList()->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg),
                                            0.2f * em());
  ImGui::InvisibleButton("strip", {std::max(width, 1.0f), height});
  if (journal.size() == 0) return;
  draw_operations(frame, from, to);
  draw_marks(frame, from, to);
  draw_places(frame, from, to);
  draw_handle(frame, from, to);
  const float share =
      std::clamp((ImGui::GetIO().MousePos.x - from.x) / (to.x - from.x), 0.0f, 1.0f);
  const auto step =
      static_cast<std::size_t>(std::lround(share * static_cast<float>(journal.size())));
  // Where frames are slow the mouse may be somewhere else by the time that it is let go.
  const bool drags = ImGui::IsItemActive() || ImGui::IsItemDeactivated();
  if (drags && !frame.document().running() && step != journal.cursor())
    frame.emit("seek " + std::to_string(step));
  if (ImGui::IsItemActive()) return;
  const std::string place = place_tooltip(frame, from, to);
  tooltip(place.empty() ? strip_tooltip(frame.document(), step) : place);
}

void key_entry(const Frame& frame, StepKind kind, const char* name) {
  const float side = 0.6f * em();
  const ImVec2 c = ImGui::GetCursorScreenPos();
  const float y = c.y + 0.5f * (em() - side);
  ImGui::GetWindowDrawList()->AddRectFilled({c.x, y}, {c.x + side, y + side},
                                            kind_color(frame, kind), 0.15f * em());
  ImGui::Dummy({side, em()});
  ImGui::SameLine(0, 0.35f * em());
  muted(frame, name);
  ImGui::SameLine(0, em());
}

void key_line(Frame& frame) {
  if (frame.document().journal().size() == 0) {
    muted(frame,
          frame.can_decimate()
              ? "Every operation appears here: step, sweep or run, then drag along the strip."
              : frame.document().hindrance());
    return;
  }
  key_entry(frame, StepKind::Collapse, "Collapse");
  key_entry(frame, StepKind::Swap, "Swap");
  key_entry(frame, StepKind::Smooth, "Smooth");
  key_entry(frame, StepKind::Classify, "Classify");
  timeline_controls(frame);
}

}  // namespace

void timeline_panel(Frame& frame) {
  if (!frame.has_mesh()) return;
  transport(frame);
  where_line(frame);
  strip(frame);
  key_line(frame);
}

}  // namespace aomd::ui
