#include "viewer/scene/corner_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr double split_cosine = 0.76604444;  // of 40 degrees

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

std::span<const CornerNormals::Corner> CornerNormals::at(const Mesh& mesh, Vertex v) {
  gather(mesh, v);
  join_smooth_ones(mesh, v);
  sums_.assign(corners_.size(), glm::dvec3(0));
  for (std::uint32_t i = 0; i < corners_.size(); ++i) sums_[root(i)] += weights_[i] * normals_[i];
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const glm::dvec3 sum = unit_or_zero(sums_[root(i)]);
    corners_[i].normal = sum == glm::dvec3(0) ? glm::vec3(0, 0, 1) : glm::vec3(sum);
  }
  return corners_;
}

void CornerNormals::gather(const Mesh& mesh, Vertex v) {
  corners_.clear();
  normals_.clear();
  weights_.clear();
  sides_.clear();
  const glm::dvec3 p = mesh.position(v);
  for (const Face f : mesh.row<2>(v)) {
    const auto t = mesh.triangle(f);
    const std::uint32_t slot = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    const Vertex next = t[slot == 2 ? 0 : slot + 1];
    const Vertex previous = t[slot == 0 ? 2 : slot - 1];
    const auto corner = static_cast<std::uint32_t>(corners_.size());
    sides_.push_back({next, corner});
    sides_.push_back({previous, corner});
    corners_.push_back({f, slot});
    const glm::dvec3 a = mesh.position(next) - p;
    const glm::dvec3 b = mesh.position(previous) - p;
    const glm::dvec3 n = glm::cross(a, b);
    weights_.push_back(std::atan2(glm::length(n), glm::dot(a, b)));
    normals_.push_back(unit_or_zero(n));
  }
}

void CornerNormals::join_smooth_ones(const Mesh& mesh, Vertex v) {
  parent_.resize(corners_.size());
  for (std::uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i;
  sharp_.clear();
  for (const Edge e : mesh.row<1>(v)) {
    if (mesh.classification(e).dimension() > 1) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    sharp_.push_back(a == v ? b : a);
  }
  std::sort(sharp_.begin(), sharp_.end());
  std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
    return x.far != y.far ? x.far < y.far : x.corner < y.corner;
  });
  for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
    const Side& x = sides_[i];
    const Side& y = sides_[i + 1];
    if (x.far != y.far || std::binary_search(sharp_.begin(), sharp_.end(), x.far)) continue;
    if (glm::dot(normals_[x.corner], normals_[y.corner]) < split_cosine) continue;
    const std::uint32_t i_root = root(x.corner);
    const std::uint32_t j_root = root(y.corner);
    parent_[std::max(i_root, j_root)] = std::min(i_root, j_root);
  }
}

std::uint32_t CornerNormals::root(std::uint32_t i) const {
  while (parent_[i] != i) i = parent_[i];
  return i;
}

}  // namespace aomd::scene
