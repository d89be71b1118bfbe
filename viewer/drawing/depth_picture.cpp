#include "viewer/drawing/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr float nothing = -std::numeric_limits<float>::max();

}  // namespace

DepthPicture::DepthPicture(glm::vec3 towards, float radius, int width_px)
    : towards_(towards),
      right_(glm::normalize(glm::cross(
          std::abs(towards.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0), towards))),
      up_(glm::cross(towards, right_)),
      width_(width_px),
      scale_(0.5f * static_cast<float>(width_px) / radius),
      depth_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(width_px), nothing) {}

void DepthPicture::draw(std::span<const Corner> corners) {
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    draw({seen(corners[i].position), seen(corners[i + 1].position), seen(corners[i + 2].position)});
}

glm::vec3 DepthPicture::seen(glm::vec3 place) const {
  const float middle = 0.5f * static_cast<float>(width_);
  return {middle + scale_ * glm::dot(place, right_), middle + scale_ * glm::dot(place, up_),
          glm::dot(place, towards_)};
}

glm::vec3 DepthPicture::place(glm::vec3 seen) const {
  const float middle = 0.5f * static_cast<float>(width_);
  return ((seen.x - middle) * right_ + (seen.y - middle) * up_) / scale_ + seen.z * towards_;
}

bool DepthPicture::covered(int x, int y) const {
  return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)] > nothing;
}

int DepthPicture::clamped(float v) const {
  return static_cast<int>(std::clamp(v, 0.0f, static_cast<float>(width_) - 1));
}

std::size_t DepthPicture::index(glm::vec3 seen) const {
  return static_cast<std::size_t>(clamped(seen.y)) * static_cast<std::size_t>(width_) +
         static_cast<std::size_t>(clamped(seen.x));
}

void DepthPicture::draw(const std::array<glm::vec3, 3>& t) {
  const auto add = [&](glm::vec3 p) { depth_[index(p)] = std::max(depth_[index(p)], p.z); };
  if (t[0] == t[1] && t[1] == t[2]) return;
  for (const glm::vec3& p : t) add(p);
  const float area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  if (area == 0) return;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
  for (int y = clamped(low); y <= clamped(high); ++y)
    for (int x = clamped(left); x <= clamped(right); ++x) {
      const glm::vec3 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0);
      const auto part = [&](const glm::vec3& a, const glm::vec3& b) {
        return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
      };
      const float w0 = part(t[1], t[2]), w1 = part(t[2], t[0]), w2 = part(t[0], t[1]);
      if (w0 >= 0 && w1 >= 0 && w2 >= 0) add({p.x, p.y, w0 * t[0].z + w1 * t[1].z + w2 * t[2].z});
    }
}

}  // namespace aomd::scene
