// From plain arrays to the database and back.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/mesh/bulk.h"
#include "core/mesh/mesh.h"
#include "core/mesh/names.h"

namespace aomd {
namespace {

void require_data(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("mesh data: " + what);
}

// What is wrong with entity i, whose vertices start at `at`; null where nothing is.
const char* defect(const MeshData& data, int dim, std::size_t i, std::size_t at) {
  const EntityList& list = data.list(dim);
  if (static_cast<std::size_t>(list.shapes[i]) >= shape_count() ||
      shape_template(list.shapes[i]).dimension != dim)
    return "has a wrong shape";
  const auto n = static_cast<std::size_t>(shape_template(list.shapes[i]).vertex_count);
  if (at + n > list.vertices.size()) return "lacks vertices";
  const std::uint32_t* v = list.vertices.data() + at;
  for (std::size_t k = 0; k < n; ++k) {
    if (v[k] >= data.positions.size()) return "uses a vertex that does not exist";
    for (std::size_t j = 0; j < k; ++j)
      if (v[j] == v[k]) return "uses a vertex twice";
  }
  return list.classes.empty() || list.classes[i].may_classify(dim)
             ? nullptr
             : "is on a model entity of lower dimension";
}

bool all_of_shape(const EntityList& list, Shape shape) {
  return std::all_of(list.shapes.begin(), list.shapes.end(), [&](Shape s) { return s == shape; });
}

// As defect() has it, of all at once.
bool are_sound_triangles(const MeshData& data) {
  const std::vector<std::uint32_t>& v = data.faces.vertices;
  if (v.size() != 3 * data.faces.size() || !all_of_shape(data.faces, Shape::Triangle)) return false;
  std::uint32_t highest = 0;
  bool repeats = false;
  for (std::size_t at = 0; at < v.size(); at += 3) {
    highest = std::max({highest, v[at], v[at + 1], v[at + 2]});
    repeats |= (v[at] == v[at + 1]) | (v[at + 1] == v[at + 2]) | (v[at + 2] == v[at]);
  }
  const std::vector<ModelRef>& classes = data.faces.classes;
  return !repeats && highest < data.positions.size() &&
         std::all_of(classes.begin(), classes.end(), [](ModelRef m) { return m.may_classify(2); });
}

void check_list(const MeshData& data, int dim) {
  const EntityList& list = data.list(dim);
  const std::string names = entity_plural(dim);
  require_data(list.classes.empty() || list.classes.size() == list.size(),
               "there are not as many classes as " + names);
  if (dim == 2 && are_sound_triangles(data)) return;
  std::size_t at = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (const char* what = defect(data, dim, i, at))
      require_data(false, name_of(EntityRef(dim, static_cast<std::uint32_t>(i))) + " " + what);
    at += static_cast<std::size_t>(shape_template(list.shapes[i]).vertex_count);
  }
  require_data(at == list.vertices.size(), "there are more vertices than the " + names + " use");
}

void check_data(const MeshData& data) {
  require_data(data.positions.size() < no_index, "there are too many vertices");
  require_data(data.vertex_classes.empty() || data.vertex_classes.size() == data.positions.size(),
               "there are not as many classes as vertices");
  for (int dim = 1; dim <= 3; ++dim) check_list(data, dim);
  for (const Attribute& a : data.attributes) {
    const std::size_t n = a.dimension == 0 ? data.positions.size() : data.list(a.dimension).size();
    require_data(a.values.size() == n * static_cast<std::size_t>(a.components),
                 "attribute \"" + a.name + "\" does not have one value for each entity");
  }
}

// A file may list an edge twice: the last one with a class counts.
EntityList without_duplicates(const EntityList& edges, std::size_t vertices) {
  const auto key = [&](std::size_t e) {
    return EdgeKey(edges.vertices[2 * std::size_t{e}], edges.vertices[2 * std::size_t{e} + 1]);
  };
  const SideIndex<EdgeKey> index(static_cast<std::uint32_t>(vertices), edges.size(),
                                 [&](auto&& visit) {
                                   for (std::uint32_t e = 0; e < edges.size(); ++e)
                                     visit(e, key(e));
                                 });
  EntityList unique;
  std::vector<std::uint32_t> place(edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const ModelRef model = edges.classes.empty() ? ModelRef() : edges.classes[e];
    const std::uint32_t first = index.find(key(e), [](std::uint32_t) { return true; }).id();
    place[e] = static_cast<std::uint32_t>(unique.size());
    if (first == e) {
      unique.add(edges.shapes[e],
                 {edges.vertices[2 * std::size_t{e}], edges.vertices[2 * std::size_t{e} + 1]},
                 model);
    } else if (model.valid()) {
      unique.classes.resize(unique.size());
      unique.classes[place[first]] = model;
    }
  }
  return unique;
}

template <typename Key, typename MakeKey>
void mark_used(const Mesh& mesh, int dim, const SideIndex<Key>& index, MakeKey&& key,
               std::vector<std::uint8_t>& used) {
  const VertexRows own(mesh, dim);
  for (int higher = dim + 1; higher <= 3; ++higher) {
    const VertexRows rows(mesh, higher);
    rows.each([&](std::uint32_t id, const std::uint32_t* v) {
      const ShapeTemplate& shape = rows.shape(id);
      for (int i = 0; i < shape.count(dim); ++i) {
        const SideVertices side(shape.sub(dim, i), v);
        (void)index.find(key(side.span()), [&](std::uint32_t e) {
          used[e] |= std::uint8_t{same_set(own.vertices(e), side.span())};
          return false;  // all that have these vertices
        });
      }
    });
  }
}

// Which entities of a level are a side of a higher one.
std::vector<std::uint8_t> used_sides(const Mesh& mesh, int dim) {
  std::vector<std::uint8_t> used(mesh.capacity(dim), 0);
  const VertexRows rows(mesh, dim);
  if (dim == 1)
    mark_used(
        mesh, 1, index_edges(mesh, rows), [](auto v) { return EdgeKey(v[0], v[1]); }, used);
  else
    mark_used(
        mesh, 2, index_faces(mesh, rows), [](auto v) { return FaceKey(v); }, used);
  return used;
}

void drop_if_unclassified(std::vector<ModelRef>& classes) {
  if (std::none_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); }))
    classes.clear();
}

