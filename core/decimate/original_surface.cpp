#include "core/decimate/original_surface.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <numeric>
#include <vector>

#include "core/mesh/geometry.h"
#include "core/mesh/parallel.h"
#include "core/model/box.h"
#include "core/model/triangle_tree.h"

namespace aomd {
namespace {

constexpr std::size_t points_a_piece = 1024;

// Sums of a fixed number of faces are added up in their order: the same digits with any number of threads.
double area_of(const Mesh& mesh, int threads) {
  constexpr std::size_t faces_a_sum = 4096;
  std::vector<double> sums(mesh.capacity(2) / faces_a_sum + 1, 0);
  parallel_for(sums.size(), threads, 1, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(2), begin * faces_a_sum, end * faces_a_sum, [&](std::uint32_t f) {
      const auto t = mesh.triangle(Face(f));
      sums[f / faces_a_sum] +=
          0.5 * glm::length(area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])));
    });
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

OriginalSurface::OriginalSurface(const Mesh& mesh, Sampling sampling, int threads)
    : taken_by_(mesh.capacity(0)) {
  for (const Vertex v : mesh.vertices()) {
    taken_by_[v] = v;
    if (!mesh.row<2>(v).empty()) vertex_of_.push_back(v);
  }
  points_.resize(vertex_of_.size());
  parallel_for(points_.size(), threads, points_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) set_point(mesh, i);
  });
  Box box;
  for (const OriginalPoint& p : points_) box.add(p.position);
  diagonal_ = box.diagonal();
  area_ = area_of(mesh, threads);
  if (sampling == Sampling::VerticesAndFaces) add_faces(mesh);
}

void OriginalSurface::add_faces(const Mesh& mesh) {
  for (OriginalPoint& p : points_) p.weight /= 4;
  points_.reserve(points_.size() + mesh.count(2));
  vertex_of_.reserve(points_.capacity());
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    const glm::dvec3 normal = area_normal(a, b, c);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    points_.push_back({.position = (a + b + c) / 3.0,
                       .normal = glm::vec3(normal / length),
                       .weight = static_cast<float>(0.75 * length / 2)});
    vertex_of_.push_back(t[0]);
  }
}

void OriginalSurface::set_point(const Mesh& mesh, std::size_t i) {
  glm::dvec3 normal(0.0);
  double area = 0;  // twice that of the faces around it
  for (const Face f : mesh.row<2>(vertex_of_[i])) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 n = area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    normal += n;
    area += glm::length(n);
  }
  OriginalPoint& p = points_[i];
  p.position = mesh.position(vertex_of_[i]);
  p.weight = static_cast<float>(area / 6);
  if (area > 0) normal /= area;  // at any scale it can be squared then
  if (const double length = glm::length(normal); length > 0) p.normal = glm::vec3(normal / length);
}

// Several threads may shorten the same path at once: whatever they write leads to the same end.
Vertex OriginalSurface::taken_by(Vertex v) {
  const auto next = [this](Vertex of) {
    return Vertex(std::atomic_ref(taken_by_[of].index).load(std::memory_order_relaxed));
  };
  Vertex last = v;
  for (Vertex after = next(last); after != last; after = next(last)) last = after;
  for (Vertex after = next(v); after != last; after = next(v)) {
    std::atomic_ref(taken_by_[v].index).store(last.index, std::memory_order_relaxed);
    v = after;
  }
  return last;
}

void OriginalSurface::start_at_vertex(const Mesh& mesh, OriginalPoint& p, Vertex v) const {
  double best = std::numeric_limits<double>::infinity();
  p.face = no_index;
  for (const Face f : mesh.row<2>(v)) {
    const auto t = mesh.triangle(f);
    glm::dvec3 at;
    const double d =
        nearest_barycentric(p.position, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), at);
    if (d >= best) continue;
    best = d;
    p.face = f.index;
    p.barycentric = at;
  }
  p.distance2 = static_cast<float>(best);
}

