#include "viewer/drawing/field_keeper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/decimate/spacing/curvature.h"
#include "core/mesh/geometry.h"

namespace aomd::scene {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double beyond_share = 0.02;   // of the curvatures, on either side of their scale
constexpr double curvature_span = 1e3;  // at most, from the scale's low to its high
constexpr double rounding =
    1e-9;  // below this, relative to the diagonal of the box, there is nothing
constexpr double least_scale_span = 4;  // at least: what hardly differs should look so

/// Quads and volumes are not decimated: nothing is wanted of them, and they stay where they are.
bool has_field(Coloring coloring, bool skin) {
  if (!is_field(coloring)) return false;
  return !skin || coloring == Coloring::Quality || coloring == Coloring::Curvature;
}

/// Most of the values: outliers would leave all others one colour.
FieldScale curvature_scale(const Mesh& mesh, const Column<Vertex, double>& values,
                           double diagonal) {
  std::vector<double> positive;
  for (const Vertex v : mesh.vertices())
    if (values[v] * diagonal > rounding) positive.push_back(values[v]);
  FieldScale scale;
  scale.logarithmic = true;
  if (positive.empty()) return scale;
  std::sort(positive.begin(), positive.end());
  const auto last = static_cast<double>(positive.size() - 1);
  const auto at = [&](double part) {
    return positive[static_cast<std::size_t>(std::lround(part * last))];
  };
  scale.add(at(1 - beyond_share));
  scale.add(std::max(at(beyond_share), scale.high / curvature_span));
  if (scale.high < least_scale_span * scale.low) {
    const double middle = std::sqrt(scale.low * scale.high), half = std::sqrt(least_scale_span);
    scale.low = middle / half;
    scale.high = middle * half;
  }
  scale.beyond = positive.front() < scale.low || positive.back() > scale.high;
  return scale;
}

template <typename H>
void assign(Column<H, float>& column, const Column<H, double>& values) {
  column.assign(values.size(), unknown);
  for (std::uint32_t i = 0; i < values.size(); ++i) column[H(i)] = static_cast<float>(values[H(i)]);
}

}  // namespace

void FieldKeeper::update(Coloring coloring, const FieldSource& source, SurfaceChanges& changes) {
  if (!has_field(coloring, source.skin)) {
    *this = {};
    return;
  }
  const bool anew = !field_ || field_->kind != coloring;
  if (anew) {
    field_ = std::make_shared<ScalarField>();
    field_->kind = coloring;
    shown_ = field_;
    pending_ = false;
    measured_.clear();
  }
  SurfaceChanges everything;
  everything.everything = true;
  SurfaceChanges& seen = anew ? everything : changes;
  if (coloring == Coloring::Spacing) spacing(source, anew || changes.everything);
  if (coloring == Coloring::Quality) quality(source, seen);
  if (coloring == Coloring::Distance) distance(source, seen);
  if (coloring == Coloring::Curvature) curvature(source, seen);
}

void FieldKeeper::take_scale(const ScalarField& other) {
  if (field_) set_scale(other.scale);
}

void FieldKeeper::set_scale(const FieldScale& scale) {
  if (field_->scale == scale) return;
  field_->scale = scale;
  ++field_->version;
}

void FieldKeeper::spacing(const FieldSource& source, bool anew) {
  if (!anew && options_ == source.document.options_revision()) return;
  options_ = source.document.options_revision();
  Column<Vertex, double> wanted = source.document.wanted_lengths();
  if (source.run != nullptr)
    wanted = closed_up(wanted, std::span<const Vertex>(*source.run->vertices));
  FieldScale scale;
  scale.logarithmic = true;
  for (const Vertex v : source.mesh.vertices()) {
    if (!std::isfinite(wanted[v])) wanted[v] = 0;
    if (wanted[v] > 0) scale.add(wanted[v]);
  }
  assign(field_->vertices, wanted);
  field_->scale = scale;
  ++field_->version;
}

