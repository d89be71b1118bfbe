#include "core/io/face_sink.h"

#include <algorithm>

#include "core/io/polygon.h"
#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

std::string out_of_range(std::int64_t index, std::uint64_t vertex_count, int first) {
  if (vertex_count == 0) return "a face or edge refers to a vertex, but there are none";
  return "vertex index " + std::to_string(index + first) + " is out of range (" + std::to_string(first) +
         ".." + std::to_string(vertex_count - 1 + static_cast<std::uint64_t>(first)) + ")";
}

bool outside(std::int64_t index, std::uint64_t vertex_count) {
  return index < 0 || static_cast<std::uint64_t>(index) >= vertex_count;
}

/// The first value that occurs twice, or -1. O(n log n).
std::int64_t repeated(std::span<const std::int64_t> polygon) {
  std::vector<std::int64_t> sorted(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
  return twin == sorted.end() ? -1 : *twin;
}

void drop_if_empty(std::vector<ModelRef>& classes) {
  if (std::none_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); })) classes.clear();
}

}  // namespace

void FaceSink::reserve(std::size_t n) {
  faces_.shapes.reserve(n);
  faces_.vertices.reserve(3 * n);
}

std::string FaceSink::defect(std::span<const std::int64_t> polygon) const {
  if (polygon.size() < 3)
    return "a face needs 3 or more vertices, this one has " + std::to_string(polygon.size());
  if (polygon.size() > max_polygon) {
    return "a face of " + std::to_string(polygon.size()) + " vertices; the limit is " +
           std::to_string(max_polygon);
  }
  for (const std::int64_t index : polygon) {
    if (outside(index, vertex_count_)) return out_of_range(index, vertex_count_, first_);
  }
  const std::int64_t twin = repeated(polygon);
  return twin < 0 ? "" : "the face repeats vertex " + std::to_string(twin + first_);
}

std::string FaceSink::add(std::span<const std::int64_t> polygon, ModelRef model) {
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(polygon[i]); };
  if (polygon.size() == 3 && !outside(polygon[0], vertex_count_) && !outside(polygon[1], vertex_count_) &&
      !outside(polygon[2], vertex_count_) && polygon[0] != polygon[1] && polygon[1] != polygon[2] &&
      polygon[2] != polygon[0]) {
    push(corner(0), corner(1), corner(2), model);
    return {};
  }
  std::string wrong = defect(polygon);
  if (!wrong.empty()) return wrong;
  polygons_.push_back({faces_.size(), corners_.size(), polygon.size()});
  for (const std::int64_t index : polygon) corners_.push_back(static_cast<std::uint32_t>(index));
  // A fan keeps the place; finish() puts the real triangles there.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) push(corner(0), corner(i), corner(i + 1), model);
  return {};
}

void FaceSink::push(std::uint32_t a, std::uint32_t b, std::uint32_t c, ModelRef model) {
  faces_.add(Shape::Triangle, {a, b, c}, model);
}

std::size_t FaceSink::finish(MeshData& mesh) {
  std::vector<std::uint32_t> triangles;
  for (const Polygon& polygon : polygons_) {
    triangles.clear();
    triangulate(mesh.positions, std::span(corners_).subspan(polygon.start, polygon.size), triangles);
    std::copy(triangles.begin(), triangles.end(),
              faces_.vertices.begin() + static_cast<std::ptrdiff_t>(3 * polygon.triangle));
  }
  mesh.faces = std::move(faces_);
  return polygons_.size();
}

std::string edge_defect(std::int64_t a, std::int64_t b, std::uint64_t vertex_count, int first) {
  if (outside(a, vertex_count)) return out_of_range(a, vertex_count, first);
  if (outside(b, vertex_count)) return out_of_range(b, vertex_count, first);
  return a == b ? "the edge repeats vertex " + std::to_string(a + first) : "";
}

void drop_empty_classes(MeshData& mesh) {
  drop_if_empty(mesh.vertex_classes);
  drop_if_empty(mesh.edges.classes);
  drop_if_empty(mesh.faces.classes);
}

void note_polygons(std::vector<std::string>& notes, std::size_t polygons) {
  if (polygons > 0) notes.push_back(counted(polygons, "polygon") + " triangulated");
}

}  // namespace aomd::io::detail
