// Below T(I,J): hash sets, id stacks, strategies.

#include <algorithm>
#include <string>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/explain/id_facts.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

/// "Edges"
std::string title_of(int level) { return capitalized(entity_plural(level)); }

/// A title with a sign that says whether what is below it shows. A click emits `line`. True while
/// it is open.
bool section(Frame& frame, const char* title, bool open, const char* line, const char* help) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushFont(frame.fonts.heading);
  const ImVec2 size{ImGui::CalcTextSize(title).x + 1.1f * em(), em()};
  if (ImGui::InvisibleButton(title, size)) frame.emit(line);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 color = ImGui::GetColorU32(frame.colors.text);
  const float r = 0.26f * em();
  const ImVec2 c{at.x + 0.35f * em(), at.y + 0.5f * em()};
  if (open)
    list.AddTriangleFilled({c.x - r, c.y - 0.6f * r}, {c.x + r, c.y - 0.6f * r}, {c.x, c.y + r},
                           color);
  else
    list.AddTriangleFilled({c.x - 0.6f * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.6f * r, c.y + r},
                           color);
  list.AddText({at.x + 1.1f * em(), at.y}, color, title);
  ImGui::PopFont();
  tooltip(help);
  int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID(title), 0);
  if (open && shown == 0)  // What has just been opened is to be seen.
    ImGui::SetScrollFromPosY(at.y - ImGui::GetWindowPos().y - 0.6f * em(), 0);
  shown = open ? 1 : 0;
  return open;
}

std::string count(std::uint64_t n) { return scene::grouped(n); }

/// A button of the small font at the right end of the present line.
void small_button(Frame& frame, const char* label, const std::string& line, const char* help) {
  ImGui::PushFont(frame.fonts.small);
  const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  same_line_right(width);
  ImGui::PushID(line.c_str());
  if (ImGui::SmallButton(label)) frame.emit(line);
  ImGui::PopID();
  ImGui::PopFont();
  tooltip(help);
}

/// The relation that answers whether an entity exists, where one does.
std::string answered_by(const Mesh& mesh, int level) {
  if (mesh.stored(0, level)) return relation_name(0, level);
  if (level == 2 && mesh.stored(0, 1) && mesh.stored(1, 2)) return "T(0,1) and T(1,2)";
  return {};
}

std::string bar_help(const scene::HashFacts& facts, std::size_t length) {
  const bool last = length + 1 == scene::HashFacts::bars;
  return count(facts.buckets[length]) + " of " + count(facts.statistics.buckets) +
         " buckets hold " + std::to_string(length) +
         (last          ? " entities or more: crowded"
          : length == 1 ? " entity"
                        : " entities");
}

/// One bar for each number of entities in a bucket; the crowded ones warn.
void bucket_bars(const Frame& frame, const scene::HashFacts& facts) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 3.2f * em()};
  const auto most =
      static_cast<float>(*std::max_element(facts.buckets.begin(), facts.buckets.end()));
  const float step = size.x / static_cast<float>(scene::HashFacts::bars);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, {from.x + size.x, from.y + size.y},
                     ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5f));
  for (std::size_t length = 0; length < scene::HashFacts::bars; ++length) {
    const float x = from.x + static_cast<float>(length) * step;
    if (facts.buckets[length] > 0) {
      const float height =
          std::max(1.5f, size.y * static_cast<float>(facts.buckets[length]) / most);
      const bool crowded = length + 1 == scene::HashFacts::bars;
      list.AddRectFilled({x + 1, from.y + size.y - height}, {x + step - 1, from.y + size.y},
                         ImGui::GetColorU32(crowded ? frame.colors.warning : frame.colors.accent));
    }
    ImGui::SetCursorScreenPos({x, from.y});
    ImGui::Dummy({step, size.y});
    tooltip(bar_help(facts, length));
  }
  ImGui::PushFont(frame.fonts.small);
  for (std::size_t length = 0; length < scene::HashFacts::bars; ++length) {
    const std::string number =
        std::to_string(length) + (length + 1 == scene::HashFacts::bars ? "+" : "");
    const float x = from.x + (static_cast<float>(length) + 0.5f) * step;
    list.AddText({x - 0.5f * ImGui::CalcTextSize(number.c_str()).x, from.y + size.y + 0.1f * em()},
                 ImGui::GetColorU32(frame.colors.text_muted), number.c_str());
  }
  ImGui::SetCursorScreenPos({from.x, from.y + size.y});
  ImGui::Dummy({1, 1.1f * em()});
  ImGui::PopFont();
}