using Ids = std::vector<std::uint32_t>;

/// How many numbers a value of a column has; 0 for types that are no attribute.
template <typename T>
constexpr int components_of = std::is_arithmetic_v<T> ? 1 : 0;
template <>
constexpr int components_of<glm::dvec3> = 3;
template <std::size_t N>
constexpr int components_of<std::array<double, N>> = static_cast<int>(N);

template <typename T>
double component(const T& value, int k) {
  if constexpr (std::is_arithmetic_v<T>)
    return static_cast<double>(value);
  else if constexpr (std::is_same_v<T, glm::dvec3>)
    return value[k];
  else
    return value[static_cast<std::size_t>(k)];
}

template <typename T>
T value_from(const double* v) {
  if constexpr (std::is_arithmetic_v<T>) {
    return static_cast<T>(*v);
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return {v[0], v[1], v[2]};
  } else {
    T value;
    std::copy_n(v, value.size(), value.begin());
    return value;
  }
}

template <typename H, typename T>
void add_attribute(const Mesh& mesh, const AttachedBase& column, const Ids& ids, MeshData& data) {
  const auto* values = mesh.find_attached<H, T>(column.name());
  if (!values) return;
  const FileNumbers& file = column.file_numbers();
  Attribute a{
      column.name(), H::dimension, components_of<T>, std::is_integral_v<T> || file.integer, {},
      file.type,     file.meaning, file.names};
  for (const std::uint32_t id : ids)
    for (int k = 0; k < components_of<T>; ++k) a.values.push_back(component((*values)[H(id)], k));
  data.attributes.push_back(std::move(a));
}

template <typename H>
void add_attributes(const Mesh& mesh, const Ids& ids, MeshData& data) {
  for (const auto& column : mesh.attached(H::dimension)) {
    add_attribute<H, double>(mesh, *column, ids, data);
    add_attribute<H, std::int64_t>(mesh, *column, ids, data);
    add_attribute<H, std::array<double, 2>>(mesh, *column, ids, data);
    add_attribute<H, glm::dvec3>(mesh, *column, ids, data);
    add_attribute<H, std::array<double, 4>>(mesh, *column, ids, data);
    add_attribute<H, std::array<double, 6>>(mesh, *column, ids, data);
    add_attribute<H, std::array<double, 9>>(mesh, *column, ids, data);
  }
}

template <typename H, typename T>
void fill_column(Mesh& mesh, const Attribute& a) {
  Attached<H, T>& column = mesh.attached<H, T>(a.name);
  const double* v = a.values.data();
  for (std::uint32_t i = 0; i < mesh.capacity(H::dimension); ++i, v += a.components)
    column[H(i)] = value_from<T>(v);
  column.remember({a.integer, a.type, a.meaning, a.names});
}

