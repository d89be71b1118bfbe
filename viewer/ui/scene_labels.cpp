#include "viewer/ui/scene_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mesh/derive.h"
#include "viewer/drawing/picking.h"
#include "viewer/drawing/selection_drawing.h"
#include "viewer/explain/entity_facts.h"
#include "viewer/explain/measures.h"
#include "viewer/ui/scales.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::size_t most_labels = 80;

/// The plates of one picture: none lies on another.
class Plates {
 public:
  explicit Plates(const Frame& frame) : frame_(frame) {}
  void add(const ImVec2& middle, const std::string& words);

 private:
  struct Plate {
    ImVec2 from, to;
  };
  const Frame& frame_;
  std::vector<Plate> taken_;
};

void Plates::add(const ImVec2& middle, const std::string& words) {
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const ImVec2 pad{0.3f * em(), 0.08f * em()};
  const ImVec2 from{std::round(middle.x - 0.5f * size.x), std::round(middle.y - 0.5f * size.y)};
  const Plate plate{{from.x - pad.x, from.y - pad.y},
                    {from.x + size.x + pad.x, from.y + size.y + pad.y}};
  const auto overlaps = [&](const Plate& p) {
    return p.from.x < plate.to.x && plate.from.x < p.to.x && p.from.y < plate.to.y &&
           plate.from.y < p.to.y;
  };
  if (std::any_of(taken_.begin(), taken_.end(), overlaps)) return;
  taken_.push_back(plate);
  ImVec4 back = frame_.colors.panel;
  back.w = 0.88f;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(plate.from, plate.to, ImGui::GetColorU32(back), 0.25f * em());
  list.AddText(from, ImGui::GetColorU32(frame_.colors.text), words.c_str());
}

/// Where an entity's middle is on the picture.
ImVec2 place_of(const scene::Projector& project, const Mesh& mesh, EntityRef e,
                const Area& viewport) {
  const glm::dvec2 p = project(scene::middle_of(mesh, e));
  return {viewport.position.x + static_cast<float>(p.x),
          viewport.position.y + viewport.size.y - static_cast<float>(p.y)};
}

/// The selected entity and what lights up around it.
std::vector<EntityRef> labelled_neighbours(const scene::Neighbours& neighbours) {
  std::vector<EntityRef> all{neighbours.of};
  all.insert(all.end(), neighbours.entities.begin(), neighbours.entities.end());
  if (all.size() > most_labels) all.resize(most_labels);
  return all;
}

/// Vertices first: they are the last to be left out.
void add_all(const Mesh& mesh, std::vector<EntityRef>& all) {
  for (int level = 0; level < 3; ++level)
    for (std::uint32_t id = 0; id < mesh.capacity(level) && all.size() < most_labels; ++id)
      if (mesh.alive({level, id})) all.emplace_back(level, id);
}

/// What decides about the collapse that is previewed, where something does.
EntityRef deciding(const scene::Session& session) {
  const scene::EntityVerdict* judgement = session.sheet().inquiry().verdict();
  if (judgement == nullptr ||
      session.sheet().inquiry().previewed_way(session.view) >= judgement->ways.size())
    return {};
  return judgement->ways[session.sheet().inquiry().previewed_way(session.view)]
      .outlook.verdict.entity;
}

