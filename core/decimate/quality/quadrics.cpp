// The quadrics of the quality strategy: what the surface around each vertex is.

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/decimate/quality/collapse_queue.h"
#include "core/mesh/geometry.h"

namespace aomd {

// On a model edge the surface looks several ways at once, which says nothing about the faces beside
// it.
void CollapseQueue::add_normal(Vertex v, const glm::vec3& normal) {
  if (state_[v].model.dimension() > 1) normal_[v] += normal;
}

// Every face is a plane to its three vertices, by its area (Garland, Heckbert 1997).
void CollapseQueue::quadrics_of_faces() {
  for (const Face f : mesh_.faces()) {
    const auto t = mesh_.triangle(f);
    const glm::dvec3 normal =
        area_normal(mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2]));
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    const glm::vec3 unit(normal / length);
    const float share = static_cast<float>(length / (6 * rules_.unit_area));
    for (const Vertex v : t) {
      state_[v].quadric.add_plane(unit, 0, share);
      state_[v].area += share;
      add_normal(v, share * unit);
    }
  }
}

// Every point of the original is a plane to the vertices of the face that it lies on, by its
// barycentric coordinates: what many collapses have added up is measured anew.
void CollapseQueue::quadrics_of_points() {
  for (const OriginalPoint& p : original_.points()) {
    if (p.face == no_index) continue;
    const auto t = mesh_.triangle(Face(p.face));
    for (int k = 0; k < 3; ++k) {
      const Vertex v = t[static_cast<std::size_t>(k)];
      const float share = p.weight * p.barycentric[k] / static_cast<float>(rules_.unit_area);
      const glm::vec3 off(mesh_.position(v) - p.position);
      state_[v].quadric.add_plane(p.normal, glm::dot(p.normal, off), share);
      state_[v].area += share;
      add_normal(v, share * p.normal);
    }
  }
}

void CollapseQueue::add_values(bool by_points) {
  attributes_.reset(mesh_.capacity(0), values_->components());
  if (by_points || !values_->made_of(mesh_))
    add_values_of_points();
  else
    add_values_of_faces();
}

// As long as the mesh is the original.
void CollapseQueue::add_values_of_faces() {
  std::size_t number = 0;
  for (const Face f : mesh_.faces()) {
    const auto points = values_->corners(number++);
    const auto t = mesh_.triangle(f);
    const std::array corners{mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])};
    const double area = glm::length(area_normal(corners[0], corners[1], corners[2])) / 2;
    if (!(area > 0)) continue;
    const float share = static_cast<float>(area / (3 * rules_.unit_area));
    for (std::size_t c = 0; c < values_->components(); ++c) {
      const auto value = [&](std::size_t k) { return values_->at_point(points[k])[c]; };
      if (std::isnan(value(0) + value(1) + value(2))) continue;
      const glm::vec3 gradient(
          gradient_of(corners, {double(value(0)), double(value(1)), double(value(2))}));
      for (std::size_t k = 0; k < 3; ++k) attributes_.add(t[k], c, value(k), gradient, share);
    }
  }
}

// What each point of the original says of the vertices of the face that it lies on.
void CollapseQueue::add_values_of_points() {
  std::vector<glm::vec3> gradients(values_->components());
  for (std::size_t i = 0; i < original_.points().size(); ++i) {
    const OriginalPoint& p = original_.points()[i];
    if (p.face == no_index) continue;
    values_->gradients(i, gradients);
    const auto t = mesh_.triangle(Face(p.face));
    for (int k = 0; k < 3; ++k) {
      const Vertex v = t[static_cast<std::size_t>(k)];
      const float share = p.weight * p.barycentric[k] / static_cast<float>(rules_.unit_area);
      const glm::vec3 off(mesh_.position(v) - p.position);
      for (std::size_t c = 0; c < gradients.size(); ++c)
        if (const float value = values_->at_point(i)[c]; !std::isnan(value))
          attributes_.add(v, c, value + glm::dot(gradients[c], off), gradients[c], share);
    }
  }
}

}  // namespace aomd
