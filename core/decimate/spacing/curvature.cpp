#include "core/decimate/spacing/curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/mesh/bulk.h"
#include "core/mesh/geometry.h"

namespace aomd {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// The triangles of the surface, cut open along the model edges: a vertex there is one point for
/// each model face. Other vertices keep their index.
struct CutSurface {
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> vertex_of;  ///< by point

  explicit CutSurface(const Mesh& mesh);
};

bool on_model_edge(const Mesh& mesh, Vertex v) { return mesh.classification(v).dimension() <= 1; }

CutSurface::CutSurface(const Mesh& mesh) : vertex_of(mesh.capacity(0)) {
  for (std::uint32_t v = 0; v < vertex_of.size(); ++v) vertex_of[v] = v;
  triangles.reserve(mesh.count(2));
  std::unordered_map<std::uint64_t, std::uint32_t> points;
  const bool volume = mesh.count(3) > 0;
  const auto point = [&](std::uint32_t v, ModelRef face) {
    if (!on_model_edge(mesh, Vertex(v))) return v;
    const auto fresh = static_cast<std::uint32_t>(vertex_of.size());
    const auto [at, made] = points.try_emplace(std::uint64_t{v} << 32 | face.bits(), fresh);
    if (made) vertex_of.push_back(v);
    return at->second;
  };
  const VertexRows faces(mesh, 2);
  faces.each([&](std::uint32_t id, const std::uint32_t* v) {
    const ModelRef model = mesh.classification(Face(id));
    if (volume && model.dimension() != 2) return;
    const int n = faces.shape(id).vertex_count;
    for (int k = 2; k < n; ++k)
      triangles.push_back({point(v[0], model), point(v[k - 1], model), point(v[k], model)});
  });
}

/// A symmetric tensor times an area, and the area.
struct Bending {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, area = 0;

  void add(const glm::dmat3& m, double its_area) {
    xx += m[0][0], yy += m[1][1], zz += m[2][2];
    xy += 0.5 * (m[0][1] + m[1][0]), xz += 0.5 * (m[0][2] + m[2][0]),
        yz += 0.5 * (m[1][2] + m[2][1]);
    area += its_area;
  }
  Bending& operator+=(const Bending& b) {
    xx += b.xx, xy += b.xy, xz += b.xz, yy += b.yy, yz += b.yz, zz += b.zz, area += b.area;
    return *this;
  }
  [[nodiscard]] glm::dvec3 times(const glm::dvec3& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
            xz * v.x + yz * v.y + zz * v.z};
  }
};

class BendingOfSurface {
 public:
  explicit BendingOfSurface(const Mesh& mesh) : mesh_(mesh), surface_(mesh) {}

  void find_normals();
  void find_bending();
  void smooth();
  void raise(Column<Vertex, double>& curvature) const;

 private:
  [[nodiscard]] const glm::dvec3& position(std::uint32_t point) const {
    return mesh_.position(Vertex(surface_.vertex_of[point]));
  }
  [[nodiscard]] double largest_eigenvalue(std::uint32_t point) const;

  const Mesh& mesh_;
  CutSurface surface_;
  std::vector<glm::dvec3> normals_;
  std::vector<Bending> bending_;
};

// Weighted by sin(angle) / (product of the two sides), which is exact where the vertices lie on a
// sphere, however lopsided the star (Max, "Weights for computing vertex normals from facet
// normals", 1999).
void BendingOfSurface::find_normals() {
  normals_.assign(surface_.vertex_of.size(), glm::dvec3(0));
  for (const auto& [a, b, c] : surface_.triangles) {
    const glm::dvec3 &pa = position(a), &pb = position(b), &pc = position(c);
    const glm::dvec3 normal = area_normal(pa, pb, pc);
    if (is_flat(pa, pb, pc, normal)) continue;
    const double ab = glm::dot(pb - pa, pb - pa), bc = glm::dot(pc - pb, pc - pb),
                 ca = glm::dot(pa - pc, pa - pc);
    const glm::dvec3 weighted = normal / (ab * bc * ca);
    normals_[a] += bc * weighted, normals_[b] += ca * weighted, normals_[c] += ab * weighted;
  }
  for (glm::dvec3& normal : normals_)
    if (const double length = glm::length(normal); length > 0) normal /= length;
}

// The derivative of a linear function with values n_i at the corners is the sum of n_i times the
// gradient of the i-th barycentric coordinate, (normal x opposite side) / (2 area).
void BendingOfSurface::find_bending() {
  bending_.assign(normals_.size(), {});
  for (const Corners& t : surface_.triangles) {
    const std::array<glm::dvec3, 3> p{position(t[0]), position(t[1]), position(t[2])};
    const glm::dvec3 normal = area_normal(p[0], p[1], p[2]);
    if (is_flat(p[0], p[1], p[2], normal)) continue;
    const double twice_area = glm::length(normal);
    const glm::dvec3 half = normal / (2 * twice_area);
    glm::dmat3 sum(0);
    for (std::size_t i = 0; i < 3; ++i)
      sum += glm::outerProduct(normals_[t[i]], glm::cross(half, p[(i + 2) % 3] - p[(i + 1) % 3]));
    for (const std::uint32_t point : t) bending_[point].add(sum, 0.5 * twice_area);
  }
}

