#include "viewer/document/loaded_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.h"
#include "core/decimate/spacing/spacing.h"
#include "core/fields/seams.h"
#include "core/io/io.h"
#include "core/io/notes.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "viewer/base/sort_once.h"
#include "viewer/document/saved_work.h"

namespace aomd::scene {
namespace {

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.triangle(f)) box.add(mesh.position(v));
  const glm::dvec3 center = box.center();
  double radius = 0;
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.triangle(f))
      radius = std::max(radius, glm::length(mesh.position(v) - center));
  box.set_radius(radius);
  return box;
}

void remember_file_classes(LoadedMesh& loaded) {
  for (int dim = 0; dim < 3; ++dim) {
    auto& classes = loaded.file_classes[static_cast<std::size_t>(dim)];
    classes.resize(loaded.mesh.capacity(dim));
    for (std::uint32_t id = 0; id < classes.size(); ++id)
      if (loaded.mesh.alive({dim, id})) classes[id] = loaded.mesh.classification({dim, id});
  }
}

/// Scanners and modellers write y up, machine shops (STL) and engineers (volumes) z up.
UpAxis usual_up_axis(io::Format format) {
  const bool y = format == io::Format::Ply || format == io::Format::Obj ||
                 format == io::Format::Off || format == io::Format::Gltf;
  return y ? UpAxis::Y : UpAxis::Z;
}

bool needs_skin(const Mesh& mesh) {
  if (mesh.count(3) > 0) return true;
  for (const Face f : mesh.faces())
    if (mesh.shape(f) != Shape::Triangle) return true;
  return false;
}

void find_obstacle(LoadedMesh& loaded) {
  if (const char* why = decimation_obstacle(loaded.mesh))
    loaded.obstacle = why;
  else if (first_repeated_region(loaded.mesh))
    loaded.obstacle = "Two regions have the same vertices: aomd check names them.";
  for (const Region r : loaded.mesh.regions())
    loaded.stays += loaded.mesh.shape(r) != Shape::Tetrahedron;
}

/// Among the first `listed` ids, those that the file brought.
bool has_inner_faces(const Mesh& mesh, std::uint32_t listed) {
  for (std::uint32_t id = 0; id < listed; ++id)
    if (mesh.alive(Face(id)) && mesh.classification(Face(id)).dimension() == 3) return true;
  return false;
}

void take_seams(const MeshData& data, LoadedMesh& loaded) {
  const std::vector<fields::NamedSeams> seams = fields::named_seams(data);
  loaded.classify_options.seams = fields::all_edges(seams);
  for (const fields::NamedSeams& seam : seams) {
    VertexSeams found{seam.array, {}};
    for (const auto& [a, b] : seam.edges)
      found.vertices.insert(found.vertices.end(), {Vertex(a), Vertex(b)});
    sort_once(found.vertices);
    if (!found.vertices.empty()) loaded.seams.push_back(std::move(found));
  }
}

void prepare_surface(LoadedMesh& loaded) {
  loaded.classified = classify(loaded.mesh, loaded.classify_options);
  loaded.needs = request_for_drawing(loaded.mesh);
}

}  // namespace

std::unique_ptr<LoadedMesh> make_loaded(const MeshData& data, std::string name,
                                        const ClassifyOptions& options) {
  auto loaded = std::make_unique<LoadedMesh>();
  loaded->name = std::move(name);
  loaded->mesh = Mesh(data);
  if (data.classified()) remember_file_classes(*loaded);
  loaded->classify_options = options;
  loaded->corners = data.corners;
  loaded->remarks = data.remarks;
  loaded->appearance = data.appearance;
  Mesh& mesh = loaded->mesh;
  if (!loaded->volume()) take_seams(data, *loaded);
  if (!loaded->volume()) prepare_surface(*loaded);
  // Going through a volume takes its time and all its faces: only where the file says nothing.
  if (loaded->volume() && !data.classified()) loaded->classified = classify(mesh, options);
  if (needs_skin(mesh)) {
    loaded->skin.emplace(mesh);
    find_obstacle(*loaded);
  }
  mesh.keep_class_lists(true);
  loaded->bounds = loaded->skin ? loaded->skin->bounds() : box_of(mesh);
  mesh.attach(&loaded->journal);
  loaded->revision = mesh.revision();
  return loaded;
}

