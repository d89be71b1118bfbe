#include "core/decimate/quality/original_surface.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <vector>

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/mesh/geometry.h"
#include "core/model/nearest_lanes.h"
#include "core/model/triangle_tree.h"
#include "core/operators/star.h"

namespace aomd {
namespace {

constexpr std::size_t items_a_piece = 1024;

bool has(const std::array<Vertex, 3>& t, Vertex v) { return t[0] == v || t[1] == v || t[2] == v; }

bool looks_alike(const Mesh& mesh, Face f, const OriginalPoint& p) {
  const auto t = mesh.triangle(f);
  const glm::dvec3 normal =
      area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
  return glm::dot(normal, glm::dvec3(p.normal)) > 0;
}

}  // namespace

OriginalSurface::OriginalSurface(const Mesh& mesh, Sampling sampling, double inward)
    : taken_by_(mesh.capacity(0)) {
  add_vertices(mesh, sampling == Sampling::Vertices ? inward : 0);
  if (sampling == Sampling::VerticesAndFaces) add_faces(mesh);
}

OriginalSurface::OriginalSurface(const Mesh& mesh, const OriginalSamples& samples)
    : taken_by_(mesh.capacity(0)) {
  Box box;
  for (const Vertex v : mesh.vertices()) {
    taken_by_[v] = v;
    box.add(mesh.position(v));
  }
  diagonal_ = box.diagonal();
  points_.reserve(samples.size());
  vertex_of_.reserve(samples.size());
  for (const OriginalSample& s : samples) {
    area_ += double(s.weight);
    points_.push_back(
        {.position = s.position, .normal = s.normal, .weight = s.weight, .face = s.face.index});
    vertex_of_.push_back(mesh.triangle(s.face)[0]);
  }
}

OriginalSamples OriginalSurface::samples() const {
  OriginalSamples samples;
  samples.reserve(points_.size());
  for (const OriginalPoint& p : points_)
    if (p.face != no_index) samples.push_back({p.position, p.normal, p.weight, Face(p.face)});
  return samples;
}

// In the order in which faces use them.
void OriginalSurface::add_vertices(const Mesh& mesh, double inward) {
  Column<Vertex, std::uint32_t> point_of(mesh.capacity(0), no_index);
  vertex_of_.reserve(mesh.count(0));
  Box box;
  for (const Face f : mesh.faces())
    for (const Vertex v : mesh.triangle(f)) {
      if (point_of[v] != no_index) continue;
      point_of[v] = static_cast<std::uint32_t>(vertex_of_.size());
      vertex_of_.push_back(v);
      box.add(mesh.position(v));
    }
  for (const Vertex v : mesh.vertices()) taken_by_[v] = v;
  diagonal_ = box.diagonal();
  points_.resize(vertex_of_.size());
  share_out_faces(mesh, point_of);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    OriginalPoint& p = points_[i];
    p.position = mesh.position(vertex_of_[i]);
    const double length = glm::length(glm::dvec3(p.normal));
    if (length > 0) p.normal = glm::vec3(glm::dvec3(p.normal) / length);
  }
  if (inward > 0) draw_in(mesh, point_of, inward);
}

// Gives each face's normal and area to its corners.
void OriginalSurface::share_out_faces(const Mesh& mesh,
                                      const Column<Vertex, std::uint32_t>& point_of) {
  const double scale =
      diagonal_ > 0 ? 1 / (diagonal_ * diagonal_) : 1;  // single precision has no room for any unit
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 normal =
        area_normal(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
    const double area = glm::length(normal) / 2;
    area_ += area;
    for (const Vertex v : t) {
      OriginalPoint& p = points_[point_of[v]];
      p.normal += glm::vec3(scale * normal);
      p.weight += static_cast<float>(area / 3);
    }
  }
}

// A vertex stands for the part of a face that is nearest to it by barycentric coordinates. Where
// the faces look several ways the middle of these parts lies on none of them.
void OriginalSurface::draw_in(const Mesh& mesh, const Column<Vertex, std::uint32_t>& point_of,
                              double inward) {
  constexpr double alike = 0.9;  // of the area, as seen along the normal
  struct Part {
    double seen = 0,
           off = 0;  ///< its area as seen along the normal, and that times its middle's height
  };
  std::vector<Part> parts(points_.size());
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    const glm::dvec3 normal = area_normal(a, b, c), sum = a + b + c;
    const double third = glm::length(normal) / 6;
    for (const Vertex v : t) {
      const glm::dvec3 along = points_[point_of[v]].normal;
      Part& part = parts[point_of[v]];
      part.seen += glm::dot(along, normal) / 6;
      part.off += 7.0 / 36 * third * glm::dot(along, sum - 3.0 * mesh.position(v));
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    OriginalPoint& p = points_[i];
    const double area = p.weight;
    if (area > 0 && parts[i].seen >= alike * area)
      p.position += inward * parts[i].off / area * glm::dvec3(p.normal);
  }
}

void OriginalSurface::add_faces(const Mesh& mesh) {
  for (OriginalPoint& p : points_) p.weight /= 4;
  points_.reserve(points_.size() + mesh.count(2));
  vertex_of_.reserve(points_.capacity());
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const glm::dvec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    const glm::dvec3 normal = area_normal(a, b, c);
    const double area = glm::length(normal) / 2;
    if (!(area > 0)) continue;
    points_.push_back({.position = (a + b + c) / 3.0,
                       .normal = glm::vec3(normal / (2 * area)),
                       .weight = static_cast<float>(0.75 * area)});
    vertex_of_.push_back(t[0]);
  }
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

