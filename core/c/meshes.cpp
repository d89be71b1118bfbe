// The C interface of meshes as files hold them.

#include <cmath>
#include <memory>
#include <utility>

#include "core/c/handles.h"
#include "core/io/io.h"
#include "core/samples/samples.h"

// NOLINTBEGIN(google-global-names-in-headers): functions of C stand in no namespace.
using aomd::MeshData;
using aomd::Shape;
using aomd::c::BadArgument;
using aomd::c::guarded;
// NOLINTEND(google-global-names-in-headers)

namespace {

std::vector<glm::dvec3> positions_of(std::size_t vertices, const double* xyz) {
  std::vector<glm::dvec3> positions(vertices);
  for (std::size_t v = 0; v < vertices; ++v)
    for (int k = 0; k < 3; ++k) {
      positions[v][k] = xyz[3 * v + static_cast<std::size_t>(k)];
      if (!std::isfinite(positions[v][k]))
        throw BadArgument("vertex " + std::to_string(v) + " is not finite");
    }
  return positions;
}

void add_entities(aomd::EntityList& list, Shape shape, std::size_t count,
                  const std::uint32_t* corners, std::size_t vertices) {
  const auto each = static_cast<std::size_t>(aomd::shape_template(shape).vertex_count);
  for (std::size_t i = 0; i < each * count; ++i)
    if (corners[i] >= vertices)
      throw BadArgument("entity " + std::to_string(i / each) + " names vertex " +
                        std::to_string(corners[i]) + " of " + std::to_string(vertices));
  list.shapes.assign(count, shape);
  list.vertices.assign(corners, corners + each * count);
}

std::unique_ptr<aomd_mesh> mesh_of(std::size_t vertices, const double* positions, int dimension,
                                   Shape shape, std::size_t count, const std::uint32_t* corners) {
  auto made = std::make_unique<aomd_mesh>();
  made->data.positions = positions_of(vertices, positions);
  add_entities(made->data.list(dimension), shape, count, corners, vertices);
  return made;
}

const std::vector<aomd::ModelRef>& classes_of(const MeshData& data, int dimension) {
  return dimension == 0 ? data.vertex_classes : data.list(dimension).classes;
}

}  // namespace

aomd_status aomd_mesh_from_triangles(size_t vertices, const double* positions, size_t triangles,
                                     const uint32_t* corners, aomd_mesh** mesh) {
  return guarded([&] {
    *mesh = mesh_of(vertices, positions, 2, Shape::Triangle, triangles, corners).release();
  });
}

aomd_status aomd_mesh_from_tetrahedra(size_t vertices, const double* positions, size_t tetrahedra,
                                      const uint32_t* corners, aomd_mesh** mesh) {
  return guarded([&] {
    *mesh = mesh_of(vertices, positions, 3, Shape::Tetrahedron, tetrahedra, corners).release();
  });
}

aomd_status aomd_mesh_sample(const char* name, int size, aomd_mesh** mesh) {
  return guarded([&] {
    auto made = std::make_unique<aomd_mesh>();
    made->data = aomd::make_sample(name, size);
    *mesh = made.release();
  });
}

aomd_status aomd_mesh_read(const char* file, aomd_mesh** mesh) {
  return guarded([&] {
    aomd::io::ReadResult read = aomd::io::read(file);
    *mesh = new aomd_mesh{std::move(read.mesh), std::move(read.notes)};
  });
}

aomd_status aomd_mesh_write(const aomd_mesh* mesh, const char* file) {
  return guarded([&] { aomd::io::write(file, mesh->data); });
}

aomd_status aomd_mesh_copy(const aomd_mesh* mesh, aomd_mesh** copy) {
  return guarded([&] { *copy = new aomd_mesh(*mesh); });
}

void aomd_mesh_free(aomd_mesh* mesh) { delete mesh; }

size_t aomd_mesh_count(const aomd_mesh* mesh, int dimension) {
  if (dimension == 0) return mesh->data.positions.size();
  return dimension > 0 && dimension < 4 ? mesh->data.list(dimension).size() : 0;
}

const double* aomd_mesh_positions(const aomd_mesh* mesh) {
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
  return mesh->data.positions.empty() ? nullptr : &mesh->data.positions.front().x;
}

size_t aomd_mesh_corner_count(const aomd_mesh* mesh, int dimension) {
  return dimension > 0 && dimension < 4 ? mesh->data.list(dimension).vertices.size() : 0;
}

const uint32_t* aomd_mesh_corners(const aomd_mesh* mesh, int dimension) {
  return dimension > 0 && dimension < 4 ? mesh->data.list(dimension).vertices.data() : nullptr;
}

size_t aomd_mesh_corners_of(const aomd_mesh* mesh, int dimension, size_t entity) {
  if (entity >= aomd_mesh_count(mesh, dimension)) return 0;
  const Shape shape = dimension == 0 ? Shape::Point : mesh->data.list(dimension).shapes[entity];
  return static_cast<size_t>(aomd::shape_template(shape).vertex_count);
}

aomd_status aomd_mesh_class(const aomd_mesh* mesh, int dimension, size_t entity,
                            int* model_dimension, int* tag) {
  return guarded([&] {
    aomd::c::check_dimension(dimension);
    if (entity >= aomd_mesh_count(mesh, dimension))
      throw BadArgument("there is no entity " + std::to_string(entity));
    const auto& classes = classes_of(mesh->data, dimension);
    const aomd::ModelRef model = classes.empty() ? aomd::ModelRef() : classes[entity];
    *model_dimension = model.valid() ? model.dimension() : -1;
    *tag = model.valid() ? model.tag() : 0;
  });
}

size_t aomd_mesh_note_count(const aomd_mesh* mesh) { return mesh->notes.size(); }

const char* aomd_mesh_note(const aomd_mesh* mesh, size_t note) {
  return note < mesh->notes.size() ? mesh->notes[note].c_str() : nullptr;
}
