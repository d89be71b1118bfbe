// The models of a document: a CAD file, or the mesh as it was before it was decimated.

#include <algorithm>

#include "core/model/gmsh_model.h"
#include "core/model/mesh_on_model.h"
#include "viewer/document/document.h"

namespace aomd::scene {
namespace {

GivenModel read_model(const std::filesystem::path& file) {
  GivenModel given;
  given.file = file;
  given.model = load_gmsh_model(file.string());
  for (int dim = 0; dim <= 3; ++dim)
    given.counts[static_cast<std::size_t>(dim)] = given.model->entities(dim).size();
  return given;
}

bool fits(const Mesh& mesh, const Model& model) {
  try {
    check_against(mesh, model);
    return true;
  } catch (const ModelError&) {
    return false;
  }
}

}  // namespace

/// The step after which the present classification has held: 0, or the end of a command that
/// classifies.
std::size_t Document::classified_at() const {
  const std::size_t cursor = journal().cursor();
  for (auto mark = marks_.rbegin(); mark != marks_.rend(); ++mark) {
    if (mark->begin >= cursor || !changes_classes(mark->label)) continue;
    const std::size_t end = mark == marks_.rbegin() ? journal().size() : (mark - 1)->begin;
    return std::min(end, cursor);
  }
  return 0;
}

bool Document::lies_on_model() const {
  return model() != nullptr && model()->fits_from == classified_at();
}

/// Undo, or a feature angle, may have taken the mesh off the model since it was given.
void Document::fit_to(GivenModel& given) {
  prepare();
  if (given.fits_from == classified_at()) return;
  Mesh& mesh = loaded_->mesh;
  try {
    if (loaded_->classified_by_file())
      check_against(mesh, *given.model);
    else if (!fits(mesh, *given.model))
      record("classify", [&] {
        classify_on(mesh, *given.model);
        stale_ = loaded_->decimation.has_value();
        forget_fits();
      });
  } catch (const ModelError& error) {
    throw ModelError(given.file.string() + ": " + error.what());
  }
  given.fits_from = classified_at();
}

void Document::set_model(const std::filesystem::path& file) {
  GivenModel given = read_model(file);
  fit_to(given);
  let_go_of_models();
  loaded_->model = std::move(given);
}

void Document::drop_model() {
  if (!model()) return;
  let_go_of_models();
  loaded_->model.reset();
}

void Document::set_snapping(bool on) {
  if (on == snaps()) return;
  cancel_run();
  options_.snaps = on;
}

const Model* Document::model_to_snap_to() {
  if (!snaps()) return nullptr;
  if (loaded_->model) return loaded_->model->model.get();
  if (!loaded_->original || loaded_->original->step != classified_at()) make_original();
  return loaded_->original->model.get();
}

/// The facets of the mesh as it was where the present classification began.
void Document::make_original() {
  const std::size_t step = classified_at();
  let_go_of_models();
  visit(step, [&] {
    loaded_->original = {step, std::make_unique<const DiscreteModel>(loaded_->mesh)};
  });
}

/// A new classification may end at a step where another one did before.
void Document::forget_fits() {
  if (loaded_->model) loaded_->model->fits_from.reset();
  let_go_of_models();
  loaded_->original.reset();
}

/// Before a model that the decimation may point at goes.
void Document::let_go_of_models() {
  cancel_run();
  if (!loaded_->decimation) return;
  DecimationOptions without = loaded_->decimation->options();
  without.model = nullptr;
  loaded_->decimation->set_options(without);
}

}  // namespace aomd::scene
