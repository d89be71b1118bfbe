#include "tests/support/painted_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aomd::test {
namespace {

constexpr int samples = 4;  // a pixel has so many across and down
using Color = glm::dvec3;

struct Segment {
  glm::dvec2 a, b;
  double width;
  Color color;
};

double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Each sample of a pixel lies in a row and a column of its own, as in multisampling.
glm::dvec2 place_of(int x, int y) {
  const auto within = [](int other) { return (other % samples + 0.5) / samples; };
  return {(x + within(y)) / samples, (y + within(x)) / samples};
}

double distance_to(const Segment& s, glm::dvec2 p) {
  const glm::dvec2 along = s.b - s.a;
  const double t = std::clamp(glm::dot(p - s.a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(p - s.a - t * along);
}

/// The body's faces toward the eye and their edges, in pixels.
class Painter {
 public:
  explicit Painter(const PaintedScene& scene)
      : scene_(scene),
        columns_(2 * scene.rows),
        sums_(static_cast<std::size_t>(scene.width * samples) *
              static_cast<std::size_t>(scene.height * samples)) {
    for (int y = 0; y < scene.height * samples; ++y)
      for (int x = 0; x < scene.width * samples; ++x) at(x, y) = background(y);
    for (int row = 0; row < scene.rows; ++row)
      for (int column = 0; column < columns_; ++column) paint_face(row, column);
    int edge = 0;
    for (int row = 0; row < scene.rows; ++row)
      for (int column = 0; column < columns_; ++column) {
        paint_edge(edge++, row, column, row, column + 1);
        paint_edge(edge++, row, column, row + 1, column);
      }
    if (scene.axes) paint_axes();
  }

  [[nodiscard]] io::Image picture() {
    io::Image image(scene_.width, scene_.height);
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x) {
        Color sum{};
        for (int v = 0; v < samples; ++v)
          for (int u = 0; u < samples; ++u) sum += at(x * samples + u, y * samples + v);
        for (int c = 0; c < 3; ++c)
          image.pixel(x, y)[c] = static_cast<std::uint8_t>(
              std::lround(std::clamp(sum[c] / (samples * samples), 0.0, 255.0)));
        image.pixel(x, y)[3] = 255;
      }
    return image;
  }

 private:
  [[nodiscard]] Color& at(int x, int y) {
    return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene_.width * samples) +
                 static_cast<std::size_t>(x)];
  }
  [[nodiscard]] Color background(int y) const {
    const double t = static_cast<double>(y) / (scene_.height * samples);
    return scene_.dark ? Color(30 + 20 * t) : Color(250 - 30 * t);
  }
  /// On an ellipsoid that is turned, seen from the front.
  [[nodiscard]] glm::dvec3 vertex(int row, int column) const {
    const double polar = std::numbers::pi * row / scene_.rows;
    const double around = 2 * std::numbers::pi * column / columns_;
    const double turn = (20 + scene_.turned_deg) * std::numbers::pi / 180;
    const glm::dvec3 p(std::sin(polar) * std::cos(around), 0.8 * std::cos(polar),
                       0.6 * std::sin(polar) * std::sin(around));
    return {p.x * std::cos(turn) - p.z * std::sin(turn), p.y,
            p.x * std::sin(turn) + p.z * std::cos(turn)};
  }
  [[nodiscard]] glm::dvec2 on_screen(glm::dvec3 p) const {
    const double scale = 0.55 * scene_.height;
    return {0.5 * scene_.width + scale * p.x + scene_.shifted_px,
            0.5 * scene_.height - scale * p.y + scene_.shifted_px};
  }
  template <typename Visit>
  void for_samples_in(glm::dvec2 low, glm::dvec2 high, Visit&& visit) {
    const auto index = [](double px, int most) {
      return std::clamp(static_cast<int>(std::floor(px * samples)), 0, most * samples - 1);
    };
    for (int y = index(low.y, scene_.height); y <= index(high.y, scene_.height); ++y)
      for (int x = index(low.x, scene_.width); x <= index(high.x, scene_.width); ++x)
        visit(x, y, place_of(x, y));
  }
  void paint_face(int row, int column) {
    const glm::dvec3 a = vertex(row, column), b = vertex(row, column + 1),
                     c = vertex(row + 1, column + 1), d = vertex(row + 1, column);
    paint_triangle(a, d, c, row * columns_ + column);
    paint_triangle(a, c, b, row * columns_ + column);
  }
  void paint_triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, int face) {
    const glm::dvec3 normal = glm::cross(c - a, b - a);
    if (glm::length(normal) < 1e-12 || !(normal.z > 0)) return;
    const double light =
        0.35 + 0.65 * std::max(0.0, glm::dot(glm::normalize(normal),
                                             glm::normalize(glm::dvec3(0.4, 0.6, 0.7))));
    Color color = light * Color(150, 175, 210) + Color(scene_.brighter);
    if (face == scene_.selected_face) color = Color(255, 170, 40);
    const glm::dvec2 p = on_screen(a), q = on_screen(b), r = on_screen(c);
    for_samples_in(glm::min(glm::min(p, q), r), glm::max(glm::max(p, q), r),
                   [&](int x, int y, glm::dvec2 s) {
                     const double u = side_of(p, q, s), v = side_of(q, r, s), w = side_of(r, p, s);
                     if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
                       at(x, y) = color;
                   });
  }
  void paint_edge(int edge, int row, int column, int end_row, int end_column) {
    const glm::dvec3 a = vertex(row, column), b = vertex(end_row, end_column);
    if (glm::length(b - a) < 1e-9 || a.z + b.z <= 0) return;
    const bool moved = edge == scene_.moved_edge;
    if (moved && scene_.moved_px >= 1000) return;
    const glm::dvec2 by(0, moved ? -scene_.moved_px : 0);
    paint_segment({on_screen(a) + by, on_screen(b) + by, scene_.edge_px, Color(40, 50, 70)});
  }
  void paint_segment(const Segment& s) {
    const glm::dvec2 margin(s.width);
    for_samples_in(glm::min(s.a, s.b) - margin, glm::max(s.a, s.b) + margin,
                   [&](int x, int y, glm::dvec2 p) {
                     if (distance_to(s, p) <= s.width / 2) at(x, y) = s.color;
                   });
  }
  void paint_axes() {
    const glm::dvec2 o(12, scene_.height - 12);
    paint_segment({o, o + glm::dvec2(16, 0), 1.5, {210, 60, 60}});
    paint_segment({o, o - glm::dvec2(0, 16), 1.5, {60, 160, 60}});
    paint_segment({o, o + glm::dvec2(9, -9), 1.5, {70, 90, 220}});
  }

  const PaintedScene& scene_;
  int columns_;
  std::vector<Color> sums_;
};

}  // namespace

io::Image paint(const PaintedScene& scene) { return Painter(scene).picture(); }

}  // namespace aomd::test
