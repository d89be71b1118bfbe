#include "viewer/drawing/corner_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr float split_cosine = 0.76604444f;  // of 40 degrees
constexpr float half_cosine = 0.93969262f;   // of 20 degrees: any two of these are within 40

}  // namespace

glm::vec3 unit_or_zero(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 ? v / length : glm::vec3(0);
}

bool shares_normal(const glm::vec3& of_face, const glm::vec3& mean) {
  return glm::dot(of_face, mean) >= half_cosine;
}

FaceNormal face_normal(const Mesh& mesh, Face face) {
  const auto t = mesh.triangle(face);
  const glm::dvec3 p = mesh.position(t[0]), q = mesh.position(t[1]), r = mesh.position(t[2]);
  const glm::dvec3 normal = glm::cross(q - p, r - p);
  const double length = glm::length(normal);
  const auto angle = [&](double cosine) {
    return std::atan2(static_cast<float>(length), static_cast<float>(cosine));
  };
  return {t,
          length > 0 ? glm::vec3(normal / length) : glm::vec3(0),
          {angle(glm::dot(q - p, r - p)), angle(glm::dot(r - q, p - q))}};
}

std::span<const CornerNormals::Corner> CornerNormals::at(const Mesh& mesh, Vertex v) {
  gather(mesh, v);
  find_sharp_ones(mesh, v);
  if (sharp_.empty() && share_one()) return corners_;
  join_smooth_ones();
  sums_.assign(corners_.size(), glm::vec3(0));
  for (std::uint32_t i = 0; i < corners_.size(); ++i) sums_[root(i)] += weights_[i] * normals_[i];
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    const glm::vec3 sum = unit_or_zero(sums_[root(i)]);
    corners_[i].normal = sum == glm::vec3(0) ? glm::vec3(0, 0, 1) : sum;
  }
  return corners_;
}

void CornerNormals::gather(const Mesh& mesh, Vertex v) {
  corners_.clear();
  normals_.clear();
  weights_.clear();
  inside_.clear();
  for (const Face f : mesh.row<2>(v)) {
    if (faces_)
      add(mesh, f, v, (*faces_)[f]);
    else
      add(mesh, f, v, face_normal(mesh, f));
  }
}

void CornerNormals::add(const Mesh& mesh, Face f, Vertex v, const FaceNormal& normal) {
  const auto& t = normal.vertices;
  const std::uint32_t slot = t[0] == v ? 0 : t[1] == v ? 1 : 2;
  Corner& corner = corners_.emplace_back();
  corner.face = f;
  corner.slot = slot;
  corner.next = t[slot == 2 ? 0 : slot + 1];
  corner.previous = t[slot == 0 ? 2 : slot - 1];
  weights_.push_back(normal.angle(slot));
  normals_.push_back(normal.unit);
  inside_.push_back(mesh.classification(f).dimension() == 3);
}

void CornerNormals::find_sharp_ones(const Mesh& mesh, Vertex v) {
  sharp_.clear();
  for (const Edge e : mesh.row<1>(v))
    if (mesh.classification(e).dimension() <= 1) sharp_.push_back(mesh.other_end(e, v));
  std::sort(sharp_.begin(), sharp_.end());
}

/// What most vertices come to.
bool CornerNormals::share_one() {
  glm::vec3 sum(0);
  for (std::size_t i = 0; i < corners_.size(); ++i) sum += weights_[i] * normals_[i];
  const glm::vec3 mean = unit_or_zero(sum);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (inside_[i] != inside_[0] || !shares_normal(normals_[i], mean)) return false;
  for (Corner& c : corners_) c.normal = mean;
  return true;
}

void CornerNormals::join_smooth_ones() {
  parent_.resize(corners_.size());
  sides_.clear();
  for (std::uint32_t i = 0; i < parent_.size(); ++i) {
    parent_[i] = i;
    sides_.push_back({corners_[i].next, i});
    sides_.push_back({corners_[i].previous, i});
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
    return x.far != y.far ? x.far < y.far : x.corner < y.corner;
  });
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& x = sides_[i];
    if (std::binary_search(sharp_.begin(), sharp_.end(), x.far)) continue;
    // Of three and more faces at an edge each is held against all others: their ids have no say.
    for (std::size_t k = i + 1; k < sides_.size() && sides_[k].far == x.far; ++k) {
      const Side& y = sides_[k];
      if (inside_[x.corner] != inside_[y.corner]) continue;
      if (glm::dot(normals_[x.corner], normals_[y.corner]) < split_cosine) continue;
      const std::uint32_t i_root = root(x.corner);
      const std::uint32_t j_root = root(y.corner);
      parent_[std::max(i_root, j_root)] = std::min(i_root, j_root);
    }
  }
}

std::uint32_t CornerNormals::root(std::uint32_t i) const {
  while (parent_[i] != i) i = parent_[i];
  return i;
}

}  // namespace aomd::scene
