#include "viewer/drawing/ground.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "viewer/drawing/coarse_surface.h"
#include "viewer/drawing/depth_picture.h"

namespace aomd::scene {
namespace {

constexpr int shadow_px = 96;
constexpr int blur_px = 4;
constexpr std::size_t most_faces = 60'000;
constexpr float darkness = 0.42f;
constexpr float shadow_radii = 1.35f, grid_radii = 1.6f;  // of the mesh
constexpr Color line_color = 0x60808080u;                 // seen on light and dark

int axis_of(UpAxis up) { return up == UpAxis::Z ? 2 : 1; }

double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double each : {5.0, 2.0})
    if (each * power <= most) return each * power;
  return power;
}

using Shades = std::vector<float>;  // by pixel

/// The mean over a square, by rows and then by columns.
Shades blurred(const Shades& from, std::size_t step, std::size_t across) {
  Shades to(from.size());
  for (int line = 0; line < shadow_px; ++line)
    for (int at = 0; at < shadow_px; ++at) {
      float sum = 0;
      for (int k = std::max(0, at - blur_px); k <= std::min(shadow_px - 1, at + blur_px); ++k)
        sum += from[static_cast<std::size_t>(line) * across + static_cast<std::size_t>(k) * step];
      to[static_cast<std::size_t>(line) * across + static_cast<std::size_t>(at) * step] =
          sum / (2 * blur_px + 1);
    }
  return to;
}

/// How much of the sky above each place is covered.
Shades shades_of(const DepthPicture& from_above) {
  Shades shades(std::size_t{shadow_px} * shadow_px);
  for (int y = 0; y < shadow_px; ++y)
    for (int x = 0; x < shadow_px; ++x)
      shades[static_cast<std::size_t>(y) * shadow_px + static_cast<std::size_t>(x)] =
          from_above.covered(x, y) ? 1.0f : 0.0f;
  for (int times = 0; times < 2; ++times)
    shades = blurred(blurred(shades, 1, shadow_px), shadow_px, 1);
  return shades;
}

/// Two triangles for each four pixels of which one is dark.
std::vector<Corner> shadow(const DepthPicture& from_above, const Shades& shades, float height) {
  std::vector<Corner> corners;
  const auto corner = [&](int x, int y) {
    const float shade =
        shades[static_cast<std::size_t>(y) * shadow_px + static_cast<std::size_t>(x)];
    const glm::vec3 seen(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, height);
    return Corner{from_above.place(seen), 0, pack_color({0.03f, 0.04f, 0.06f, darkness * shade}),
                  0};
  };
  for (int y = 0; y + 1 < shadow_px; ++y)
    for (int x = 0; x + 1 < shadow_px; ++x) {
      const Corner a = corner(x, y), b = corner(x + 1, y), c = corner(x + 1, y + 1),
                   d = corner(x, y + 1);
      if (((a.color | b.color | c.color | d.color) >> 24) != 0)
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  return corners;
}

std::vector<Segment> grid(const Box& bounds, const glm::dvec3& origin, int up, double height) {
  const double reach = grid_radii * bounds.radius(), width = round_length(0.25 * bounds.radius());
  const int u = (up + 1) % 3, v = (up + 2) % 3;
  const glm::dvec3 center = bounds.center();
  std::vector<Segment> lines;
  for (const bool along_u : {true, false}) {
    const int along = along_u ? u : v, across = along_u ? v : u;
    const auto end = [&](double at, double side) {
      glm::dvec3 p(0);
      p[up] = height;
      p[along] = at;
      p[across] = side;
      return glm::vec3(p - origin);
    };
    const double first = std::ceil((center[along] - reach) / width);
    for (int i = 0; (first + i) * width <= center[along] + reach; ++i)
      lines.push_back({end((first + i) * width, center[across] - reach),
                       end((first + i) * width, center[across] + reach), line_color, 1});
  }
  return lines;
}

}  // namespace

double ground_height(const Box& bounds, UpAxis up) { return bounds.low[axis_of(up)]; }

Box draw_ground(const Drawable& drawable, UpAxis up, Overlay& ground) {
  ground.clear();
  Box box = drawable.bounds;
  if (!(box.diagonal() > 0)) return box;
  const int axis = axis_of(up);
  const double height = ground_height(drawable.bounds, up);
  glm::vec3 above(0);
  above[axis] = 1;
  const auto corners = drawable.corners.values();
  const auto radius = static_cast<float>(box.radius());
  DepthPicture from_above(above, shadow_radii * radius, shadow_px);
  if (corners.size() > 6 * most_faces)
    from_above.draw(coarse_corners(corners, most_faces));
  else
    from_above.draw(corners);
  ground.faces.assign(shadow(from_above, shades_of(from_above),
                             static_cast<float>(height - drawable.origin[axis])));
  ground.lines.assign(grid(drawable.bounds, drawable.origin, axis, height));
  for (int k = 0; k < 3; ++k)
    if (k != axis)
      for (const double side : {-1.0, 1.0}) {
        glm::dvec3 p = drawable.bounds.center();
        p[k] += side * grid_radii * drawable.bounds.radius();
        box.add(p);
      }
  return box;
}

}  // namespace aomd::scene
