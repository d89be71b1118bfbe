// Python's Database: T(I,J), adjacency, edits, history.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "core/mesh/derive.h"
#include "core/mesh/names.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "tools/python/arrays.h"
#include "tools/python/held_mesh.h"

namespace aomd::python {

EntityRef HeldMesh::at(int dimension, std::uint32_t id) const {
  if (dimension < 0 || dimension > 3)
    throw std::invalid_argument("a dimension is 0 to 3, not " + std::to_string(dimension));
  const EntityRef e(dimension, id);
  if (id >= mesh.capacity(dimension) || !mesh.alive(e))
    throw std::out_of_range("there is no " + name_of(e));
  return e;
}

Journal& HeldMesh::recorded() {
  if (mesh.journal() == nullptr)
    throw std::logic_error("nothing is recorded: record() begins a history");
  return journal;
}

namespace {

using Entity = std::pair<int, std::uint32_t>;
using Held = std::shared_ptr<HeldMesh>;

void check_levels(int i, int j) {
  if (i < 0 || i > 3 || j < 0 || j > 3)
    throw std::invalid_argument("T(I,J) has levels 0 to 3, not " + std::to_string(i) + " and " +
                                std::to_string(j));
}

std::uint32_t count(const HeldMesh& held, int dim) {
  check_levels(dim, dim);
  return held.mesh.count(dim);
}

std::vector<std::uint32_t> living(const Mesh& mesh, int dim) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id)
    if (mesh.alive({dim, id})) ids.push_back(id);
  return ids;
}

std::vector<std::vector<bool>> tensor(const HeldMesh& held) {
  std::vector<std::vector<bool>> rows(4, std::vector<bool>(4, false));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) rows[std::size_t(i)][std::size_t(j)] = held.mesh.stored(i, j);
  return rows;
}

py::array neighbours(const HeldMesh& held, int dim, std::uint32_t id, int level) {
  check_levels(dim, level);
  std::vector<std::uint32_t> found;
  if (dim == level) throw std::invalid_argument("T(I,J) relates two different levels");
  adjacent(held.mesh, held.at(dim, id), level, found);
  return owned(std::move(found));
}

/// All rows of one relation, one after the other, and where each begins.
std::pair<std::vector<std::uint64_t>, std::vector<std::uint32_t>> rows_of(const Mesh& mesh, int i,
                                                                          int j) {
  std::vector<std::uint64_t> begins{0};
  std::vector<std::uint32_t> entries, row;
  for (std::uint32_t id = 0; id < mesh.capacity(i); ++id) {
    if (mesh.alive({i, id})) {
      adjacent(mesh, {i, id}, j, row);
      entries.insert(entries.end(), row.begin(), row.end());
    }
    begins.push_back(entries.size());
  }
  return {std::move(begins), std::move(entries)};
}

py::tuple relation(const HeldMesh& held, int i, int j) {
  check_levels(i, j);
  if (i == j) throw std::invalid_argument("T(I,J) relates two different levels");
  std::pair<std::vector<std::uint64_t>, std::vector<std::uint32_t>> rows;
  {
    const py::gil_scoped_release unlocked;
    rows = rows_of(held.mesh, i, j);
  }
  return py::make_tuple(owned(std::move(rows.first)), owned(std::move(rows.second)));
}

py::array vertices_of(const HeldMesh& held, int dim, std::uint32_t id) {
  VertexBuffer buffer;
  const auto corners = held.mesh.vertices_of(held.at(dim, id), buffer);
  return owned(std::vector<std::uint32_t>(corners.begin(), corners.end()));
}

std::vector<Vertex> handles(const HeldMesh& held, const std::vector<std::uint32_t>& ids) {
  std::vector<Vertex> vertices;
  vertices.reserve(ids.size());
  for (const std::uint32_t id : ids) vertices.emplace_back(held.at(0, id).index);
  return vertices;
}

std::optional<std::uint32_t> found(std::uint32_t index) {
  return index == no_index ? std::nullopt : std::optional(index);
}

std::optional<std::uint32_t> find(const HeldMesh& held, int dim,
                                  const std::vector<std::uint32_t>& ids) {
  const std::vector<Vertex> vertices = handles(held, ids);
  if (dim == 1 && vertices.size() == 2)
    return found(held.mesh.find_edge(vertices[0], vertices[1]).index);
  if (dim == 2) return found(held.mesh.find_face(vertices).index);
  if (dim == 3) return found(held.mesh.find_region(vertices).index);
  throw std::invalid_argument("edges (two vertices), faces and regions can be found");
}

std::optional<Entity> class_of_entity(const HeldMesh& held, int dim, std::uint32_t id) {
  const ModelRef model = held.mesh.classification(held.at(dim, id));
  if (!model.valid()) return {};
  return Entity(model.dimension(), static_cast<std::uint32_t>(model.tag()));
}

ModelRef model_ref(const std::optional<std::pair<int, int>>& model) {
  return model ? ModelRef(model->first, model->second) : ModelRef();
}

std::vector<Entity> users(const HeldMesh& held, int dim, std::uint32_t id) {
  std::vector<Entity> result;
  for (const EntityRef e : held.mesh.users(held.at(dim, id)))
    result.emplace_back(e.dimension, e.index);
  return result;
}

py::array positions(const HeldMesh& held) {
  std::vector<double> values(std::size_t{3} * held.mesh.capacity(0));
  for (const Vertex v : held.mesh.vertices())
    for (int k = 0; k < 3; ++k)
      values[std::size_t{3} * v.index + std::size_t(k)] = held.mesh.position(v)[k];
  return owned(std::move(values), 3);
}

