#include "core/io/face_sink.h"

#include <algorithm>
#include <utility>

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
  if (polygon.size() > max_polygon) {
    return "a face of " + std::to_string(polygon.size()) + " vertices; the limit is " +
           std::to_string(max_polygon);
  }
  return range_defect(polygon, vertex_count, first);
}

void triangles_of_walk(std::span<const glm::dvec3> positions,
                       std::span<const std::uint32_t> polygon, std::vector<std::uint32_t>& out) {
  const std::size_t start = out.size();
  triangulate(positions, polygon, out);
  std::size_t kept = start;
  for (std::size_t i = start; i < out.size(); i += 3) {
    const std::uint32_t a = out[i], b = out[i + 1], c = out[i + 2];
    if (a == b || b == c || c == a) continue;
    out[kept] = a, out[kept + 1] = b, out[kept + 2] = c;
    kept += 3;
  }
  out.resize(kept);
}

void FaceSink::reserve(std::size_t n) {
  faces_.shapes.reserve(n);
  faces_.vertices.reserve(3 * n);
}

std::string FaceSink::add(std::span<const std::int64_t> polygon, ModelRef model) {
  std::string wrong = add_any(polygon, model);
  if (keeps_origins_) {
    ++file_faces_;
    file_corners_ += static_cast<std::uint32_t>(polygon.size());
  }
  return wrong;
}

std::string FaceSink::add_any(std::span<const std::int64_t> polygon, ModelRef model) {
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(polygon[i]); };
  if (polygon.size() == 3 && !outside(polygon[0], vertex_count_) &&
      !outside(polygon[1], vertex_count_) && !outside(polygon[2], vertex_count_) &&
      polygon[0] != polygon[1] && polygon[1] != polygon[2] && polygon[2] != polygon[0]) {
    push(corner(0), corner(1), corner(2), model);
    return {};
  }
  std::string wrong = polygon_defect(polygon, vertex_count_, first_);
  if (!wrong.empty()) return wrong;
  if (polygon.size() > 3 && !repeats_vertex(polygon)) {
    keep_place(polygon, polygon, model);
  } else {
    add_walk(polygon, model);
  }
  return {};
}

std::string FaceSink::add_edge(std::int64_t a, std::int64_t b, ModelRef model) {
  const std::int64_t ends[] = {a, b};
  std::string wrong = range_defect(ends, vertex_count_, first_);
  if (!wrong.empty()) return wrong;
  if (a == b) {
    ++repeats_.edges;
  } else {
    edges_.add(Shape::Line, {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)}, model);
    if (keeps_edge_origins_) edge_origins_.push_back(file_edges_);
  }
  ++file_edges_;
  return {};
}

/// A face with repeated or too few corners.
void FaceSink::add_walk(std::span<const std::int64_t> polygon, ModelRef model) {
  walk_.assign(polygon.begin(), polygon.end());
  trim_walk(walk_);
  ++(walk_.size() < 3 ? repeats_.faces : repeats_.cut);
  if (walk_.size() < 3) return;
  keep_place(walk_, polygon, model);
  bridged_ += repeats_vertex(walk_);
}

/// A fan keeps the place of a polygon; finish() puts the real triangles there.
void FaceSink::keep_place(std::span<const std::int64_t> polygon,
                          std::span<const std::int64_t> whole, ModelRef model) {
  polygons_.push_back({faces_.size(), corners_.size(), polygon.size()});
  auto at = whole.begin();
  for (const std::int64_t index : polygon) {
    corners_.push_back(static_cast<std::uint32_t>(index));
    if (!keeps_origins_) continue;
    at = std::find(at, whole.end(), index);
    if (at == whole.end()) at = std::find(whole.begin(), whole.end(), index);
    places_.push_back(file_corners_ + static_cast<std::uint32_t>(at - whole.begin()));
  }
  const std::span<const std::uint32_t> corners =
      std::span(corners_).subspan(corners_.size() - polygon.size());
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    push(corners[0], corners[i], corners[i + 1], model);
}

void FaceSink::push(std::uint32_t a, std::uint32_t b, std::uint32_t c, ModelRef model) {
  faces_.add(Shape::Triangle, {a, b, c}, model);
  if (keeps_origins_)
    origins_.push_back({file_faces_, {file_corners_, file_corners_ + 1, file_corners_ + 2}});
}

void FaceSink::finish(MeshData& mesh, std::vector<std::string>& notes) {
  if (origins_.size() != faces_.size() || places_.size() != corners_.size()) {
    keeps_origins_ = false;
    origins_.clear();
  }
  std::vector<std::uint32_t> triangles;
  for (const Polygon& polygon : polygons_) {
    triangles.clear();
    triangles_of_walk(mesh.positions, std::span(corners_).subspan(polygon.start, polygon.size),
                      triangles);
    triangles.resize(3 * (polygon.size - 2));  // what is missing repeats vertex 0
    std::copy(triangles.begin(), triangles.end(),
              faces_.vertices.begin() + static_cast<std::ptrdiff_t>(3 * polygon.triangle));
    if (keeps_origins_) find_corners(polygon);
  }
  if (bridged_ > 0) drop_empty_places();
  mesh.faces = std::move(faces_);
  mesh.edges = std::move(edges_);
  note_polygons(notes, polygons_.size() - repeats_.cut);
  repeats_.note(notes);
}

/// Which of the polygon's corners those of its triangles are.
void FaceSink::find_corners(const Polygon& polygon) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> known;
  for (std::size_t k = polygon.start; k < polygon.start + polygon.size; ++k)
    known.emplace_back(corners_[k], places_[k]);
  std::sort(known.begin(), known.end());
  for (std::size_t t = polygon.triangle; t < polygon.triangle + polygon.size - 2; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::lower_bound(known.begin(), known.end(),
                                       std::pair(faces_.vertices[3 * t + k], std::uint32_t{0}));
      if (at != known.end()) origins_[t].corners[k] = at->second;
    }
}

void FaceSink::drop_empty_places() {
  EntityList kept;
  std::size_t origins = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const std::uint32_t* v = &faces_.vertices[3 * i];
    if (v[0] == v[1]) continue;
    if (keeps_origins_) origins_[origins++] = origins_[i];
    kept.add(Shape::Triangle, {v[0], v[1], v[2]},
             faces_.classes.empty() ? ModelRef() : faces_.classes[i]);
  }
  faces_ = std::move(kept);
  origins_.resize(origins);
}

void spread_to_faces(Attribute& array, const std::vector<FaceOrigin>& origins) {
  std::vector<std::uint32_t> from;
  from.reserve(origins.size());
  for (const FaceOrigin& origin : origins) from.push_back(origin.face);
  take_values(array, from);
}

void spread_to_corners(Attribute& array, const std::vector<FaceOrigin>& origins) {
  std::vector<std::uint32_t> from;
  from.reserve(3 * origins.size());
  for (const FaceOrigin& origin : origins)
    from.insert(from.end(), origin.corners.begin(), origin.corners.end());
  take_values(array, from);
}

void take_values(Attribute& array, const std::vector<std::uint32_t>& from) {
  const auto n = static_cast<std::size_t>(array.components);
  bool same = array.values.size() == n * from.size();
  for (std::size_t i = 0; same && i < from.size(); ++i) same = from[i] == i;
  if (same) return;
  std::vector<double> values;
  values.reserve(n * from.size());
  for (const std::uint32_t i : from) {
    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(n * i);
    values.insert(values.end(), first, first + array.components);
  }
  array.values = std::move(values);
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
