#include "tests/support/painted_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

/// Where a sample lies: each of a pixel has a row and a column of its own, as in multisampling.
double along(int at, int across) { return (at + (across % samples + 0.5) / samples) / samples; }

/// How far a place lies to the left of the line through two others, times their distance. Affine,
/// so that it can be asked of many places at once.
struct Side {
  double x, y, constant;
  Side(glm::dvec2 a, glm::dvec2 b) : x(a.y - b.y), y(b.x - a.x), constant(-(x * a.x + y * a.y)) {}
  [[nodiscard]] double of(double px, double py) const { return x * px + y * py + constant; }
};

double squared_distance(const Segment& s, double px, double py) {
  const double ax = s.b.x - s.a.x, ay = s.b.y - s.a.y;
  const double t =
      std::clamp(((px - s.a.x) * ax + (py - s.a.y) * ay) / (ax * ax + ay * ay), 0.0, 1.0);
  const double dx = px - s.a.x - t * ax, dy = py - s.a.y - t * ay;
  return dx * dx + dy * dy;
}

/// The body's faces toward the eye and their edges, in pixels. A sample holds the number of its
/// colour: so many samples are painted that their size is what painting costs.
class Painter {
 public:
  explicit Painter(const PaintedScene& scene)
      : scene_(scene),
        columns_(2 * scene.rows),
        painted_(static_cast<std::size_t>(scene.width * samples) *
                 static_cast<std::size_t>(scene.height * samples)) {
    for (int y = 0; y < scene.height * samples; ++y) {
      const Number number = number_of(background(y));
      std::fill_n(line(y), scene.width * samples, number);
    }
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
          for (int u = 0; u < samples; ++u) sum += colors_[line(y * samples + v)[x * samples + u]];
        for (int c = 0; c < 3; ++c)
          image.pixel(x, y)[c] = static_cast<std::uint8_t>(
              std::lround(std::clamp(sum[c] / (samples * samples), 0.0, 255.0)));
        image.pixel(x, y)[3] = 255;
      }
    return image;
  }

 private:
  using Number = std::uint16_t;
  [[nodiscard]] Number number_of(const Color& color) {
    colors_.push_back(color);
    return static_cast<Number>(colors_.size() - 1);
  }
  [[nodiscard]] Number* line(int y) {
    return painted_.data() +
           static_cast<std::size_t>(y) * static_cast<std::size_t>(scene_.width * samples);
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
  /// The samples that a box from `low` to `high` touches: columns and rows.
  struct Samples {
    int left, right, top, bottom;
  };
  [[nodiscard]] Samples samples_in(glm::dvec2 low, glm::dvec2 high) const {
    const auto index = [](double px, int most) {
      return std::clamp(static_cast<int>(std::floor(px * samples)), 0, most * samples - 1);
    };
    return {index(low.x, scene_.width), index(high.x, scene_.width), index(low.y, scene_.height),
            index(high.y, scene_.height)};
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
    const Side first(p, q), second(q, r), third(r, p);
    const Number number = number_of(color);
    const Samples in = samples_in(glm::min(glm::min(p, q), r), glm::max(glm::max(p, q), r));
    for (int y = in.top; y <= in.bottom; ++y)
      for (int x = in.left; x <= in.right; ++x) {
        const double px = along(x, y), py = along(y, x);
        const double u = first.of(px, py), v = second.of(px, py), w = third.of(px, py);
        if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) line(y)[x] = number;
      }
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
    const Samples in = samples_in(glm::min(s.a, s.b) - margin, glm::max(s.a, s.b) + margin);
    const Number number = number_of(s.color);
    const double most = s.width * s.width / 4;
    for (int y = in.top; y <= in.bottom; ++y)
      for (int x = in.left; x <= in.right; ++x)
        if (squared_distance(s, along(x, y), along(y, x)) <= most) line(y)[x] = number;
  }
  void paint_axes() {
    const glm::dvec2 o(12, scene_.height - 12);
    paint_segment({o, o + glm::dvec2(16, 0), 1.5, {210, 60, 60}});
    paint_segment({o, o - glm::dvec2(0, 16), 1.5, {60, 160, 60}});
    paint_segment({o, o + glm::dvec2(9, -9), 1.5, {70, 90, 220}});
  }

  const PaintedScene& scene_;
  int columns_;
  std::vector<Color> colors_;
  std::vector<Number> painted_;
};

}  // namespace

io::Image paint(const PaintedScene& scene) { return Painter(scene).picture(); }

}  // namespace aomd::test