void FieldKeeper::quality(const FieldSource& source, const SurfaceChanges& changes) {
  const Mesh& mesh = source.mesh;
  const auto measure = [&](Face f) {
    const auto v = mesh.triangle(f);
    field_->faces[f] = static_cast<float>(
        smallest_angle_deg(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
  };
  field_->scale.low = 0;
  field_->scale.high = 60;
  if (changes.everything) field_->faces.assign(mesh.capacity(2), unknown);
  if (field_->faces.size() < mesh.capacity(2)) field_->faces.resize(mesh.capacity(2), unknown);
  if (changes.everything)
    for (const Face f : mesh.faces()) measure(f);
  for (const Face f : changes.faces)
    if (mesh.alive(f)) measure(f);
}

void FieldKeeper::distance(const FieldSource& source, SurfaceChanges& changes) {
  const Mesh& mesh = source.mesh;
  if (changes.everything) {
    field_->faces.assign(mesh.capacity(2), source.as_loaded ? 0 : unknown);
    measured_.clear();
  }
  if (source.as_loaded) return;
  if (field_->faces.size() < mesh.capacity(2)) field_->faces.resize(mesh.capacity(2), unknown);
  for (const Face f : changes.faces)
    if (f.index < field_->faces.size()) field_->faces[f] = unknown;
  if (!changes.nothing()) pending_ = true, next_ = 0;
  if (pending_ && source.still && measure_distances(source)) take_distances(mesh, changes);
}

/// Goes on for the budget. True where all are known.
bool FieldKeeper::measure_distances(const FieldSource& source) {
  constexpr std::size_t between_checks = 32;
  const auto start = std::chrono::steady_clock::now();
  AsLoaded& original = source.document.copy_mesh_as_loaded();
  const double percent = 100 / source.document.content().bounds.diagonal();
  std::size_t made = 0;
  for (; next_ < source.mesh.capacity(2); ++next_) {
    const Face f(next_);
    if (!source.mesh.alive(f) || !std::isnan(field_->faces[f])) continue;
    const bool check = source.budget && ++made % between_checks == 0;
    if (check && std::chrono::steady_clock::now() - start > *source.budget) return false;
    const double distance =
        original.has(source.mesh, f) ? 0 : percent * face_distance(source.mesh, f, original.tree());
    field_->faces[f] = distance > 100 * rounding ? static_cast<float>(distance) : 0;
    measured_.push_back(f);
  }
  return true;
}

/// The colours change all at once, with their scale.
void FieldKeeper::take_distances(const Mesh& mesh, SurfaceChanges& changes) {
  FieldScale scale;
  scale.map = ColorMap::Magma;
  scale.add(0);
  for (const Face f : mesh.faces()) scale.add(field_->faces[f]);
  set_scale(scale);
  if (!changes.everything)
    changes.faces.insert(changes.faces.end(), measured_.begin(), measured_.end());
  measured_.clear();
  pending_ = false;
}

void FieldKeeper::curvature(const FieldSource& source, const SurfaceChanges& changes) {
  pending_ = pending_ || !changes.nothing();
  if (!pending_ || !source.still) return;
  pending_ = false;
  const double diagonal = source.document.content().bounds.diagonal();
  // One scale for before and after, that of before.
  if (source.as_loaded) {
    AsLoaded& original = source.document.copy_mesh_as_loaded();
    assign(field_->vertices, original.curvatures());
    field_->scale = curvature_scale(original.mesh(), original.curvatures(), diagonal);
  } else {
    const Column<Vertex, double> values = vertex_curvatures(source.mesh);
    assign(field_->vertices, values);
    if (source.skin)
      field_->scale = curvature_scale(source.mesh, values, diagonal);
    else
      field_->scale = curvature_scale(source.document.copy_mesh_as_loaded().mesh(),
                                      source.document.copy_mesh_as_loaded().curvatures(), diagonal);
  }
  ++field_->version;
}

}  // namespace aomd::scene
