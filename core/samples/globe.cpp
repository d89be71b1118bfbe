// A globe: six charts of a cube on a sphere, with a picture of land, sea and graticule.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/io/png.h"
#include "core/samples/makers.h"
#include "core/samples/numeric.h"

namespace aomd::sample {
namespace {

using std::numbers::pi;

constexpr int chart_columns = 3, chart_rows = 2, chart_pixels = 256;
constexpr double margin = 6.0 / chart_pixels;  ///< of a chart, on each side

/// The direction at a place -1..1 of a side of the cube; equal steps are nearly equal angles.
glm::dvec3 direction(int side, glm::dvec2 at) {
  const glm::dvec2 along = on_circle(at.x / 8), up = on_circle(at.y / 8);
  const double a = along.y / along.x, b = up.y / up.x;
  const std::array<glm::dvec3, 6> corners{
      {{1, a, b}, {-1, -a, b}, {-a, 1, b}, {a, -1, b}, {-b, a, 1}, {b, a, -1}}};
  return glm::normalize(corners[static_cast<std::size_t>(side)]);
}

/// Land and sea: a few waves around the globe.
glm::dvec3 ground(const glm::dvec3& p) {
  const auto wave = [](double x) { return on_circle(x / (2 * pi)).y; };
  const double relief = wave(3.1 * p.x + 2.0 * wave(2.3 * p.y)) +
                        0.8 * wave(4.3 * p.y + 1.7 * p.z) + 0.6 * wave(5.9 * p.z - 3.1 * p.x);
  const double ice = glm::smoothstep(0.86, 0.92, std::abs(p.z));
  const double land = glm::smoothstep(0.28, 0.40, relief);
  const glm::dvec3 sea(0.16, 0.38, 0.64), soil(0.53, 0.62, 0.33), snow(0.94, 0.96, 0.98);
  return glm::mix(glm::mix(sea, soil, land), snow, ice);
}

/// How much of a place a line of the graticule covers: each 15 degrees, as far as they are apart.
double graticule(const glm::dvec3& p) {
  constexpr double step = 15, half_width = 0.45;
  const double latitude = std::asin(std::clamp(p.z, -1.0, 1.0)) * 180 / pi;
  const double longitude = std::atan2(p.y, p.x) * 180 / pi;
  const double off_parallel = std::abs(std::remainder(latitude, step));
  const double off_meridian = std::abs(std::remainder(longitude, step)) * std::hypot(p.x, p.y);
  const bool near_pole = std::abs(latitude) > 90 - step / 2;
  const double off = near_pole ? off_parallel : std::min(off_parallel, off_meridian);
  return 0.75 * (1 - glm::smoothstep(half_width, 2 * half_width, off));
}

/// Where a place -1..1 of a side lies in the picture, counted upwards.
glm::dvec2 place_in_picture(int side, glm::dvec2 at) {
  const glm::dvec2 inside = margin + (1 - 2 * margin) * (0.5 * at + 0.5);
  const glm::dvec2 chart(side % chart_columns, side / chart_columns);
  return (chart + inside) / glm::dvec2(chart_columns, chart_rows);
}

io::Image picture() {
  io::Image image(chart_columns * chart_pixels, chart_rows * chart_pixels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int up = image.height - 1 - y;
      const int side = x / chart_pixels + chart_columns * (up / chart_pixels);
      const glm::dvec2 inside =
          (glm::dvec2(x % chart_pixels, up % chart_pixels) + 0.5) / double{chart_pixels};
      const glm::dvec3 p = direction(side, 2.0 * (inside - margin) / (1 - 2 * margin) - 1.0);
      const glm::dvec3 shade = glm::mix(ground(p), glm::dvec3(0.13, 0.15, 0.2), graticule(p));
      for (int k = 0; k < 3; ++k)
        image.pixel(x, y)[k] = static_cast<std::uint8_t>(std::lround(255 * shade[k]));
      image.pixel(x, y)[3] = 255;
    }
  return image;
}

/// Vertices on the edges of the cube are shared, their places in the picture are not.
class Globe {
 public:
  explicit Globe(int cells) : cells_(cells) {
    uv_ = {"uv", 2, 2, false, {}};
    uv_.meaning = Meaning::Texture;
  }

  MeshData make() {
    for (int side = 0; side < 6; ++side)
      for (int j = 0; j < cells_; ++j)
        for (int i = 0; i < cells_; ++i) add_cell(side, i, j);
    mesh_.corners = {std::move(uv_)};
    mesh_.attributes = {colours(), label()};
    mesh_.appearance.materials = {{.name = "globe", .picture = 0}};
    mesh_.appearance.pictures = {{"globe.png", io::to_png(picture())}};
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] glm::dvec2 at(int i, int j) const {
    return {2.0 * i / cells_ - 1, 2.0 * j / cells_ - 1};
  }

  void add_cell(int side, int i, int j) {
    using Corner = std::array<int, 2>;
    const Corner a{i, j}, b{i + 1, j}, c{i + 1, j + 1}, d{i, j + 1};
    for (const auto& face : {std::array{a, b, c}, std::array{a, c, d}}) {
      mesh_.faces.add(Shape::Triangle,
                      {vertex(side, face[0]), vertex(side, face[1]), vertex(side, face[2])});
      for (const Corner& corner : face) {
        const glm::dvec2 place = place_in_picture(side, at(corner[0], corner[1]));
        uv_.values.insert(uv_.values.end(), {place.x, place.y});
      }
    }
  }

  std::uint32_t vertex(int side, const std::array<int, 2>& corner) {
    const glm::dvec3 p = direction(side, at(corner[0], corner[1]));
    const auto key = [](double x) { return std::lround(1e9 * x); };
    const auto [known, fresh] = vertices_.try_emplace(
        {key(p.x), key(p.y), key(p.z)}, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (fresh) mesh_.positions.push_back(p);
    return known->second;
  }

  [[nodiscard]] Attribute colours() const {
    Attribute colour{"color", 0, 3, true, {}, NumberType::UInt8, Meaning::Colour};
    for (const glm::dvec3& p : mesh_.positions) {
      const glm::dvec3 shade = ground(p);
      for (int k = 0; k < 3; ++k) colour.values.push_back(std::round(255 * shade[k]));
    }
    return colour;
  }

  [[nodiscard]] Attribute label() const {
    Attribute material{"material", 2, 1, true, std::vector<double>(mesh_.faces.size(), 0)};
    material.names = {"globe"};
    return material;
  }

  int cells_;
  MeshData mesh_;
  Attribute uv_;
  std::map<std::tuple<long, long, long>, std::uint32_t> vertices_;
};

}  // namespace

MeshData make_globe(int cells) { return Globe(cells).make(); }

}  // namespace aomd::sample
