#include "core/decimate/quality/attribute_quadrics.h"

namespace aomd {

void AttributeQuadrics::reset(std::size_t vertices, std::size_t components) {
  components_ = components;
  squares_.assign(vertices, {});
  sums_.assign(vertices * components, {});
}

void AttributeQuadrics::add(Vertex v, std::size_t component, float value, const glm::vec3& gradient,
                            float area) {
  squares_[v.index].add_plane(gradient, value, area);
  Sums& s = sums(v)[component];
  s.gradient += area * gradient;
  s.value += area * value;
  s.area += area;
}

LocalQuadric AttributeQuadrics::together(Vertex v, Vertex w, const glm::vec3& along) const {
  LocalQuadric error = squares_[v.index].about(-along);
  error += squares_[w.index];
  for (std::size_t k = 0; k < components_; ++k) {
    const Sums &a = sums(v)[k], &b = sums(w)[k];
    const float area = a.area + b.area;
    if (!(area > 0)) continue;
    const float value = a.value - glm::dot(a.gradient, along) + b.value;
    error.add_plane((a.gradient + b.gradient) / area, value / area, -area);
  }
  return error;
}

void AttributeQuadrics::merge(Vertex deleted, const glm::vec3& from_deleted, Vertex kept,
                              const glm::vec3& from_kept) {
  squares_[kept.index] = squares_[kept.index].about(from_kept);
  squares_[kept.index] += squares_[deleted.index].about(from_deleted);
  for (std::size_t k = 0; k < components_; ++k) {
    Sums& into = sums(kept)[k];
    const Sums& from = sums(deleted)[k];
    into.value +=
        glm::dot(into.gradient, from_kept) + from.value + glm::dot(from.gradient, from_deleted);
    into.gradient += from.gradient;
    into.area += from.area;
  }
}

}  // namespace aomd
