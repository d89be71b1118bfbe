#include "viewer/drawing/field_keeper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/decimate/spacing/curvature.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/geometry.h"
#include "viewer/base/sort_once.h"

namespace aomd::scene {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double beyond_share = 0.02;   // of the curvatures, on either side of their scale
constexpr double curvature_span = 1e3;  // at most, from the scale's low to its high
constexpr double rounding =
    1e-9;  // below this, relative to the diagonal of the box, there is nothing
constexpr double least_scale_span = 4;  // at least: what hardly differs should look so
constexpr double regular_angle_deg = 60;
constexpr double regular_dihedral_deg = 70.52877936550931;  // acos(1/3)

/// What is not decimated stays where it is, and nothing is wanted of it.
bool has_field(Coloring coloring, const Document& document) {
  if (!is_field(coloring)) return false;
  return document.hindrance().empty() || coloring == Coloring::Quality ||
         coloring == Coloring::Curvature;
}

/// Of all vertices, to colour a mesh or a kept state of it.
Column<Vertex, double> wanted_at(const FieldSource& source) {
  Column<Vertex, double> wanted = source.document.wanted_lengths();
  if (source.run == nullptr) return wanted;
  return closed_up(wanted, std::span<const Vertex>(*source.run->vertices));
}

/// Faces that are as they were, with a region behind them that is not.
void add_bounded(const FieldSource& source, SurfaceChanges& changes) {
  const SkinSurface& skin = *source.skin;
  VertexBuffer buffer;
  for (const Region r : source.regions) {
    if (!source.mesh.alive(r)) continue;
    for (const std::uint32_t v : source.mesh.vertices_of(r, buffer)) {
      const Vertex drawn = v < skin.drawn.size() ? skin.drawn[Vertex(v)] : Vertex();
      if (!drawn.valid()) continue;
      for (const Face f : skin.mesh.row<2>(drawn))
        if (skin.regions[f.index] == r) changes.faces.push_back(f);
    }
  }
  sort_once(changes.faces);
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

FieldScale angle_scale(double high_deg) {
  FieldScale scale;
  scale.low = 0;
  scale.high = high_deg;
  return scale;
}

template <typename H>
void assign(Column<H, float>& column, const Column<H, double>& values) {
  column.assign(values.size(), unknown);
  for (std::uint32_t i = 0; i < values.size(); ++i) column[H(i)] = static_cast<float>(values[H(i)]);
}

}  // namespace

const std::shared_ptr<const ScalarField>& FieldKeeper::update_inside(Coloring coloring,
                                                                     const FieldSource& source) {
  const bool known = source.volume() && has_field(coloring, source.document) &&
                     (coloring == Coloring::Quality || coloring == Coloring::Spacing);
  const bool anew = known && (!inside_ || inside_->kind != coloring);
  if (!known) inside_.reset();
  if (anew) inside_ = std::make_shared<ScalarField>();
  shown_inside_ = inside_;
  if (!known) return shown_inside_;
  inside_->kind = coloring;
  if (coloring == Coloring::Spacing) spacing(source, anew);
  if (coloring == Coloring::Quality) usual_ = angle_scale(regular_dihedral_deg);
  unsettled_ = unsettled_ || anew || source.changed;
  settle_scale(source, *inside_);
  return shown_inside_;
}

void FieldKeeper::update(Coloring coloring, const FieldSource& source, SurfaceChanges& changes) {
  if (!has_field(coloring, source.document)) {
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
    if (!inside_) usual_ = {};
  }
  SurfaceChanges everything;
  everything.everything = true;
  SurfaceChanges& seen = anew ? everything : changes;
  unsettled_ = unsettled_ || !seen.nothing();
  if (coloring == Coloring::Spacing && inside_)
    spacing_of_skin(*source.skin, seen);
  else if (coloring == Coloring::Spacing)
    spacing(source, anew || changes.everything);
  if (coloring == Coloring::Quality) quality(source, seen);
  if (coloring == Coloring::Distance) distance(source, seen);
  if (coloring == Coloring::Curvature) curvature(source, seen);
  settle_scale(source, *field_);
}

/// As it is chosen; the skin's is that of the volume.
void FieldKeeper::settle_scale(const FieldSource& source, ScalarField& field) {
  const ScaleChoice choice = source.choice != nullptr ? *source.choice : ScaleChoice();
  const bool as_before = !unsettled_ && choice == settled_ && usual_ == settled_usual_;
  FieldScale scale = as_before ? field.scale : usual_;
  if (source.like != nullptr)
    scale = source.like->scale;
  else if (inside_ && &field != inside_.get())
    scale = inside_->scale;
  else if (choice != ScaleChoice() && !as_before)
    scale = chosen_scale(usual_, choice, values_of(source, field));
  settled_ = choice;
  settled_usual_ = usual_;
  unsettled_ = false;
  if (field.scale == scale) return;
  field.scale = scale;
  ++field.version;
}

/// Regions are measured only for this.
std::vector<float> FieldKeeper::values_of(const FieldSource& source, const ScalarField& field) {
  const auto of_column = [](const auto& column, auto&& entities) {
    std::vector<float> values;
    for (const auto e : entities)
      if (e.index < column.size()) values.push_back(column[e]);
    return values;
  };
  if (field.by_face()) return of_column(field.faces, source.drawn().faces());
  if (field.vertices.size() > 0) return of_column(field.vertices, source.drawn().vertices());
  std::vector<float> values;
  for (const Region r : source.mesh.regions())
    values.push_back(static_cast<float>(measure::smallest_dihedral_deg(source.mesh, r)));
  return values;
}

/// Of what is drawn, or of all of a volume.
void FieldKeeper::spacing(const FieldSource& source, bool anew) {
  if (!anew && options_ == source.document.options_revision()) return;
  options_ = source.document.options_revision();
  Column<Vertex, double> wanted = wanted_at(source);
  FieldScale scale;
  scale.logarithmic = true;
  for (const Vertex v : source.mesh.vertices()) {
    if (!std::isfinite(wanted[v])) wanted[v] = 0;
    if (wanted[v] > 0) scale.add(wanted[v]);
  }
  ScalarField& field = inside_ ? *inside_ : *field_;
  assign(field.vertices, wanted);
  usual_ = scale;
  ++field.version;
}

/// All of it where the volume's is another one than before.
void FieldKeeper::spacing_of_skin(const SkinSurface& skin, const SurfaceChanges& changes) {
  const bool anew = changes.everything || inside_version_ != inside_->version;
  if (field_->vertices.size() < skin.mesh.capacity(0))
    field_->vertices.resize(skin.mesh.capacity(0), unknown);
  const auto take = [&](Vertex v) {
    if (skin.mesh.alive(v)) field_->vertices[v] = inside_->vertices[skin.vertices[v.index]];
  };
  if (anew)
    for (const Vertex v : skin.mesh.vertices()) take(v);
  else
    for (const Vertex v : changes.vertices) take(v);
  if (inside_version_ != inside_->version) ++field_->version;
  inside_version_ = inside_->version;
}

/// Of a face, or of the region behind it.
void FieldKeeper::measure_quality(const FieldSource& source, Face face) {
  const Mesh& mesh = source.drawn();
  if (source.volume()) {
    const Region behind = source.skin->regions[face.index];
    field_->faces[face] =
        behind.valid() ? static_cast<float>(measure::smallest_dihedral_deg(source.mesh, behind))
                       : unknown;
    return;
  }
  const auto v = mesh.triangle(face);
  field_->faces[face] = static_cast<float>(
      smallest_angle_deg(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
}

void FieldKeeper::quality(const FieldSource& source, SurfaceChanges& changes) {
  const Mesh& mesh = source.drawn();
  usual_ = angle_scale(source.volume() ? regular_dihedral_deg : regular_angle_deg);
  if (changes.everything) field_->faces.assign(mesh.capacity(2), unknown);
  if (field_->faces.size() < mesh.capacity(2)) field_->faces.resize(mesh.capacity(2), unknown);
  if (changes.everything)
    for (const Face f : mesh.faces()) measure_quality(source, f);
  else if (source.volume())
    add_bounded(source, changes);
  for (const Face f : changes.faces)
    if (mesh.alive(f)) measure_quality(source, f);
}

void FieldKeeper::distance(const FieldSource& source, SurfaceChanges& changes) {
  const Mesh& mesh = source.drawn();
  if (changes.everything) {
    field_->faces.assign(mesh.capacity(2), source.as_loaded && !source.skin ? 0 : unknown);
    measured_.clear();
  }
  if (source.as_loaded && !source.skin) return;
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
  const Mesh& mesh = source.drawn();
  std::size_t made = 0;
  for (; next_ < mesh.capacity(2); ++next_) {
    const Face f(next_);
    if (!mesh.alive(f) || !std::isnan(field_->faces[f])) continue;
    const bool check = source.budget && ++made % between_checks == 0;
    if (check && std::chrono::steady_clock::now() - start > *source.budget) return false;
    field_->faces[f] = measure_distance(source, f);
    measured_.push_back(f);
  }
  return true;
}

/// In percent of the diagonal. Of a volume each model face is held against itself.
float FieldKeeper::measure_distance(const FieldSource& source, Face face) {
  AsLoaded& original = source.document.copy_mesh_as_loaded();
  const Mesh& mesh = source.drawn();
  if (!source.skin && original.has(mesh, face)) return 0;
  const TriangleTree* tree =
      source.skin ? original.tree_of(mesh.classification(face)) : &original.tree();
  if (tree == nullptr) return unknown;
  const double percent = 100 / source.document.content().bounds.diagonal();
  const double distance = percent * face_distance(mesh, face, *tree);
  return distance > 100 * rounding ? static_cast<float>(distance) : 0;
}

/// The colours change all at once, with their scale.
void FieldKeeper::take_distances(const Mesh& mesh, SurfaceChanges& changes) {
  FieldScale scale;
  scale.map = ColorMap::Magma;
  scale.add(0);
  for (const Face f : mesh.faces()) scale.add(field_->faces[f]);  // fmax passes over unknown ones
  usual_ = scale;
  unsettled_ = true;
  if (!changes.everything)
    changes.faces.insert(changes.faces.end(), measured_.begin(), measured_.end());
  measured_.clear();
  pending_ = false;
}

void FieldKeeper::curvature(const FieldSource& source, const SurfaceChanges& changes) {
  pending_ = pending_ || !changes.nothing();
  if (!pending_ || !source.still) return;
  pending_ = false;
  unsettled_ = true;
  const double diagonal = source.document.content().bounds.diagonal();
  // One scale for before and after, that of before.
  if (source.as_loaded && !source.skin) {
    AsLoaded& original = source.document.copy_mesh_as_loaded();
    assign(field_->vertices, original.curvatures());
    usual_ = curvature_scale(original.mesh(), original.curvatures(), diagonal);
  } else {
    const Column<Vertex, double> values = vertex_curvatures(source.drawn());
    assign(field_->vertices, values);
    if (source.skin)
      usual_ = curvature_scale(source.drawn(), values, diagonal);
    else
      usual_ = curvature_scale(source.document.copy_mesh_as_loaded().mesh(),
                               source.document.copy_mesh_as_loaded().curvatures(), diagonal);
  }
  ++field_->version;
}

}  // namespace aomd::scene