// The sums of a star become those of the stars in it. Tensors are averaged, not normals: where
// stars are lopsided the mean normal leans, the mean of a constant does not.
void BendingOfSurface::smooth() {
  std::vector<Bending> before(bending_.size());
  before.swap(bending_);
  for (const auto& [a, b, c] : surface_.triangles) {
    Bending sum = before[a];
    sum += before[b], sum += before[c];
    bending_[a] += sum, bending_[b] += sum, bending_[c] += sum;
  }
}

double BendingOfSurface::largest_eigenvalue(std::uint32_t point) const {
  const Bending& b = bending_[point];
  const glm::dvec3& n = normals_[point];
  const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, axis)), w = glm::cross(n, u);
  const glm::dvec3 bu = b.times(u), bw = b.times(w);
  const double mean = 0.5 * (glm::dot(u, bu) + glm::dot(w, bw));
  const double half_difference = 0.5 * (glm::dot(u, bu) - glm::dot(w, bw));
  const double mixed = glm::dot(u, bw);
  return (std::abs(mean) + std::sqrt(half_difference * half_difference + mixed * mixed)) / b.area;
}

void BendingOfSurface::raise(Column<Vertex, double>& curvature) const {
  for (std::uint32_t point = 0; point < bending_.size(); ++point) {
    if (bending_[point].area <= 0 || normals_[point] == glm::dvec3(0)) continue;
    double& at_vertex = curvature[Vertex(surface_.vertex_of[point])];
    at_vertex = std::max(at_vertex, largest_eigenvalue(point));
  }
}

/// The model edges as polylines. Their curvature is a vector at each inner vertex: the change of
/// the unit tangent over half the length of the two edges there. Averaging vectors lets the teeth
/// of a jagged line cancel.
class BendingOfCurves {
 public:
  explicit BendingOfCurves(const Mesh& mesh);
  void raise(Column<Vertex, double>& curvature) const;

 private:
  struct Bend {
    glm::dvec3 change{0};
    double length = 0;
    int edges = 0;
  };
  [[nodiscard]] bool inner(Vertex v) const {
    const auto found = bends_.find(v.index);
    return found != bends_.end() && found->second.edges == 2 &&
           mesh_.classification(v).dimension() == 1;
  }

  const Mesh& mesh_;
  std::vector<std::array<Vertex, 2>> edges_;
  std::unordered_map<std::uint32_t, Bend> bends_;
};

BendingOfCurves::BendingOfCurves(const Mesh& mesh) : mesh_(mesh) {
  VertexBuffer buffer;
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() != 1) continue;
    const auto v = mesh.vertices_of(e, buffer);
    edges_.push_back({Vertex(v[0]), Vertex(v[1])});
    const glm::dvec3 along = mesh.position(edges_.back()[1]) - mesh.position(edges_.back()[0]);
    const double length = glm::length(along);
    for (const double side : {1.0, -1.0}) {
      Bend& bend = bends_[v[side > 0 ? 0 : 1]];
      if (length > 0) bend.change += side / length * along;
      bend.length += 0.5 * length;
      ++bend.edges;
    }
  }
}

// A vertex counts twice, its neighbours on the curve once.
void BendingOfCurves::raise(Column<Vertex, double>& curvature) const {
  std::unordered_map<std::uint32_t, std::pair<glm::dvec3, double>> sums;
  for (const auto& edge : edges_)
    for (const int k : {0, 1}) {
      const Vertex to = edge[static_cast<std::size_t>(k)];
      if (!inner(to)) continue;
      auto& [sum, weight] = sums.try_emplace(to.index, glm::dvec3(0), 0.0).first->second;
      for (const Vertex from : edge) {
        const Bend& bend = bends_.at(from.index);
        if (!inner(from) || bend.length <= 0) continue;
        sum += bend.change / bend.length;
        weight += 1;
      }
    }
  for (const auto& [v, mean] : sums)
    if (mean.second > 0)
      curvature[Vertex(v)] = std::max(curvature[Vertex(v)], glm::length(mean.first) / mean.second);
}

}  // namespace

Column<Vertex, double> vertex_curvatures(const Mesh& mesh, int smoothing) {
  Column<Vertex, double> curvature(mesh.capacity(0), 0.0);
  BendingOfSurface surface(mesh);
  surface.find_normals();
  surface.find_bending();
  for (int pass = 0; pass < smoothing; ++pass) surface.smooth();
  surface.raise(curvature);
  BendingOfCurves(mesh).raise(curvature);
  return curvature;
}

}  // namespace aomd