py::dict classify_held(HeldMesh& held, std::optional<double> angle, bool replace) {
  ClassifyOptions options;
  options.feature_angle_deg = angle;
  options.keep_present = !replace;
  ClassifyResult result;
  {
    const py::gil_scoped_release unlocked;
    result = classify(held.mesh, options);
  }
  py::dict counts;
  counts["model_vertices"] = result.model_vertices;
  counts["model_edges"] = result.model_edges;
  counts["model_faces"] = result.model_faces;
  return counts;
}

std::vector<std::tuple<std::string, Entity, std::string>> findings(const HeldMesh& held,
                                                                   bool unused) {
  std::vector<std::tuple<std::string, Entity, std::string>> list;
  for (const Finding& finding : verify(held.mesh, {unused}))
    list.emplace_back(finding.name, Entity(finding.entity.dimension, finding.entity.index),
                      finding.text);
  return list;
}

std::pair<std::string, std::optional<Entity>> step_at(HeldMesh& held, std::size_t index) {
  if (index >= held.recorded().size())
    throw std::out_of_range("the history has " + std::to_string(held.journal.size()) + " steps");
  const JournalStep& step = held.journal.step(index);
  const auto about = step.entity.valid()
                         ? std::optional(Entity(step.entity.dimension, step.entity.index))
                         : std::nullopt;
  return {step_name(step.kind), about};
}

Shape region_shape(std::size_t corners) {
  for (const Shape shape : {Shape::Tetrahedron, Shape::Pyramid, Shape::Prism, Shape::Hexahedron})
    if (shape_template(shape).vertex_count == static_cast<int>(corners)) return shape;
  throw std::invalid_argument("no region has " + std::to_string(corners) + " vertices");
}

std::uint32_t create(HeldMesh& held, int dim, const std::vector<std::uint32_t>& ids,
                     const std::optional<std::pair<int, int>>& model) {
  const std::vector<Vertex> vertices = handles(held, ids);
  if (dim == 1 && vertices.size() == 2)
    return held.mesh.create_edge(vertices[0], vertices[1], model_ref(model)).index;
  if (dim == 2) return held.mesh.create_face(vertices, model_ref(model)).index;
  if (dim == 3)
    return held.mesh.create_region(region_shape(ids.size()), vertices, model_ref(model)).index;
  throw std::invalid_argument("edges (two vertices), faces and regions are made of vertices");
}

using Class = py::class_<HeldMesh, Held>;

void add_queries(Class& database) {
  database.def("count", &count)
      .def("ids",
           [](const HeldMesh& held, int dim) {
             check_levels(dim, dim);
             return owned(living(held.mesh, dim));
           })
      .def("tensor", &tensor)
      .def("store", [](HeldMesh& held, int i, int j) { check_levels(i, j), held.mesh.set(i, j); })
      .def("release",
           [](HeldMesh& held, int i, int j) { check_levels(i, j), held.mesh.unset(i, j); })
      .def("explain", [](const HeldMesh& held, int i,
                         int j) { return check_levels(i, j), explain(held.mesh, i, j).text(); })
      .def("adjacent", &neighbours)
      .def("relation", &relation)
      .def("vertices_of", &vertices_of)
      .def("find", &find)
      .def("users", &users)
      .def("classification", &class_of_entity)
      .def("positions", &positions)
      .def("verify", &findings)
      .def("memory", [](const HeldMesh& held) {
        return std::pair(held.mesh.entity_bytes(), held.mesh.adjacency_bytes());
      });
}

void add_edits(Class& database) {
  database.def("classify", &classify_held)
      .def("create_vertex",
           [](HeldMesh& held, const std::array<double, 3>& p,
              const std::optional<std::pair<int, int>>& model) {
             return held.mesh.create_vertex({p[0], p[1], p[2]}, model_ref(model)).index;
           })
      .def("create", &create)
      .def("destroy",
           [](HeldMesh& held, int dim, std::uint32_t id, bool with_users) {
             const EntityRef e = held.at(dim, id);
             with_users ? held.mesh.destroy_with_users(e) : held.mesh.destroy(e);
           })
      .def("move",
           [](HeldMesh& held, std::uint32_t id, const std::array<double, 3>& p) {
             held.mesh.move(Vertex(held.at(0, id).index), {p[0], p[1], p[2]});
           })
      .def("set_classification",
           [](HeldMesh& held, int dim, std::uint32_t id,
              const std::optional<std::pair<int, int>>& model) {
             held.mesh.set_classification(held.at(dim, id), model_ref(model));
           })
      .def("to_data",
           [](const HeldMesh& held) { return std::make_shared<MeshData>(to_data(held.mesh)); });
}

void add_history(Class& database) {
  database
      .def("record",
           [](HeldMesh& held) {
             if (held.mesh.journal() == nullptr) held.mesh.attach(&held.journal);
           })
      .def("undo", [](HeldMesh& held) { return held.recorded().undo(held.mesh); })
      .def("redo", [](HeldMesh& held) { return held.recorded().redo(held.mesh); })
      .def(
          "seek", [](HeldMesh& held, std::size_t step) { held.recorded().seek(held.mesh, step); },
          NoLock())
      .def("steps", [](HeldMesh& held) { return held.recorded().size(); })
      .def("cursor", [](HeldMesh& held) { return held.recorded().cursor(); })
      .def("step", &step_at);
}

}  // namespace

void add_database(py::module_& module) {
  Class database(module, "Database");
  database.def(py::init([](const MeshData& data) { return std::make_shared<HeldMesh>(data); }),
               NoLock());
  add_queries(database);
  add_edits(database);
  add_history(database);
}

}  // namespace aomd::python