namespace {

/// Names the arrays that a Mesh does not hold, so that they are not lost in silence.
void note_arrays_lost(const MeshData& data, LoadedMesh& loaded) {
  std::array<std::set<std::string>, 4> held;
  for (int dim = 0; dim <= 3; ++dim)
    for (const auto& column : loaded.mesh.attached(dim))
      held[static_cast<std::size_t>(dim)].insert(column->name());
  io::detail::ItemList lost;
  for (const Attribute& a : data.attributes)
    if (!held[static_cast<std::size_t>(a.dimension)].contains(a.name))
      lost.add("attribute " + shown(a.name));
  io::detail::note_left_out(loaded.notes, lost);
}

std::unique_ptr<LoadedMesh> load_source(const LoadRequest& request) {
  if (request.data) return make_loaded(*request.data, request.sample, request.classify);
  if (request.file.empty())
    return make_loaded(make_sample(request.sample, request.sample_size), request.sample,
                       request.classify);
  const std::optional<FileStamp> stamp = stamp_of(request.file);
  io::ReadResult result = io::read(request.file);
  if (result.mesh.faces.empty() && result.mesh.regions.empty())
    throw io::ReadError(request.file.string(), {}, "there are no faces or regions in it");
  auto loaded = make_loaded(result.mesh, request.file.filename().string(), request.classify);
  loaded->file = request.file;
  loaded->stamp = stamp;
  loaded->notes = std::move(result.notes);
  note_arrays_lost(result.mesh, *loaded);
  loaded->up = usual_up_axis(result.format);
  return loaded;
}

/// Puts the history, nothing of it applied, into a mesh that has just been loaded from the work's
/// source. Throws io::ReadError when the mesh is not the one that the history starts from.
void restore_history(LoadedMesh& loaded, const SavedWork& work) {
  if (loaded.volume()) prepare_volume(loaded);
  io::JournalFile file = io::read_journal(work.journal);
  io::check_journal(file, work.journal.string(), loaded.mesh);
  if (file.journal.size() != work.steps)
    throw io::ReadError(work.journal.string(), {},
                        "the journal is not as long as " + work.file.string() + " says");
  const auto words = file.journal.words();
  const auto steps = file.journal.steps();
  loaded.journal.restore({words.begin(), words.end()}, {steps.begin(), steps.end()});
}

}  // namespace

// The journal is attached again at once: it holds nothing, so that it follows from here on.
void prepare_volume(LoadedMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  const bool whole = mesh.complete(2);
  const std::uint32_t listed = mesh.capacity(2);
  mesh.attach(nullptr);
  ClassifyOptions options = loaded.classify_options;
  options.keep_present = true;
  if (loaded.classified_by_file()) loaded.classified = classify(mesh, options);
  if (!whole && !has_inner_faces(mesh, listed)) mesh.keep_model_faces_only();
  mesh.attach(&loaded.journal);
  if (loaded.source.recoverable) loaded.start = io::fingerprint(mesh);
  loaded.needs = request_for_patches(mesh);
  loaded.prepared = true;
  prepare_lengths(loaded);
  if (loaded.skin) loaded.skin.emplace(whole_skin(loaded));
}

void prepare_lengths(LoadedMesh& loaded) {
  if (loaded.edge_lengths.size() > 0 || (loaded.skin && !loaded.prepared)) return;
  loaded.edge_lengths = evaluate_spacing(loaded.mesh, {SpacingByFactor{1}, {}});
}

Skin whole_skin(const LoadedMesh& loaded) {
  const bool fast = loaded.prepared && is_of_tetrahedra(loaded.mesh);
  return fast ? Skin::of_tetrahedra(loaded.mesh, {}) : Skin(loaded.mesh);
}

std::unique_ptr<LoadedMesh> load(const LoadRequest& request) {
  auto loaded = load_source(request);
  loaded->source = request;
  if (request.recoverable && !loaded->skin) loaded->start = io::fingerprint(loaded->mesh);
  if (request.work) restore_history(*loaded, *request.work);
  return loaded;
}

}  // namespace aomd::scene
