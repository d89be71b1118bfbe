// Python's Mesh: arrays, files, attributes.

#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/io/io.h"
#include "core/mesh/names.h"
#include "core/mesh/split_tets.h"
#include "core/samples/samples.h"
#include "tools/python/arrays.h"

namespace aomd::python {
namespace {

MeshHandle make_mesh(const py::array& vertices, const py::object& faces, const py::object& regions,
                     const py::object& edges, const py::dict& classes) {
  auto mesh = std::make_shared<MeshData>();
  mesh->positions = positions_from(vertices);
  const std::size_t n = mesh->positions.size();
  mesh->edges = entities_from(edges, 1, n);
  mesh->faces = entities_from(faces, 2, n);
  mesh->regions = entities_from(regions, 3, n);
  for (const auto& [key, values] : classes) {
    const int dim = dimension_of(py::cast<std::string>(key));
    const auto array = py::array::ensure(values);
    if (dim == 0)
      mesh->vertex_classes = classes_from(array, 0, n);
    else
      mesh->list(dim).classes = classes_from(array, dim, mesh->list(dim).size());
  }
  return mesh;
}

std::size_t count_of(const MeshData& mesh, int dim) {
  return dim == 0 ? mesh.positions.size() : mesh.list(dim).size();
}

/// The vertices of all entities of a dimension: of one shape an array of two dimensions.
py::array corners(const py::object& self, int dim) {
  const EntityList& list = py::cast<const MeshData&>(self).list(dim);
  if (list.empty()) return view(list.vertices.data(), 0, dim == 3 ? 4 : std::size_t(dim) + 1, self);
  for (const Shape shape : list.shapes)
    if (shape != list.shapes.front())
      throw std::invalid_argument(std::string(entity_plural(dim)) +
                                  " are of several shapes: by_shape() has each by itself");
  const auto columns = static_cast<std::size_t>(shape_template(list.shapes.front()).vertex_count);
  return view(list.vertices.data(), list.size(), columns, self);
}

/// One array for each shape, by its name.
py::dict by_shape(const MeshData& mesh, const std::string& kind) {
  const int dim = dimension_of(kind);
  if (dim == 0) throw std::invalid_argument("vertices have no shape");
  const EntityList& list = mesh.list(dim);
  std::array<std::vector<std::uint32_t>, max_shapes> found;
  const std::uint32_t* next = list.vertices.data();
  for (const Shape shape : list.shapes) {
    std::vector<std::uint32_t>& values = found[static_cast<std::size_t>(shape)];
    values.insert(values.end(), next, next + shape_template(shape).vertex_count);
    next += shape_template(shape).vertex_count;
  }
  py::dict result;
  for (std::size_t s = 0; s < found.size(); ++s) {
    if (found[s].empty()) continue;
    const ShapeTemplate& shape = shape_template(static_cast<Shape>(s));
    result[py::str(std::string(shape.name))] =
        owned(std::move(found[s]), static_cast<std::size_t>(shape.vertex_count));
  }
  return result;
}

py::object classes(const MeshData& mesh, const std::string& kind) {
  const int dim = dimension_of(kind);
  const std::vector<ModelRef>& list = dim == 0 ? mesh.vertex_classes : mesh.list(dim).classes;
  if (list.empty()) return py::none();
  return classes_to(list);
}

py::array numbers_of(const Attribute& attribute, const py::object& owner) {
  const auto columns = static_cast<std::size_t>(attribute.components);
  const std::size_t rows = attribute.values.size() / columns;
  if (attribute.integer)
    return owned(std::vector<std::int64_t>(attribute.values.begin(), attribute.values.end()),
                 columns > 1 ? columns : 0);
  return view(attribute.values.data(), rows, columns > 1 ? columns : 0, owner);
}

/// Where the arrays of one kind are, what dimension they name, and how long they are.
struct Place {
  std::vector<Attribute> MeshData::*list;
  int dimension;
  std::size_t entities;
};

Place place_of(const MeshData& mesh, const std::string& kind) {
  if (kind == "corners") return {&MeshData::corners, 2, mesh.faces.vertices.size()};
  const int dim = dimension_of(kind);
  return {&MeshData::attributes, dim, count_of(mesh, dim)};
}

py::dict attributes(const py::object& self, const std::string& kind) {
  const auto& mesh = py::cast<const MeshData&>(self);
  const Place place = place_of(mesh, kind);
  py::dict result;
  for (const Attribute& attribute : mesh.*place.list)
    if (attribute.dimension == place.dimension)
      result[py::str(attribute.name)] = numbers_of(attribute, self);
  return result;
}

MeshHandle without_attribute(const MeshData& mesh, const std::string& name,
                             const std::string& kind) {
  const Place place = place_of(mesh, kind);
  auto result = std::make_shared<MeshData>(mesh);
  std::erase_if((*result).*place.list, [&](const Attribute& each) {
    return each.name == name && each.dimension == place.dimension;
  });
  return result;
}

MeshHandle with_attribute(const MeshData& mesh, const std::string& name, const py::array& values,
                          const std::string& kind) {
  const Place place = place_of(mesh, kind);
  Attribute added = attribute_from(name, values, place.dimension, place.entities);
  MeshHandle result = without_attribute(mesh, name, kind);
  ((*result).*place.list).push_back(std::move(added));
  return result;
}

std::string text_of_mesh(const MeshData& mesh) {
  std::string text = "<aomd.Mesh: " + counted(mesh.positions.size(), "vertex");
  if (!mesh.faces.empty()) text += ", " + counted(mesh.faces.size(), "face");
  if (!mesh.regions.empty()) text += ", " + counted(mesh.regions.size(), "region");
  return text + ">";
}

std::pair<MeshHandle, std::vector<std::string>> read_file(const std::filesystem::path& file) {
  io::ReadResult read = io::read(file);
  return {std::make_shared<MeshData>(std::move(read.mesh)), std::move(read.notes)};
}

io::Format wanted_format(const std::string& name) {
  if (const auto format = io::format_named(name)) return *format;
  throw std::invalid_argument(
      "format: must be obj, ply, off, stl, gltf, glb, msh, mesh, vtk, vtu or su2, not " +
      shown(name));
}

std::pair<MeshHandle, std::vector<std::string>> from_bytes(const std::string& bytes,
                                                           const std::string& name) {
  io::ReadResult read = io::read_bytes(name, bytes);
  return {std::make_shared<MeshData>(std::move(read.mesh)), std::move(read.notes)};
}

io::EncodedMesh encoded(const MeshData& mesh, const std::string& format,
                        std::optional<bool> binary) {
  return io::to_bytes("mesh." + format, wanted_format(format), mesh,
                      {.binary = binary, .beside = false});
}

std::vector<std::string> write_file(const std::filesystem::path& file, const MeshData& mesh,
                                    std::optional<bool> binary, bool msh2) {
  return io::write(file, mesh, {.binary = binary, .msh2 = msh2});
}

MeshHandle sample(const std::string& name, int size) {
  return std::make_shared<MeshData>(make_sample(name, size));
}

std::vector<std::pair<std::string, std::string>> sample_list() {
  std::vector<std::pair<std::string, std::string>> list;
  for (const SampleInfo& info : samples())
    list.emplace_back(std::string(info.name), std::string(info.description));
  return list;
}

std::pair<MeshHandle, std::string> split(const MeshData& mesh) {
  SplitToTets result = split_to_tets(mesh);
  return {std::make_shared<MeshData>(std::move(result.mesh)), result.text()};
}

void add_files(py::module_& module) {
  module.def("read", &read_file, NoLock());
  module.def("write", &write_file, NoLock());
  module.def("from_bytes", &from_bytes);
  module.def("to_bytes",
             [](const MeshData& mesh, const std::string& format, std::optional<bool> binary) {
               const io::EncodedMesh bytes = encoded(mesh, format, binary);
               return std::pair(py::bytes(bytes.bytes), bytes.notes);
             });
  module.def("sample", &sample, NoLock());
  module.def("samples", &sample_list);
  module.def("split_to_tets", &split, NoLock());
}

}  // namespace

void add_mesh(py::module_& module) {
  py::class_<MeshData, MeshHandle>(module, "MeshData")
      .def(py::init(&make_mesh))
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               const auto& positions = py::cast<const MeshData&>(self).positions;
                               return view(reinterpret_cast<const double*>(positions.data()),
                                           positions.size(), 3, self);
                             })
      .def("corners", &corners)
      .def("by_shape", &by_shape)
      .def("count", [](const MeshData& mesh,
                       const std::string& kind) { return count_of(mesh, dimension_of(kind)); })
      .def("classes", &classes)
      .def("attributes", &attributes)
      .def("with_attribute", &with_attribute)
      .def("without_attribute", &without_attribute)
      .def("__eq__", [](const MeshData& a, const MeshData& b) { return a == b; })
      .def("__repr__", &text_of_mesh);
  add_files(module);
}

}  // namespace aomd::python
