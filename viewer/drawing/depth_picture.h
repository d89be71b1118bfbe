#pragma once
// How far a surface comes towards somebody who looks at all of it from far away, without the GPU.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// A square picture of what lies within `radius` of the origin, without perspective.
class DepthPicture {
 public:
  DepthPicture(glm::vec3 towards, float radius, int width_px);

  /// Face slots. Nothing is too small to be seen: corners count as well as the middles of pixels.
  void draw(std::span<const Corner> corners);
  [[nodiscard]] int width() const { return width_; }
  /// In units of the world.
  [[nodiscard]] float pixel_size() const { return 1 / scale_; }
  /// Where a place is in the picture, in pixels, and how far towards the eye.
  [[nodiscard]] glm::vec3 seen(glm::vec3 place) const;
  /// The opposite.
  [[nodiscard]] glm::vec3 place(glm::vec3 seen) const;
  /// Of the pixel there; the lowest number where nothing is.
  [[nodiscard]] float depth_at(glm::vec3 seen) const { return depth_[index(seen)]; }
  [[nodiscard]] bool covered(int x, int y) const;

 private:
  [[nodiscard]] int clamped(float v) const;
  [[nodiscard]] std::size_t index(glm::vec3 seen) const;
  void draw(const std::array<glm::vec3, 3>& t);

  glm::vec3 towards_, right_, up_;
  int width_;
  float scale_;  ///< pixels a unit
  std::vector<float> depth_;
};

}  // namespace aomd::scene
