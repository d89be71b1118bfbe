// What makes shape read: fewer faces that look alike, darker folds, a floor, dots that give way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "core/samples/samples.h"
#include "tests/support/session_helpers.h"
#include "viewer/drawing/coarse_surface.h"
#include "viewer/drawing/crowding.h"
#include "viewer/drawing/ground.h"
#include "viewer/drawing/hollows.h"
#include "viewer/drawing/openness.h"

namespace aomd::scene::shape_test {
namespace {

using test::drive;

glm::vec3 normal_of(std::span<const Corner> t) {
  return glm::cross(t[1].position - t[0].position, t[2].position - t[0].position);
}

TEST(CoarseSurface, HasAboutAsManyFacesAsWantedAndTheSameShape) {
  Session s;
  drive(s, {"sample sphere 90"});
  const auto corners = s.sheet().drawing().drawable().corners.values();
  const std::size_t wanted = corners.size() / 3 / 8;
  const std::vector<Corner> coarse = coarse_corners(corners, wanted);
  EXPECT_GT(coarse.size() / 3, wanted / 2);
  EXPECT_LT(coarse.size() / 3, 2 * wanted);
  const auto radius = static_cast<float>(s.document().content().bounds.radius());
  std::size_t folded = 0;
  for (std::size_t i = 0; i < coarse.size(); i += 3) {
    const std::span<const Corner> face(&coarse[i], 3);
    EXPECT_EQ(face[0].flags & 7u, 7u) << "its edges are none of the mesh";
    for (const Corner& corner : face)
      EXPECT_NEAR(glm::length(corner.position), radius, 0.05f * radius);
    if ((face[0].flags & CornerFlag::without_back) != 0)
      ++folded;
    else
      EXPECT_GT(glm::dot(normal_of(face), unpack_normal(face[0].normal)), 0) << "it looks outward";
  }
  EXPECT_LT(folded, coarse.size() / 3 / 20);
}

TEST(CoarseSurface, SidesThatFallTogetherHaveNoBack) {
  std::vector<Corner> corners;
  const auto quad = [&](float z, bool up) {
    constexpr int n = 40;
    const std::uint32_t normal = pack_normal({0, 0, up ? 1.0f : -1.0f});
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const auto at = [&](int dx, int dy) {
          return Corner{{float(x + dx), float(y + dy), z}, normal, 0xffffffffu, 0};
        };
        const std::array<Corner, 6> two = {at(0, 0), at(1, 0), at(1, 1),
                                           at(0, 0), at(1, 1), at(0, 1)};
        corners.insert(corners.end(), two.begin(), two.end());
        if (!up) std::reverse(corners.end() - 6, corners.end());
      }
  };
  quad(0.01f, true);
  quad(0, false);
  const std::vector<Corner> coarse = coarse_corners(corners, 400);
  ASSERT_GT(coarse.size(), 100u);
  for (const Corner& corner : coarse) EXPECT_NE(corner.flags & CornerFlag::without_back, 0u);
}

TEST(CoarseSurface, IsEmptyWhereNothingIs) {
  EXPECT_TRUE(coarse_corners({}, 100).empty());
  const std::vector<Corner> dead(30);
  EXPECT_TRUE(coarse_corners(dead, 100).empty());
}

std::vector<std::uint8_t> openness_of(Session& s) {
  const Drawable& drawable = s.sheet().drawing().drawable();
  return openness(openness_source(s.document().mesh(), drawable.corners.values(), drawable.origin),
                  {});
}

TEST(Openness, IsFullOnWhatBulgesOut) {
  Session s;
  drive(s, {"sample sphere 24"});
  for (const std::uint8_t each : openness_of(s)) EXPECT_GT(each, 235);
}

TEST(Openness, IsLessInTheHoleOfATorusThanOutside) {
  Session s;
  drive(s, {"sample torus 24"});
  const Mesh& mesh = s.document().mesh();
  const std::vector<std::uint8_t> open = openness_of(s);
  ASSERT_EQ(open.size(), mesh.capacity(0));
  double innermost = 1e9, outermost = 0;
  std::uint8_t in = 0, out = 0;
  for (const Vertex v : mesh.vertices()) {
    const double r =
        glm::length(glm::dvec2(mesh.position(v) - s.document().content().bounds.center()));
    if (r < innermost) innermost = r, in = open[v.index];
    if (r > outermost) outermost = r, out = open[v.index];
  }
  EXPECT_GT(out, 240);
  EXPECT_LT(in, out - 30);
}

/// A flat plate of 2 by 2, with a groove or a ridge of this height along y.
MeshData grooved_plate(double height) {
  constexpr std::uint32_t n = 80;
  MeshData mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const double u = 2.0 * x / n - 1;
      mesh.positions.emplace_back(u, 2.0 * y / n - 1, height * std::exp(-u * u / 0.002));
    }
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t at = y * (n + 1) + x;
      mesh.faces.add(Shape::Triangle, {at, at + 1, at + n + 2});
      mesh.faces.add(Shape::Triangle, {at, at + n + 2, at + n + 1});
    }
  return mesh;
}

