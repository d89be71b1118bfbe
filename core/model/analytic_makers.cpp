// Ready-made analytic models.

#include "core/model/analytic_model.h"

namespace aomd {
namespace {

constexpr glm::dvec3 up{0, 0, 1};

Frame at_height(double z) { return Frame::around({0, 0, z}, up); }

ModelRef edge(std::int32_t tag) { return {1, tag}; }
ModelRef face(std::int32_t tag) { return {2, tag}; }

// The eight vertices, twelve edges and six sides of a box around the origin. Corner i has the high
// x, y, z where bit 0, 1, 2 of i is set.
class BoxParts {
 public:
  explicit BoxParts(const glm::dvec3& size) : half_(0.5 * size) {
    for (int i = 0; i < 8; ++i) entities_.push_back({i + 1, PointShape{corner(i)}, {}});
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 8; ++i)
        if ((i >> axis & 1) == 0) add_edge(i, i | 1 << axis);
    for (int axis = 0; axis < 3; ++axis) add_side(axis, 0), add_side(axis, 1);
  }
  [[nodiscard]] std::vector<AnalyticEntity> take() { return std::move(entities_); }

 private:
  [[nodiscard]] glm::dvec3 corner(int i) const {
    return half_ * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }

  void add_edge(int a, int b) {
    edges_.push_back({a, b});
    entities_.push_back({static_cast<std::int32_t>(edges_.size()),
                         SegmentShape{corner(a), corner(b)},
                         {ModelRef(0, a + 1), ModelRef(0, b + 1)}});
  }

  void add_side(int axis, int high) {
    glm::dvec3 outward(0);
    outward[axis] = high ? 1 : -1;
    AnalyticEntity side{
        2 * axis + high + 1, PlaneShape{Frame::around(half_ * outward, outward)}, {}};
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if ((edges_[k][0] >> axis & 1) == high && (edges_[k][1] >> axis & 1) == high)
        side.boundary.push_back(edge(static_cast<std::int32_t>(k) + 1));
    entities_.push_back(std::move(side));
  }

  glm::dvec3 half_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<AnalyticEntity> entities_;
};

}  // namespace

AnalyticModel cylinder_model(double radius, double height) {
  return AnalyticModel({{1, ArcShape{at_height(0), radius}, {}},
                        {2, ArcShape{at_height(height), radius}, {}},
                        {1, CylinderShape{Frame(), radius}, {edge(1), edge(2)}},
                        {2, PlaneShape{Frame::around({0, 0, 0}, -up)}, {edge(1)}},
                        {3, PlaneShape{at_height(height)}, {edge(2)}},
                        {1, RegionShape(), {face(1), face(2), face(3)}}});
}

AnalyticModel sphere_model(double radius) {
  return AnalyticModel({{1, SphereShape{Frame(), radius}, {}}, {1, RegionShape(), {face(1)}}});
}

AnalyticModel torus_model(double major, double minor) {
  return AnalyticModel({{1, TorusShape{Frame(), major, minor}, {}}, {1, RegionShape(), {face(1)}}});
}

AnalyticModel drilled_box_model(const glm::dvec3& size, double hole_radius) {
  std::vector<AnalyticEntity> entities = BoxParts(size).take();
  for (AnalyticEntity& e : entities)
    if (std::holds_alternative<PlaneShape>(e.shape) && e.tag >= 5)
      e.boundary.push_back(edge(e.tag + 8));
  entities.push_back({13, ArcShape{at_height(-0.5 * size.z), hole_radius}, {}});
  entities.push_back({14, ArcShape{at_height(0.5 * size.z), hole_radius}, {}});
  entities.push_back({7, CylinderShape{Frame(), hole_radius}, {edge(13), edge(14)}});
  AnalyticEntity region{1, RegionShape(), {}};
  for (std::int32_t tag = 1; tag <= 7; ++tag) region.boundary.push_back(face(tag));
  entities.push_back(std::move(region));
  return AnalyticModel(entities);
}

}  // namespace aomd
