#pragma once
// The model faces around a place that are flat there: what lies on them stays on them.

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/geometry.h"
#include "core/mesh/mesh.h"
#include "core/operators/star.h"

namespace aomd {

/// One model face around a place, as far as stars were added.
struct ModelFacePart {
  ModelRef face;
  glm::dvec3 normal{0.0};  ///< the sum of the area normals
  double area = 0;         ///< the sum of their lengths

  /// Flat to less than a thousandth of a degree: files may hold coordinates in single precision.
  [[nodiscard]] bool flat() const {
    constexpr double flat = 1e-10;
    return area > 0 && glm::length(normal) >= (1 - flat) * area;
  }
};

/// The parts of all model faces in some stars. Reused, it allocates nothing.
class ModelPlanes {
 public:
  void clear() { parts_.clear(); }
  void add(const Mesh& mesh, Vertex centre, const Star& star) {
    const glm::dvec3 at = mesh.position(centre);
    for (const StarFace& f : star) {
      const glm::dvec3 n = area_normal(at, mesh.position(f.next), mesh.position(f.previous));
      ModelFacePart& part = of(mesh.classification(f.face));
      // Neighbours of one model face may be listed either way round.
      part.normal += glm::dot(n, part.normal) < 0 ? -n : n;
      part.area += glm::length(n);
    }
  }
  [[nodiscard]] const std::vector<ModelFacePart>& parts() const { return parts_; }

 private:
  ModelFacePart& of(ModelRef face) {
    for (ModelFacePart& p : parts_)
      if (p.face == face) return p;
    parts_.push_back({.face = face});
    return parts_.back();
  }

  std::vector<ModelFacePart> parts_;
};

}  // namespace aomd
