#include "viewer/scene/loaded_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/io/io.h"
#include "core/samples/samples.h"

namespace aomd::scene {
namespace {

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.triangle(f)) box.add(mesh.position(v));
  const glm::dvec3 center = box.center();
  double radius = 0;
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.triangle(f)) radius = std::max(radius, glm::length(mesh.position(v) - center));
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

}  // namespace

std::unique_ptr<LoadedMesh> make_loaded(const MeshData& data, std::string name,
                                        const ClassifyOptions& options) {
  auto loaded = std::make_unique<LoadedMesh>();
  loaded->name = std::move(name);
  loaded->mesh = Mesh(data);
  if (data.classified()) remember_file_classes(*loaded);
  loaded->classify_options = options;
  loaded->classified = classify(loaded->mesh, options);
  Mesh& mesh = loaded->mesh;
  loaded->needs = {mesh.request(2, 0), mesh.request(0, 1), mesh.request(0, 2)};
  mesh.keep_class_lists(true);
  loaded->bounds = box_of(mesh);
  mesh.attach(&loaded->journal);
  return loaded;
}

std::unique_ptr<LoadedMesh> load(const LoadRequest& request) {
  if (request.file.empty())
    return make_loaded(make_sample(request.sample, request.sample_size), request.sample, request.classify);
  io::ReadResult result = io::read(request.file);
  if (result.mesh.faces.empty()) throw io::ReadError(request.file.string(), {}, "there are no faces in it");
  auto loaded = make_loaded(result.mesh, request.file.filename().string(), request.classify);
  loaded->file = request.file;
  loaded->notes = std::move(result.notes);
  // Scanners and modellers write y up, machine shops (STL) z up.
  loaded->up = result.format == io::Format::Stl ? UpAxis::Z : UpAxis::Y;
  return loaded;
}

}  // namespace aomd::scene
