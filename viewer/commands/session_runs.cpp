// States that are kept, and what the present mesh is compared with: the mesh as loaded, or one of
// them.

#include "viewer/base/text.h"
#include "viewer/commands/session.h"

namespace aomd::scene {

void Session::keep_run(const std::string& name) {
  const KeptRun& run = runs.keep(document, name, {});
  status = "Kept as " + run.name + ": " + counted(run.faces, "face");
}

void Session::remove_run(unsigned number) {
  runs.remove(document, number);
  if (view.reference == number) view.reference = 0;
}

void Session::start_measuring() {
  come_to_rest();
  std::vector<MeasuredRun> wanted;
  for (const KeptRun& run : runs.rows())
    if (run.number > 0 && !run.distance) wanted.push_back({run.number, run.data, {}});
  if (wanted.empty()) {
    status = "All distances are measured";
    return;
  }
  measurement_ = scene::start_measuring(to_data(document.as_loaded().mesh()),
                                        document.content().bounds.diagonal(), std::move(wanted));
  status = "Measuring distances ...";
}

void Session::cancel_measuring() {
  if (!measurement_) return;
  measurement_.reset();
  status = "Measuring cancelled";
}

void Session::take_measurement(bool wait) {
  const auto measured = take(measurement_, wait);
  if (!measured) return;
  for (const MeasuredRun& each : *measured) runs.set_distance(each.number, each.distance);
  status = "Distances are measured";
}

const KeptRun* Session::reference() const {
  return view.reference == 0 ? nullptr : runs.find(view.reference);
}

std::string Session::reference_name() const {
  const KeptRun* run = reference();
  return run == nullptr ? "as loaded" : run->name;
}

std::int64_t Session::reference_faces() const {
  const KeptRun* run = reference();
  return run == nullptr ? loaded_facts_.faces : run->faces;
}

/// What is drawn of the reference; the mesh as loaded is the document's.
const Mesh& Session::reference_mesh() {
  const KeptRun* run = reference();
  if (run == nullptr) {
    beside_.reset();
    return document.as_loaded().mesh();
  }
  if (!beside_ || beside_number_ != run->number) beside_ = std::make_unique<BesideMesh>(*run->data);
  beside_number_ = run->number;
  return beside_->mesh();
}

void Session::refresh_original() {
  const bool skin = document.content().skin.has_value();
  shows_original_ = (view.original || view.side_by_side) && !skin && document.can_look_back();
  if (view.panels.runs && !skin && document.can_look_back()) runs.keep_original(document);
  if (!shows_original_) return;
  const Mesh& mesh = reference_mesh();
  const KeptRun* run = reference();
  const auto shown = std::pair(document.place().generation, view.reference);
  SurfaceChanges changes;
  changes.everything = drawn_original_ != shown;
  if (changes.everything) original_fields_ = {};
  drawn_original_ = shown;
  FieldSource source{mesh, document, false, run == nullptr || idle(), run == nullptr};
  source.run = run;
  original_fields_.update(view.coloring, source, changes);
  if (fields_.field()) original_fields_.take_scale(*fields_.field());
  original_drawing_.set_field(original_fields_.field());
  original_drawing_.update(mesh, view, changes);
}

}  // namespace aomd::scene
