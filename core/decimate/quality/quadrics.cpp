// The quadrics of the quality strategy: what the surface around each vertex is.

#include <utility>

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

}  // namespace aomd
