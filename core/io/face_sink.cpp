#include "core/io/face_sink.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/polygon.h"
#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

void drop_if_empty(std::vector<ModelRef>& classes) {
  if (std::none_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); }))
    classes.clear();
}

}  // namespace

std::string polygon_defect(std::span<const std::int64_t> polygon, std::uint64_t vertex_count,
                           int first) {
  if (polygon.size() < 3)
    return "a face needs 3 or more vertices, this one has " + std::to_string(polygon.size());
  if (polygon.size() > max_polygon) {
    return "a face of " + std::to_string(polygon.size()) + " vertices; the limit is " +
           std::to_string(max_polygon);
  }
  return entity_defect("face", polygon, vertex_count, first);
}

void FaceSink::reserve(std::size_t n) {
  faces_.shapes.reserve(n);
  faces_.vertices.reserve(3 * n);
}

std::string FaceSink::add(std::span<const std::int64_t> polygon, ModelRef model) {
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(polygon[i]); };
  if (polygon.size() == 3 && !outside(polygon[0], vertex_count_) &&
      !outside(polygon[1], vertex_count_) && !outside(polygon[2], vertex_count_) &&
      polygon[0] != polygon[1] && polygon[1] != polygon[2] && polygon[2] != polygon[0]) {
    push(corner(0), corner(1), corner(2), model);
    return {};
  }
  std::string wrong = polygon_defect(polygon, vertex_count_, first_);
  if (!wrong.empty()) return wrong;
  polygons_.push_back({faces_.size(), corners_.size(), polygon.size()});
  for (const std::int64_t index : polygon) corners_.push_back(static_cast<std::uint32_t>(index));
  // A fan keeps the place; finish() puts the real triangles there.
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    push(corner(0), corner(i), corner(i + 1), model);
  return {};
}

void FaceSink::push(std::uint32_t a, std::uint32_t b, std::uint32_t c, ModelRef model) {
  faces_.add(Shape::Triangle, {a, b, c}, model);
}

std::size_t FaceSink::finish(MeshData& mesh) {
  std::vector<std::uint32_t> triangles;
  for (const Polygon& polygon : polygons_) {
    triangles.clear();
    triangulate(mesh.positions, std::span(corners_).subspan(polygon.start, polygon.size),
                triangles);
    std::copy(triangles.begin(), triangles.end(),
              faces_.vertices.begin() + static_cast<std::ptrdiff_t>(3 * polygon.triangle));
  }
  mesh.faces = std::move(faces_);
  return polygons_.size();
}

std::string edge_defect(std::int64_t a, std::int64_t b, std::uint64_t vertex_count, int first) {
  const std::int64_t ends[] = {a, b};
  return entity_defect("edge", ends, vertex_count, first);
}

void drop_empty_classes(MeshData& mesh) {
  drop_if_empty(mesh.vertex_classes);
  drop_if_empty(mesh.edges.classes);
  drop_if_empty(mesh.faces.classes);
  drop_if_empty(mesh.regions.classes);
}

void note_polygons(std::vector<std::string>& notes, std::size_t polygons) {
  if (polygons > 0) notes.push_back(counted(polygons, "polygon") + " triangulated");
}

}  // namespace aomd::io::detail