/// What is selected, what decides about it, and what lies around the mouse.
std::vector<EntityRef> labelled(const scene::Session& session) {
  const scene::Neighbours* neighbours = session.sheet().inquiry().neighbours();
  if (neighbours && neighbours->known && !session.view.labels_everywhere)
    return labelled_neighbours(*neighbours);
  std::vector<EntityRef> all;
  const auto selected = session.sheet().selection.entities();
  const std::size_t count = std::min(selected.size(), most_labels);
  all.assign(selected.begin(), selected.begin() + static_cast<std::ptrdiff_t>(count));
  if (const EntityRef e = deciding(session); e.valid()) all.push_back(e);
  if (const auto* inspection = session.sheet().inquiry().facts())
    for (const scene::AdjacentLevel& level : inspection->adjacent)
      for (const std::uint32_t id : level.ids) all.emplace_back(level.level, id);
  const Mesh& mesh = session.document().mesh();
  if (const auto* hovered = session.sheet().inquiry().hovered();
      hovered && !session.document().content().skin) {
    std::vector<std::uint32_t> ids;
    for (int level = 0; level < 3; ++level) {
      if (level == hovered->entity.dimension) continue;
      adjacent(mesh, hovered->entity, level, ids);
      for (const std::uint32_t id : ids) all.emplace_back(level, id);
    }
  }
  if (session.view.labels_everywhere && !session.document().content().skin) add_all(mesh, all);
  if (all.size() > most_labels) all.resize(most_labels);
  return all;
}

void id_labels(Frame& frame, const scene::Projector& project, const Area& viewport) {
  const Mesh& mesh = frame.document().mesh();
  ImGui::PushFont(frame.fonts.small);
  Plates plates(frame);
  for (const EntityRef e : labelled(frame.session)) {
    if (!mesh.alive(e)) continue;
    const ImVec2 at = place_of(project, mesh, e, viewport);
    const bool inside = at.x >= viewport.position.x && at.y >= viewport.position.y &&
                        at.x <= viewport.position.x + viewport.size.x &&
                        at.y <= viewport.position.y + viewport.size.y;
    const float raised = e.dimension == 0 ? 0.9f * em() : 0;  // the dot stays free
    if (inside) plates.add({at.x, at.y - raised}, scene::entity_label(e));
  }
  ImGui::PopFont();
}

/// The middle of a plate, or so far above it that the plate leaves the area free.
ImVec2 above(const Area& taken, ImVec2 middle, ImVec2 words) {
  const ImVec2 half{0.5f * words.x + 0.4f * em(), 0.5f * words.y + 0.2f * em()};
  const bool beside =
      middle.x + half.x < taken.position.x || middle.x - half.x > taken.position.x + taken.size.x ||
      middle.y + half.y < taken.position.y || middle.y - half.y > taken.position.y + taken.size.y;
  if (!beside) middle.y = taken.position.y - half.y;
  return middle;
}

void draw_ruler_labels(const Frame& frame, const scene::Projector& project, const Area& viewport) {
  const Mesh& mesh = frame.document().mesh();
  Plates plates(frame);
  const Area taken = length_scale_area(frame, viewport);
  for (const auto& ruler : scene::rulers_of(frame.session.sheet().selection)) {
    const glm::dvec2 p = project(0.5 * (mesh.position(ruler[0]) + mesh.position(ruler[1])));
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    const std::string words = scene::ruler_text(mesh, ruler);
    const ImVec2 at{viewport.position.x + static_cast<float>(p.x),
                    viewport.position.y + viewport.size.y - static_cast<float>(p.y)};
    plates.add(above(taken, at, ImGui::CalcTextSize(words.c_str())), words);
  }
}

/// The top and the bottom of the preview of what the mouse points at; both 0 where there is none.
ImVec2 previewed_rows(const Frame& frame, const scene::Projector& project, const Area& viewport) {
  const scene::Drawable& drawable = frame.session.sheet().drawing().drawable();
  const auto corners = drawable.preview.faces.values();
  if (corners.empty() || frame.session.sheet().inquiry().hovered_words().empty() ||
      frame.session.sheet().inquiry().neighbours())
    return {0, 0};
  ImVec2 rows{std::numeric_limits<float>::max(), 0};
  for (const scene::Corner& corner : corners) {
    const glm::dvec2 p = project(glm::dvec3(corner.position) + drawable.origin);
    const float y = viewport.position.y + viewport.size.y - static_cast<float>(p.y);
    rows = {std::min(rows.x, y), std::max(rows.y, y)};
  }
  return rows;
}