// Of the faces that look the way the original did, else of all: from a face behind an edge, where
// the nearest place may lie inside, no walk leads back. Two faces at a time.
void OriginalSurface::start_at_vertex(const Mesh& mesh, OriginalPoint& p, Vertex v) {
  const Row<2> faces = mesh.row<2>(v);
  const TwoPoints position(p.position), own_normal{glm::dvec3(p.normal)};
  const DoubleLanes zero(0.0);
  double best = std::numeric_limits<double>::infinity();
  bool faces_it = false;
  p.face = no_index;
  for (std::size_t begin = 0; begin < faces.size(); begin += DoubleLanes::count) {
    const std::array two{faces[begin], faces[std::min(begin + 1, faces.size() - 1)]};
    const auto f = mesh.triangle(two[0]), g = mesh.triangle(two[1]);
    const auto corner = [&](std::size_t k) {
      return two_points(mesh.position(f[k]), mesh.position(g[k]));
    };
    const TwoPoints a = corner(0), b = corner(1), c = corner(2);
    const auto alike = glm::dot(area_normal(a, b, c), own_normal) > zero;
    TwoPoints at;
    const DoubleLanes d = nearest_barycentric(position, a, b, c, at);
    for (std::size_t i = 0; i < two.size(); ++i) {
      const bool now = alike[i] != 0;
      if ((faces_it && !now) || (faces_it == now && d[i] >= best)) continue;
      faces_it = now;
      best = d[i];
      p.face = two[i].index;
      p.barycentric = {at.x[i], at.y[i], at.z[i]};
    }
  }
  p.distance2 = static_cast<float>(best);
}

// To the better one of the faces that the nearest place also lies on: across its edge, or around
// its corner; only faces that look the way the original did count, so that no point goes through a
// thin wall.
bool OriginalSurface::walk_once(const Mesh& mesh, OriginalPoint& p) {
  const Face from(p.face);
  const auto corners = mesh.triangle(from);
  const glm::vec3 at = p.barycentric;
  const std::size_t k = at.x > 0 ? 0 : at.y > 0 ? 1 : 2;
  const bool on_edge = (at.x > 0) + (at.y > 0) + (at.z > 0) > 1;
  const Vertex other = corners[k == 0 && at.y > 0 ? 1 : 2];
  bool moved = false;
  for (const Face f : on_edge ? fewer_faces(mesh, corners[k], other) : mesh.row<2>(corners[k])) {
    const auto t = mesh.triangle(f);
    if (f == from || (on_edge && !(has(t, corners[k]) && has(t, other)))) continue;
    const glm::dvec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
    glm::dvec3 place;
    const double d = nearest_barycentric(p.position, a, b, c, place);
    if (d >= p.distance2 * 0.999999 || glm::dot(area_normal(a, b, c), glm::dvec3(p.normal)) <= 0)
      continue;
    p.distance2 = static_cast<float>(d);
    p.face = f.index;
    p.barycentric = place;
    moved = true;
  }
  return moved;
}

void OriginalSurface::find_face(const Mesh& mesh, OriginalPoint& p) {
  constexpr int most_steps = 10;
  for (int step = 0; step < most_steps; ++step) {
    if (p.distance2 == 0) return;
    const glm::vec3& at = p.barycentric;
    if (at.x > 0 && at.y > 0 && at.z > 0) return;  // the nearest place is inside the face
    if (!walk_once(mesh, p)) return;
  }
}

void OriginalSurface::locate_point(const Mesh& mesh, std::size_t i) {
  OriginalPoint& p = points_[i];
  if (p.face != no_index && mesh.alive(Face(p.face)) && looks_alike(mesh, Face(p.face), p)) {
    const auto t = mesh.triangle(Face(p.face));
    glm::dvec3 at;
    p.distance2 = static_cast<float>(nearest_barycentric(
        p.position, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]), at));
    p.barycentric = at;
  } else {
    start_at_vertex(mesh, p, taken_by(vertex_of_[i]));
  }
  if (p.face != no_index) find_face(mesh, p);
}

void OriginalSurface::locate(const Mesh& mesh, int threads) {
  parallel_for(points_.size(), threads, items_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) locate_point(mesh, i);
  });
  link_points(mesh);
}

// Of equally near faces the hint decides: it is forgotten at the same points for any number of
// threads.
void OriginalSurface::locate_anywhere(const Mesh& mesh, int threads) {
  taken_by_.resize(mesh.capacity(0));
  for (const Vertex v : mesh.vertices()) taken_by_[v] = v;
  const Triangles triangles = triangles_of(mesh);
  const TriangleTree tree(triangles.corners);
  parallel_for(points_.size() / items_a_piece + 1, threads, 1,
               [&](std::size_t begin, std::size_t end) {
                 std::uint32_t hint = no_index;
                 for (std::size_t i = begin * items_a_piece;
                      i < std::min(end * items_a_piece, points_.size()); ++i) {
                   OriginalPoint& p = points_[i];
                   if (i % items_a_piece == 0) hint = no_index;
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
