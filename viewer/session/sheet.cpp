#include "viewer/session/sheet.h"

#include <utility>

#include "viewer/base/text.h"
#include "viewer/drawing/ground.h"
#include "viewer/drawing/openness.h"

namespace aomd::scene {
namespace {

bool wants_histograms(const View& view) {
  return view.marked || (view.panels.side && view.panels.page == Page::Histograms);
}

}  // namespace

Sheet::Sheet(DocumentOptions& options, const View& view, std::unique_ptr<LoadedMesh> loaded)
    : document(options, std::move(loaded)), view_(view) {
  if (document.empty()) return;
  drawing_.set_bounds(document.content().bounds);
  refresh(false, {});
  loaded_facts_ = facts();
}

void Sheet::refresh(bool undisturbed, std::optional<std::chrono::microseconds> budget) {
  if (document.empty()) return;
  undisturbed_ = undisturbed;
  budget_ = budget;
  if (document.content().skin)
    refresh_skin();
  else
    refresh_surface();
  refresh_openness();
  refresh_ground();
  const bool can_keep = document.hindrance().empty() && document.can_look_back();
  if (view_.panels.runs && can_keep) runs.keep_original(document);
  reference_.update(document, runs.reference(), view_, fields_, still() && coloured());
}

const Mesh& Sheet::drawn_mesh() const {
  return skin_.surface() != nullptr ? skin_.surface()->mesh : document.mesh();
}

/// While the mesh is on its way vertices keep what they had.
void Sheet::refresh_openness() {
  if (!view_.occlusion) {
    openness_.reset();
    openness_of_.reset();
    if (drawing_.has_openness()) drawing_.set_openness(drawn_mesh(), {});
    return;
  }
  if (still() && openness_of_ != document.place()) {
    openness_of_ = document.place();
    const Drawable& drawable = drawing_.drawable();
    openness_ = std::make_unique<Background<std::vector<std::uint8_t>>>(
        [source = openness_source(drawn_mesh(), drawable.corners.values(), drawable.origin)](
            const std::stop_token& stop, std::atomic<double>&) { return openness(source, stop); });
  }
  if (auto found = take(openness_, !budget_))
    drawing_.set_openness(drawn_mesh(), std::move(*found));
}

void Sheet::refresh_ground() {
  Drawable& drawable = drawing_.drawable();
  if (!view_.ground) {
    drawable.ground.clear();
    ground_of_.reset();
    return;
  }
  const auto wanted = std::pair(drawable.corners.revision(), view_.camera.up_axis);
  if (busy() || ground_of_ == wanted) return;
  ground_of_ = wanted;
  drawable.ground_bounds = draw_ground(drawable, view_.camera.up_axis, drawable.ground);
}

/// Edges of tetrahedra are judged, and states compared, once all is there that decimation takes.
bool Sheet::asks() const {
  return view_.coloring == Coloring::Verdict || view_.coloring == Coloring::Spacing ||
         view_.coloring == Coloring::Distance || view_.original || view_.side_by_side ||
         document.answers_about(selection.single());
}

/// While the mesh is on its way no more often than takes a fifth of the time: much may be anew.
void Sheet::refresh_skin() {
  using Clock = std::chrono::steady_clock;
  constexpr int rest = 4;
  const auto start = Clock::now();
  if (document.running() && start < skin_due_) {
    selection.drop_dead(document.mesh());
    inquiry_.point_at_nothing();
    return;
  }
  if (asks()) document.prepare();
  draw_skin();
  const auto end = Clock::now();
  skin_due_ = end + rest * (end - start);
}

void Sheet::draw_skin() {
  const VolumeChanges of_mesh = read_volume_changes();
  FieldSource source = field_source();
  SkinSource skin = skin_source(document);
  source.changed = !of_mesh.nothing();
  skin.field = fields_.update_inside(view_.coloring, source);
  SkinKeeper::Changes found = skin_.update(skin, view_, of_mesh, drawing_);
  SurfaceChanges& changes = found.surface;
  if (found.mesh) count_volume(of_mesh);
  picker_.note(changes);
  if (found.inside) picker_.forget_cells();
  drawing_.set_whole_faces(false);
  const Mesh& drawn = skin_.surface()->mesh;
  source.skin = skin_.surface();
  source.regions = of_mesh.regions;
  refresh_field(source, changes);
  verdicts_.note_volume(document, view_, of_mesh, busy());
  verdicts_.judge_skin(document, *skin_.surface(), budget_, busy(), drawing_, !changes.nothing());
  drawing_.update(drawn, view_, changes);
  const bool marks = refresh_marked_cells();
  refresh_selection(found.mesh || changes.everything, found.inside || marks);
}

/// What patches need is stored once a volume is prepared.
VolumeChanges Sheet::read_volume_changes() {
  const LoadedMesh& content = document.content();
  if (content.prepared)
    return volume_changes_.read(content.mesh, content.journal, document.place());
  VolumeChanges changes;
  changes.everything = !skin_.current(document.place());
  return changes;
}

void Sheet::count_volume(const VolumeChanges& changes) {
  const LoadedMesh& content = document.content();
  if (!content.volume()) {
    SurfaceChanges everything;
    everything.everything = true;
    return facts_.update(content.mesh, everything);
  }
  if (changes.everything)
    volume_facts_.start(content.mesh, skin_source(document).whole());
  else
    volume_facts_.update(content.mesh, changes);
  facts_.set(volume_facts_.facts());
}

void Sheet::refresh_surface() {
  SurfaceChanges found = changes_.read(document.mesh(), document.journal(), document.place());
  const bool changed = !found.nothing();
  facts_.update(document.mesh(), found);
  picker_.note(found);
  drawing_.set_whole_faces(true);
  refresh_field(field_source(), found);
  texture_.update(document, view_, found, still(), budget_.has_value());
  drawing_.set_texture(texture_.texture());
  verdicts_.update(document, view_, found, busy(), drawing_);
  drawing_.update(document.mesh(), view_, found);
  verdicts_.judge(document, budget_, busy(), drawing_);
  refresh_marks(changed);
  const auto focus = view_.operation ? document.focus() : std::nullopt;
  if (focus != drawn_focus_ || view_.step_sides != drawn_sides_ || changed ||
      view_.marked != drawn_mark_) {
    drawing_.highlight_step(document.mesh(), document.journal(), focus, view_.step_sides);
    drawn_focus_ = focus;
    drawn_sides_ = view_.step_sides;
    drawn_mark_ = view_.marked;
  }
  refresh_selection(changed);
}

FieldSource Sheet::field_source() {
  FieldSource source{document.mesh(), document};
  source.still = still() && document.can_look_back();
  source.budget = budget_;
  source.choice = view_.scale_choice();
  return source;
}

void Sheet::refresh_field(const FieldSource& source, SurfaceChanges& changes) {
  fields_.update(view_.coloring, source, changes);
  drawing_.set_field(fields_.field());
}

/// What the marked bar counts, of a mesh that has `changed` or not; none where that is as it was.
std::optional<std::vector<EntityRef>> Sheet::newly_marked(bool changed) {
  const bool anew = histograms_.update(document, runs.reference(), wants_histograms(view_),
                                       still() && coloured());
  if (!anew && !changed && view_.marked == drawn_mark_) return {};
  const bool known = view_.marked && histograms_.current(document.place());
  return known ? histograms_.histograms()->counted_in(*view_.marked) : std::vector<EntityRef>();
}

/// True where others are marked than before.
bool Sheet::refresh_marked_cells() {
  auto marked = newly_marked(false);
  if (!marked) return false;
  drawn_mark_ = view_.marked;
  marked_cells_ = std::move(*marked);
  return true;
}

void Sheet::refresh_marks(bool changed) {
  auto marked = newly_marked(changed);
  if (marked && (view_.marked || drawn_mark_))
    drawing_.set_marked(document.mesh(), std::move(*marked));
}

std::vector<EntityRef> Sheet::measure_counted_in(const MarkedBar& bar) {
  histograms_.update(document, runs.reference(), true, true);
  return histograms_.histograms()->counted_in(bar);
}

std::string Sheet::reference_name() const {
  const KeptRun* run = runs.reference();
  return run == nullptr ? "as loaded" : run->name;
}

std::string Sheet::reference_size() const {
  const KeptRun* run = runs.reference();
  const bool volume = loaded_facts_.regions > 0;
  const std::int64_t loaded = volume ? loaded_facts_.regions : loaded_facts_.faces;
  return counted(run == nullptr ? loaded : run->cells, volume ? "region" : "face");
}

}  // namespace aomd::scene
