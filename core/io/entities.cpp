#include "core/io/entities.h"

#include <algorithm>

#include "core/io/formats.h"

namespace aomd::io::detail {
namespace {

constexpr std::int64_t none = -1;

/// The first value that occurs twice, or none. Few values are compared with each other, many are
/// sorted.
std::int64_t repeated(std::span<const std::int64_t> vertices) {
  if (vertices.size() <= 8) {
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const auto before = vertices.first(i);
      if (std::find(before.begin(), before.end(), vertices[i]) != before.end()) return vertices[i];
    }
    return none;
  }
  std::vector<std::int64_t> sorted(vertices.begin(), vertices.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  return twin == sorted.end() ? none : *twin;
}

/// Closes the gaps that marked vertices leave among values, so many for each vertex.
template <class Value>
void drop_values(std::vector<Value>& values, const std::vector<std::uint8_t>& marks,
                 std::size_t components) {
  std::size_t to = 0;
  for (std::size_t v = 0; v < marks.size(); ++v) {
    if (marks[v] != 0) continue;
    for (std::size_t c = 0; c < components; ++c) values[to++] = values[v * components + c];
  }
  values.resize(to);
}

}  // namespace

std::string out_of_range(std::int64_t index, std::uint64_t vertex_count, int first) {
  if (vertex_count == 0) return "an element refers to a vertex, but there are none";
  return "vertex index " + std::to_string(index + first) + " is out of range (" +
         std::to_string(first) + ".." +
         std::to_string(vertex_count - 1 + static_cast<std::uint64_t>(first)) + ")";
}

std::string range_defect(std::span<const std::int64_t> vertices, std::uint64_t vertex_count,
                         int first) {
  for (const std::int64_t index : vertices) {
    if (outside(index, vertex_count)) return out_of_range(index, vertex_count, first);
  }
  return {};
}

std::string entity_defect(Shape shape, std::span<const std::int64_t> vertices,
                          std::uint64_t vertex_count, int first) {
  std::string wrong = range_defect(vertices, vertex_count, first);
  if (!wrong.empty()) return wrong;
  const std::int64_t twin = repeated(vertices);
  if (twin == none) return {};
  const ShapeTemplate& t = shape_template(shape);
  wrong = "the " + std::string(t.name) + " repeats vertex " + std::to_string(twin + first);
  if (t.dimension == 3) wrong += ": a region that collapses must be listed as what it becomes";
  return wrong;
}

std::optional<std::vector<std::int64_t>> without_repeats(Shape shape,
                                                         std::span<const std::int64_t> vertices,
                                                         std::uint64_t vertex_count,
                                                         Repeats& repeats) {
  const int dimension = shape_template(shape).dimension;
  if (dimension == 3 || !range_defect(vertices, vertex_count).empty()) return {};
  std::vector<std::int64_t> left(vertices.begin(), vertices.end());
  trim_walk(left);
  if (left.size() < 3) left.clear();
  ++(dimension == 1 ? repeats.edges : left.empty() ? repeats.faces : repeats.cut);
  return left;
}

bool repeats_vertex(std::span<const std::int64_t> vertices) { return repeated(vertices) != none; }

void trim_walk(std::vector<std::int64_t>& polygon) {
  std::vector<std::int64_t> walk;
  for (const std::int64_t v : polygon) {
    if (walk.size() > 1 && walk[walk.size() - 2] == v) walk.pop_back();
    if (walk.empty() || walk.back() != v) walk.push_back(v);
  }
  // Where the walk closes, both of its ends may go.
  std::size_t begin = 0, end = walk.size();
  while (end - begin > 1) {
    if (walk[begin] == walk[end - 1] || walk[begin] == walk[end - 2]) {
      --end;
    } else if (walk[begin + 1] == walk[end - 1]) {
      ++begin;
    } else {
      break;
    }
  }
  polygon.assign(walk.begin() + static_cast<std::ptrdiff_t>(begin),
                 walk.begin() + static_cast<std::ptrdiff_t>(end));
}

void append(EntityList& list, Shape shape, std::span<const std::int64_t> vertices) {
  list.shapes.push_back(shape);
  for (const std::int64_t v : vertices) list.vertices.push_back(static_cast<std::uint32_t>(v));
}

void drop_vertices(MeshData& mesh, const std::vector<std::uint8_t>& marks) {
  std::vector<std::uint32_t> place(marks.size());
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < marks.size(); ++v) {
    place[v] = kept;
    kept += marks[v] == 0;
  }
  drop_values(mesh.positions, marks, 1);
  if (!mesh.vertex_classes.empty()) drop_values(mesh.vertex_classes, marks, 1);
  for (Attribute& a : mesh.attributes) {
    if (a.dimension == 0) drop_values(a.values, marks, static_cast<std::size_t>(a.components));
  }
  for (int d = 1; d <= 3; ++d) {
    for (std::uint32_t& v : mesh.list(d).vertices) v = place[v];
  }
}

std::vector<ModelRef> lowest_classes(const MeshData& mesh) {
  std::vector<ModelRef> classes(mesh.positions.size());
  std::vector<std::uint8_t> from(
      mesh.positions.size());  // the dimension that gave the class, 0 before
  for (std::uint8_t d = 1; d <= 3; ++d) {
    for_each_entity(mesh.list(d), [&](auto vertices, ModelRef model) {
      if (!model.valid()) return;
      for (const std::uint32_t v : vertices) {
        if (from[v] == 0 || (from[v] == d && model < classes[v])) classes[v] = model;
        if (from[v] == 0) from[v] = d;
      }
    });
  }
  return classes;
}

}  // namespace aomd::io::detail