/// Below or above what is previewed, where there is room.
float beside_preview(float y, float height, const ImVec2& rows, const Area& viewport) {
  const float gap = 0.5f * em();
  if (y > rows.y || y + height < rows.x) return y;
  if (rows.y + gap + height < viewport.position.y + viewport.size.y) return rows.y + gap;
  return rows.x - gap - height > viewport.position.y ? rows.x - gap - height : y;
}

/// Beside the mouse, on the side where there is room.
void hover_label(const Frame& frame, const scene::Projector& project, const scene::Hovered& hovered,
                 const Area& viewport) {
  const Mesh& mesh = frame.document().mesh();
  const std::string title = scene::entity_title(hovered.entity) + ", " +
                            scene::model_words(mesh.classification(hovered.entity));
  const float width = viewport.size.x;
  const float wrap = std::min(22 * em(), std::max(0.6f * width, std::min(12 * em(), 0.9f * width)));
  const std::string words = broken_at_blanks(frame.session.sheet().inquiry().hovered_words(), wrap);
  const ImVec2 first = ImGui::CalcTextSize(title.c_str());
  const ImVec2 second = words.empty() ? ImVec2(0, 0) : ImGui::CalcTextSize(words.c_str());
  const ImVec2 pad{0.5f * em(), 0.3f * em()};
  const ImVec2 size{std::max(first.x, second.x) + 2 * pad.x, first.y + second.y + 2 * pad.y};
  const float x =
      viewport.position.x + 0.5f * viewport.size.x * static_cast<float>(1 + hovered.place.x);
  const float y =
      viewport.position.y + 0.5f * viewport.size.y * static_cast<float>(1 - hovered.place.y);
  ImVec2 from{x + 1.1f * em(), y + 0.9f * em()};
  from.x = std::min(from.x, viewport.position.x + viewport.size.x - size.x - 0.3f * em());
  if (from.y + size.y > viewport.position.y + viewport.size.y) from.y = y - 0.6f * em() - size.y;
  from.x = std::max(from.x, viewport.position.x);
  from.y = beside_preview(from.y, size.y, previewed_rows(frame, project, viewport), viewport);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImVec4 back = frame.colors.panel;
  back.w = 0.94f;
  list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(back),
                     0.3f * em());
  list.AddRect(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(frame.colors.border),
               0.3f * em());
  list.AddText({from.x + pad.x, from.y + pad.y}, ImGui::GetColorU32(frame.colors.text),
               title.c_str());
  list.AddText({from.x + pad.x, from.y + pad.y + first.y},
               ImGui::GetColorU32(frame.colors.text_muted), words.c_str());
}

}  // namespace

void ruler_labels(const Frame& frame, const Area& viewport) {
  if (!frame.has_mesh() || viewport.size.x < 2) return;
  scene::View view = frame.session.view;
  view.aspect = double{viewport.size.x} / viewport.size.y;
  view.height_px = viewport.size.y;
  draw_ruler_labels(frame, {view, frame.document().content().bounds}, viewport);
}

void scene_labels(Frame& frame, const Area& viewport) {
  if (!frame.has_mesh() || viewport.size.x < 2) return;
  const scene::Projector project(frame.session.view, frame.document().content().bounds);
  if (frame.session.view.labels || frame.session.sheet().inquiry().neighbours())
    id_labels(frame, project, viewport);
  draw_ruler_labels(frame, project, viewport);
  const auto* hovered = frame.session.sheet().inquiry().hovered();
  if (hovered != nullptr && !frame.session.view.menu)
    hover_label(frame, project, *hovered, viewport);
}

void selection_box(const Frame& frame, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImVec4 fill = frame.colors.accent;
  fill.w = 0.15f;
  const ImVec2 low{std::min(from.x, to.x), std::min(from.y, to.y)};
  const ImVec2 high{std::max(from.x, to.x), std::max(from.y, to.y)};
  list.AddRectFilled(low, high, ImGui::GetColorU32(fill));
  list.AddRect(low, high, ImGui::GetColorU32(frame.colors.accent));
}

}  // namespace aomd::ui