// To the better one of the faces that the nearest place also lies on: across its edge, or around its corner;
// only faces that look the way the original did count, so that no point goes through a thin wall.
bool OriginalSurface::walk_once(const Mesh& mesh, OriginalPoint& p) const {
  const Face from(p.face);
  const auto corners = mesh.triangle(from);
  const glm::vec3 at = p.barycentric;
  const std::size_t k = at.x > 0 ? 0 : at.y > 0 ? 1 : 2;
  const bool on_edge = (at.x > 0) + (at.y > 0) + (at.z > 0) > 1;
  const Vertex other = corners[k == 0 && at.y > 0 ? 1 : 2];
  bool moved = false;
  for (const Face f : mesh.row<2>(corners[k])) {
    const auto t = mesh.triangle(f);
    if (f == from || (on_edge && t[0] != other && t[1] != other && t[2] != other)) continue;
    const glm::dvec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    glm::dvec3 place;
    const double d = nearest_barycentric(p.position, a, b, c, place);
    if (d >= p.distance2 * 0.999999 || glm::dot(area_normal(a, b, c), glm::dvec3(p.normal)) <= 0) continue;
    p.distance2 = static_cast<float>(d);
    p.face = f.index;
    p.barycentric = place;
    moved = true;
  }
  return moved;
}

void OriginalSurface::find_face(const Mesh& mesh, OriginalPoint& p) const {
  constexpr int most_steps = 10;
  for (int step = 0; step < most_steps; ++step) {
    const glm::vec3& at = p.barycentric;
    if (at.x > 0 && at.y > 0 && at.z > 0) return;  // the nearest place is inside the face
    if (!walk_once(mesh, p)) return;
  }
}

void OriginalSurface::locate_point(const Mesh& mesh, std::size_t i) {
  OriginalPoint& p = points_[i];
  if (p.face != no_index && mesh.alive(Face(p.face))) {
    const auto t = mesh.triangle(Face(p.face));
    glm::dvec3 at;
    p.distance2 = static_cast<float>(
        nearest_barycentric(p.position, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), at));
    p.barycentric = at;
  } else {
    start_at_vertex(mesh, p, taken_by(vertex_of_[i]));
  }
  if (p.face != no_index) find_face(mesh, p);
}

void OriginalSurface::locate(const Mesh& mesh, int threads) {
  parallel_for(points_.size(), threads, points_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) locate_point(mesh, i);
  });
  link_points(mesh);
}

// Of equally near faces the hint decides: it is forgotten at the same points for any number of threads.
void OriginalSurface::locate_anywhere(const Mesh& mesh, int threads) {
  taken_by_.resize(mesh.capacity(0));
  for (const Vertex v : mesh.vertices()) taken_by_[v] = v;
  const Triangles triangles = triangles_of(mesh);
  const TriangleTree tree(triangles.corners);
  parallel_for(points_.size() / points_a_piece + 1, threads, 1, [&](std::size_t begin, std::size_t end) {
    std::uint32_t hint = no_index;
    for (std::size_t i = begin * points_a_piece; i < std::min(end * points_a_piece, points_.size()); ++i) {
      OriginalPoint& p = points_[i];
      if (i % points_a_piece == 0) hint = no_index;
      hint = tree.nearest(p.position, hint).triangle;
      p.face = hint == no_index ? no_index : triangles.faces[tree.source(hint)].index;
      if (p.face != no_index) vertex_of_[i] = mesh.triangle(Face(p.face))[0];
    }
  });
  locate(mesh, threads);
}

void OriginalSurface::link_points(const Mesh& mesh) {
  first_.assign(mesh.capacity(2), no_index);
  normal_.assign(mesh.capacity(2), glm::vec3(0.0f));
  for (std::uint32_t i = static_cast<std::uint32_t>(points_.size()); i-- > 0;) {
    OriginalPoint& p = points_[i];
    if (p.face == no_index) continue;
    p.next = first_[Face(p.face)];
    first_[Face(p.face)] = i;
    normal_[Face(p.face)] += p.weight * p.normal;
  }
}

double OriginalSurface::error() const {
  double sum = 0;
  for (const OriginalPoint& p : points_)
    if (p.face != no_index) sum += double(p.weight) * double(p.distance2);
  return sum;
}

}  // namespace aomd