/// Arrays of other numbers of components are none of a Mesh's.
template <typename H>
void take_attribute(Mesh& mesh, const Attribute& a) {
  if (a.components == 1 && a.integer) fill_column<H, std::int64_t>(mesh, a);
  if (a.components == 1 && !a.integer) fill_column<H, double>(mesh, a);
  if (a.components == 2) fill_column<H, std::array<double, 2>>(mesh, a);
  if (a.components == 3) fill_column<H, glm::dvec3>(mesh, a);
  if (a.components == 4) fill_column<H, std::array<double, 4>>(mesh, a);
  if (a.components == 6) fill_column<H, std::array<double, 6>>(mesh, a);
  if (a.components == 9) fill_column<H, std::array<double, 9>>(mesh, a);
}

}  // namespace

Mesh::Mesh(const MeshData& data) : positions_(data.positions), model_table_(data.model) {
  check_data(data);
  level(0).ids.create_many(static_cast<std::uint32_t>(data.positions.size()));
  level(0).classes = data.vertex_classes;
  level(0).classes.resize(data.positions.size());
  const EntityList edges = without_duplicates(data.edges, data.positions.size());
  take_list(1, edges);
  take_list(2, data.faces);
  take_list(3, data.regions);
  if (dimension() > 1) representation_.demand(dimension(), 0).user = true;
  for (const Attribute& a : data.attributes) {
    if (a.dimension == 1 && edges.size() != data.edges.size()) continue;
    if (a.dimension == 0) take_attribute<Vertex>(*this, a);
    if (a.dimension == 1) take_attribute<Edge>(*this, a);
    if (a.dimension == 2) take_attribute<Face>(*this, a);
    if (a.dimension == 3) take_attribute<Region>(*this, a);
  }
}

void Mesh::take_list(int dim, const EntityList& list) {
  if (list.empty()) return;
  Level& l = level(dim);
  l.ids.create_many(static_cast<std::uint32_t>(list.size()));
  l.classes = list.classes;
  l.classes.resize(list.size());
  l.uniform = list.shapes[0];
  const bool uniform = all_of_shape(list, l.uniform);
  if (!uniform) l.shapes = list.shapes;
  DownRows& rows = representation_.down(dim, 0);
  rows.allocate(static_cast<std::uint32_t>(list.size()), widest(dim, 0), false);
  const std::uint32_t* from = list.vertices.data();
  if (uniform) {
    std::copy(list.vertices.begin(), list.vertices.end(), rows.row(0));
    return;
  }
  for (std::uint32_t id = 0; id < list.size(); ++id) {
    const int n = shape_template(list.shapes[id]).vertex_count;
    std::copy_n(from, n, rows.row(id));
    from += n;
  }
}

MeshData to_data(const Mesh& mesh) {
  MeshData data;
  data.model = mesh.model_table();
  std::array<Ids, 4> listed;
  Ids new_index(mesh.capacity(0), no_index);
  data.positions.reserve(mesh.count(0));
  for (const Vertex v : mesh.vertices()) {
    new_index[v.index] = static_cast<std::uint32_t>(data.positions.size());
    data.positions.push_back(mesh.position(v));
    data.vertex_classes.push_back(mesh.classification(v));
    listed[0].push_back(v.index);
  }
  for (int dim = 1; dim <= 3; ++dim) {
    const bool some = mesh.complete(dim) && dim < mesh.dimension();
    const auto used = some ? used_sides(mesh, dim) : std::vector<std::uint8_t>();
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      const EntityRef e(dim, id);
      if (!mesh.alive(e) || (some && used[id] && mesh.classification(e).dimension() != dim))
        continue;
      VertexBuffer buffer;
      EntityList& list = data.list(dim);
      for (const std::uint32_t v : mesh.vertices_of(e, buffer))
        list.vertices.push_back(new_index[v]);
      list.shapes.push_back(mesh.shape(e));
      list.classes.push_back(mesh.classification(e));
      listed[static_cast<std::size_t>(dim)].push_back(id);
    }
  }
  drop_if_unclassified(data.vertex_classes);
  for (int dim = 1; dim <= 3; ++dim) drop_if_unclassified(data.list(dim).classes);
  add_attributes<Vertex>(mesh, listed[0], data);
  add_attributes<Edge>(mesh, listed[1], data);
  add_attributes<Face>(mesh, listed[2], data);
  add_attributes<Region>(mesh, listed[3], data);
  return data;
}

}  // namespace aomd