std::vector<float> hollows_of(const MeshData& mesh) {
  Session s;
  s.show(make_loaded(mesh, "plate"));
  const OpennessSource source = openness_source(s.document().mesh(), {}, glm::dvec3(0));
  return hollows(source.positions, source.normals, source.lengths, source.faces, 2.8f);
}

TEST(Hollows, AreWhereASurfaceBendsTowardsItsNormalAndNowhereElse) {
  constexpr std::size_t middle = 40 * 81 + 40, aside = 40 * 81 + 10;
  const std::vector<float> groove = hollows_of(grooved_plate(-0.02));
  EXPECT_GT(groove[middle], 0.1f);
  EXPECT_EQ(groove[aside], 0);
  const std::vector<float> ridge = hollows_of(grooved_plate(0.02));
  EXPECT_EQ(ridge[middle], 0);
  EXPECT_GT(ridge[middle + 2], 0.005f) << "at its foot";
}

TEST(Openness, StopsWhenItIsAskedTo) {
  Session s;
  drive(s, {"sample sphere 8"});
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(openness({{{1, 0, 0}}, {{1, 0, 0}}, {1}, {}}, stop.get_token()).empty());
}

std::size_t dim_corners(const Session& s) {
  const auto corners = s.sheet().drawing().drawable().corners.values();
  return static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(),
                    [](const Corner& c) { return c.flags != 0 || c.color >> 24 != 255; }));
}

TEST(Occlusion, IsThereWhileItIsShownAndFollowsTheMesh) {
  Session s;
  drive(s, {"sample torus 40"});
  EXPECT_EQ(dim_corners(s), 0u);
  drive(s, {"show occlusion on"});
  EXPECT_TRUE(s.idle());
  const std::size_t before = dim_corners(s);
  EXPECT_GT(before, 60u);
  drive(s, {"run"});
  EXPECT_GT(dim_corners(s), 20u);
  EXPECT_LT(dim_corners(s), before);
  drive(s, {"color quality"});
  EXPECT_GT(dim_corners(s), 20u);
  drive(s, {"show occlusion off"});
  EXPECT_EQ(dim_corners(s), 0u);
}

TEST(Rooms, AreTheDistancesToTheNearest) {
  const std::vector<glm::vec3> places = {{0, 0, 0}, {0.3f, 0, 0}, {0.3f, 0.4f, 0}, {9, 9, 9}};
  const std::vector<float> found = rooms(places, 1);
  EXPECT_FLOAT_EQ(found[0], 0.3f);
  EXPECT_FLOAT_EQ(found[1], 0.3f);
  EXPECT_FLOAT_EQ(found[2], 0.4f);
  EXPECT_EQ(found[3], 0) << "nothing is near";
  EXPECT_EQ(rooms(places, 0), std::vector<float>(4, 0));
  EXPECT_GT(rooms(std::vector<glm::vec3>(100), 1)[99], 0) << "it is crowded there";
}

TEST(Ground, LiesBelowTheMeshAndIsDarkestUnderIt) {
  Session s;
  drive(s, {"sample sphere 16", "show ground on"});
  const Drawable& drawable = s.sheet().drawing().drawable();
  const Box& bounds = s.document().content().bounds;
  ASSERT_GT(drawable.ground.lines.size(), 10u);
  ASSERT_GT(drawable.ground.faces.size(), 100u);
  for (const Segment& line : drawable.ground.lines.values())
    EXPECT_NEAR(line.a.z + drawable.origin.z, bounds.low.z, 1e-5);
  const auto faces = drawable.ground.faces.values();
  const auto alpha = [](const Corner& c) { return c.color >> 24; };
  const auto darkest = std::max_element(faces.begin(), faces.end(),
                                        [&](auto& a, auto& b) { return alpha(a) < alpha(b); });
  EXPECT_GT(alpha(*darkest), 90u);
  EXPECT_LT(glm::length(glm::vec2(darkest->position)), 0.8f * bounds.radius());
  EXPECT_GT(drawable.ground_bounds.high.x, bounds.high.x);
  drive(s, {"show ground off"});
  EXPECT_TRUE(drawable.ground.lines.empty() && drawable.ground.faces.empty());
}

TEST(Light, StaysOrFollows) {
  Session s;
  drive(s, {"sample sphere 8", "camera front", "light stay", "camera left"});
  ASSERT_TRUE(s.view.light_from);
  EXPECT_EQ(s.view.light_from->azimuth_deg, 0);
  drive(s, {"light toggle"});
  EXPECT_FALSE(s.view.light_from);
  drive(s, {"light toggle", "light follow"});
  EXPECT_FALSE(s.view.light_from);
}

TEST(SteppedScale, HasOneColourAFaceAndNoneInBetween) {
  Session s;
  drive(s, {"sample torus 12", "color curvature", "scale steps 4"});
  const auto corners = s.sheet().drawing().drawable().corners.values();
  std::set<Color> colors;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    EXPECT_EQ(corners[i].color, corners[i + 1].color);
    EXPECT_EQ(corners[i].color, corners[i + 2].color);
    colors.insert(corners[i].color);
  }
  EXPECT_LE(colors.size(), 5u);
  EXPECT_GT(colors.size(), 1u);
}

}  // namespace
}  // namespace aomd::scene::shape_test