/// How near the set is to growing: all of the bar is 20 %, the mark in its middle the limit.
void crowded_bar(const Frame& frame, const scene::HashFacts& facts) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  bar(5 * facts.crowded_share(), ImGui::GetColorU32(frame.colors.warning), 0.4f);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x + 0.5f * width - 1, at.y - 0.15f * em()},
                                            {at.x + 0.5f * width + 1, at.y + 0.55f * em()},
                                            ImGui::GetColorU32(frame.colors.text));
  tooltip(
      "Of the buckets in use, those with 10 entities or more. Past 10 %, the mark in the middle, "
      "the set "
      "grows tenfold.");
}

void growths(const Frame& frame, const scene::HashFacts& facts) {
  if (facts.rehashes.empty()) return wrapped(frame, "It has not grown.");
  for (const EntityHash::Rehash& r : facts.rehashes)
    wrapped(frame, "Grew at " + count(r.entities) + " entities: " + count(r.before) + " -> " +
                       count(r.after) + " buckets");
}

void hash_set(Frame& frame, int level) {
  const Mesh& mesh = frame.document().mesh();
  const scene::HashFacts facts = scene::hash_facts(mesh, level);
  const std::string kind = entity_name(level);
  text(title_of(level));
  if (facts.built)
    small_button(frame, "Release", "hash-sets release " + kind, "Lets go of it.");
  else
    small_button(frame, "Build", "hash-sets build " + kind,
                 "Builds it with about as many buckets as entities.");
  if (!facts.built) {
    const std::string by = answered_by(mesh, level);
    wrapped(frame, by.empty() ? "Not built: the first question whether one exists builds it."
                              : "Not built: " + by + " tells whether one exists.");
    return;
  }
  const EntityHash::Statistics& s = facts.statistics;
  wrapped(frame, count(facts.entities) + " in " + count(s.buckets) + " buckets, " +
                     scene::bytes_text(facts.bytes) + "; how many buckets hold how many:");
  bucket_bars(frame, facts);
  wrapped(frame, "Worst chain " + count(s.worst) + ". Crowded (10 or more): " + count(s.crowded) +
                     " of " + count(s.used) + " in use, " +
                     scene::short_number(100 * facts.crowded_share(), 1) +
                     " %; past 10 % it grows.");
  crowded_bar(frame, facts);
  growths(frame, facts);
}

void hash_sets(Frame& frame) {
  wrapped(frame, "Find an edge, face or region from its vertices where no stored relation can.");
  for (int level = 1; level < 4; ++level)
    if (frame.document().mesh().count(level) > 0) {
      gap(0.1f);
      hash_set(frame, level);
    }
}

/// The ids that the next entities get, the first one first.
std::string stack_words(const scene::IdFacts& facts) {
  if (facts.top.empty()) return "stack empty; next id " + std::to_string(facts.next);
  std::string words = "next ids";
  for (const std::uint32_t id : facts.top) words += " " + std::to_string(id);
  return words + (facts.free > facts.top.size() ? " \u2026" : "");
}

void id_row(const Frame& frame, int level) {
  const scene::IdFacts facts = scene::id_facts(frame.document().mesh(), level);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  muted(frame, title_of(level));
  for (const std::uint32_t n : {facts.alive, facts.free, facts.capacity}) {
    ImGui::TableNextColumn();
    text_right(count(n));
  }
}

void id_stacks(Frame& frame) {
  wrapped(frame, "Deleting pushes an id, creating takes the last one, and undo puts all back.");
  const Mesh& mesh = frame.document().mesh();
  const int top = mesh.count(3) > 0 ? 3 : 2;
  if (!ImGui::BeginTable("ids", 4, ImGuiTableFlags_SizingStretchProp)) return;
  for (const char* title : {"", "alive", "free", "capacity"}) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
    text_right(title);
    ImGui::PopStyleColor();
  }
  for (int level = 0; level <= top; ++level) id_row(frame, level);
  ImGui::EndTable();
  for (int level = 0; level <= top; ++level)
    wrapped(frame, title_of(level) + ": " + stack_words(scene::id_facts(mesh, level)));
}

}  // namespace

void tensor_sections(Frame& frame) {
  const scene::TensorSections& open = frame.session.view.sections;
  const bool hashes = section(frame, "Hash sets", open.hash_sets, "hash-sets toggle",
                              "Which there are, how full, and when they grew.");
  copy_button(frame, "hashes");
  if (hashes) hash_sets(frame);
  const bool ids = section(frame, "Id stacks", open.ids, "ids toggle",
                           "Which ids are free, and which comes next.");
  copy_button(frame, "ids");
  if (ids) id_stacks(frame);
  const bool strategies =
      section(frame, "Strategies", open.strategies, "strategies toggle",
              "The paper's two ways to store adjacencies, measured on this mesh.");
  copy_button(frame, "strategies");
  if (strategies) strategy_section(frame);
}

}  // namespace aomd::ui
