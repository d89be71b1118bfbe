#include "viewer/drawing/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace aomd::scene::camera_test {
namespace {

constexpr double aspect = 1.6;

Box box_of(glm::dvec3 low, glm::dvec3 high) {
  Box box;
  box.add(low);
  box.add(high);
  return box;
}

const Box unit = box_of({-1, -1, -1}, {1, 1, 1});

/// Where a point lands: x, y, z in -1..1.
glm::dvec3 project(const Camera& camera, const glm::dvec3& p, const Box& scene = unit) {
  const glm::dvec4 clip = camera.projection(aspect, scene) * camera.view() * glm::dvec4(p, 1);
  return glm::dvec3(clip) / clip.w;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

Camera facing(StandardView view, UpAxis up = UpAxis::Z) {
  Camera camera;
  camera.up_axis = up;
  camera.turn_to(view);
  return camera;
}

TEST(Camera, EachEndOfAnAxisHasItsStandardView) {
  EXPECT_EQ(view_from(0, true, UpAxis::Z), "right");
  EXPECT_EQ(view_from(0, false, UpAxis::Z), "left");
  EXPECT_EQ(view_from(1, false, UpAxis::Z), "front");
  EXPECT_EQ(view_from(2, true, UpAxis::Z), "top");
  EXPECT_EQ(view_from(1, true, UpAxis::Y), "top");
  EXPECT_EQ(view_from(2, true, UpAxis::Y), "front");
  EXPECT_EQ(view_from(2, false, UpAxis::Y), "back");
}

TEST(Camera, StandardViewsLookAlongTheAxes) {
  expect_near(facing(StandardView::Front).forward(), {0, 1, 0});
  expect_near(facing(StandardView::Back).forward(), {0, -1, 0});
  expect_near(facing(StandardView::Right).forward(), {-1, 0, 0});
  expect_near(facing(StandardView::Left).forward(), {1, 0, 0});
  expect_near(facing(StandardView::Top).forward(), {0, 0, -1});
  expect_near(facing(StandardView::Bottom).forward(), {0, 0, 1});
  expect_near(facing(StandardView::Iso).forward(), glm::normalize(glm::dvec3(-1, 1, -1)), 1e-7);
}

TEST(Camera, StandardViewsAreUpright) {
  expect_near(facing(StandardView::Front).right(), {1, 0, 0});
  expect_near(facing(StandardView::Front).up(), {0, 0, 1});
  expect_near(facing(StandardView::Top).right(), {1, 0, 0});
  expect_near(facing(StandardView::Top).up(), {0, 1, 0});
  EXPECT_GT(facing(StandardView::Iso).up().z, 0.5);
}

TEST(Camera, UpAxisY) {
  expect_near(facing(StandardView::Front, UpAxis::Y).forward(), {0, 0, -1});
  expect_near(facing(StandardView::Front, UpAxis::Y).up(), {0, 1, 0});
  expect_near(facing(StandardView::Right, UpAxis::Y).forward(), {-1, 0, 0});
  expect_near(facing(StandardView::Top, UpAxis::Y).forward(), {0, -1, 0});
}

TEST(Camera, OrbitDoesNotFlip) {
  Camera camera;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(-80, 80);
  for (int i = 0; i < 1000; ++i) {
    camera.orbit(step(random), step(random));
    EXPECT_GE(camera.up().z, -1e-12);
    EXPECT_LE(std::abs(camera.elevation_deg), 90);
    EXPECT_LE(std::abs(camera.azimuth_deg), 180);
    EXPECT_NEAR(glm::dot(camera.right(), camera.forward()), 0, 1e-12);
    EXPECT_NEAR(glm::length(camera.eye() - camera.target), camera.distance, 1e-9);
  }
}

TEST(Camera, TargetIsInTheMiddle) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    camera.target = {0.1, 0.2, 0.3};
    const glm::dvec3 p = project(camera, camera.target);
    EXPECT_NEAR(p.x, 0, 1e-12);
    EXPECT_NEAR(p.y, 0, 1e-12);
    EXPECT_NEAR(project(camera, camera.target + camera.up() * camera.half_height()).y, 1, 1e-9);
  }
}

TEST(Camera, PanMovesWhatIsUnderTheCursorWithIt) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    const glm::dvec3 p = camera.target + 0.2 * camera.right() + 0.1 * camera.up();
    const glm::dvec2 from(project(camera, p));
    camera.pan(from, {0.5, -0.3}, aspect);
    expect_near(glm::dvec3(glm::dvec2(project(camera, p)), 0), {0.5, -0.3, 0});
  }
}

TEST(Camera, ZoomKeepsWhatIsUnderTheCursor) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    const glm::dvec3 p = camera.target + 0.3 * camera.right() - 0.2 * camera.up();
    const glm::dvec2 before(project(camera, p));
    camera.zoom(0.5, before, aspect);
    expect_near(glm::dvec3(glm::dvec2(project(camera, p)), 0), glm::dvec3(before, 0));
    EXPECT_DOUBLE_EQ(camera.distance, 1.5);
  }
}

TEST(Camera, FitShowsEveryCornerAndFillsThePicture) {
  const Box boxes[] = {unit, box_of({5, 5, 5}, {5.001, 9, 5.5}), box_of({0, 0, 0}, {1000, 1, 1}),
                       box_of({0, 0, 0}, {1, 1, 0})};
  for (const Box& box : boxes) {
    for (const bool orthographic : {false, true}) {
      Camera camera;
      camera.orthographic = orthographic;
      camera.fit(box, aspect);
      double reach = 0;
      for (const glm::dvec3& corner : box.corners()) {
        const glm::dvec3 p = project(camera, corner, box);
        reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
        EXPECT_LT(std::abs(p.z), 1);
      }
      EXPECT_LT(reach, 1);
      EXPECT_GT(reach, 0.6);
    }
  }
}

TEST(Camera, FitComesNearerToRoundThings) {
  Box round = unit;
  round.set_radius(1);
  Camera camera;
  camera.fit(unit, aspect);
  const double far_away = camera.distance;
  camera.fit(round, aspect);
  EXPECT_LT(camera.distance, 0.8 * far_away);
  EXPECT_GT(camera.distance * std::sin(camera.fov_deg * 3.14159265 / 360), 1.0);
}

TEST(Camera, FitOfNothingOrAPointStaysUsable) {
  Camera camera;
  const Camera before = camera;
  camera.fit(Box(), aspect);
  EXPECT_EQ(camera, before);
  camera.fit(box_of({1, 2, 3}, {1, 2, 3}), aspect);
  expect_near(camera.target, {1, 2, 3});
  EXPECT_EQ(camera.distance, before.distance);
}

TEST(Camera, NearAndFarEncloseTheSceneFromEverywhere) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (int i = 0; i < 300; ++i) {
    Camera camera;
    camera.orthographic = i % 2 == 0;
    camera.distance = std::pow(10.0, exponent(random));
    camera.orbit(37.0 * i, 11.0 * i);
    for (const glm::dvec3& corner : unit.corners()) {
      const double depth = glm::dot(corner - camera.eye(), camera.forward());
      const double z = project(camera, corner).z;
      if (camera.orthographic || depth > 1e-2 * camera.distance + 1e-3) {
        EXPECT_GE(z, -1.0);
        EXPECT_LE(z, 1.0);
      }
    }
  }
}

TEST(Camera, RayGoesThroughWhatIsSeenThere) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    const glm::dvec3 p(0.3, -0.4, 0.2);
    const Ray ray = camera.ray(glm::dvec2(project(camera, p)), aspect, unit);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-12);
    EXPECT_LT(glm::length(glm::cross(p - ray.origin, ray.direction)), 1e-9);
    EXPECT_GT(glm::dot(p - ray.origin, ray.direction), 0);
  }
}

TEST(CameraText, ComesBackEqual) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-89, 89);
  for (int i = 0; i < 100; ++i) {
    Camera camera;
    camera.azimuth_deg = number(random);
    camera.elevation_deg = number(random);
    camera.distance = std::abs(number(random)) + 1e-9;
    camera.target = {number(random), number(random) * 1e-12, number(random) * 1e12};
    camera.orthographic = i % 2 == 0;
    camera.up_axis = i % 3 == 0 ? UpAxis::Y : UpAxis::Z;
    const CameraSpec spec = parse_camera(camera.to_text(), Camera(), unit, aspect);
    ASSERT_TRUE(spec.camera) << spec.error;
    EXPECT_EQ(*spec.camera, camera);
  }
}

TEST(CameraText, NamesFitTheScene) {
  for (const char* name : {"iso", "front", "back", "left", "right", "top", "bottom"}) {
    const CameraSpec spec = parse_camera(name, Camera(), unit, aspect);
    ASSERT_TRUE(spec.camera) << name;
    Camera expected;
    expected.turn_to(*standard_view(name));
    expected.fit(unit, aspect);
    EXPECT_EQ(*spec.camera, expected);
  }
}

TEST(CameraText, WordsApplyFromLeftToRight) {
  const CameraSpec spec =
      parse_camera("  front   zoom=2 orthographic azimuth=10 ", Camera(), unit, aspect);
  ASSERT_TRUE(spec.camera) << spec.error;
  Camera front;
  front.turn_to(StandardView::Front);
  front.fit(unit, aspect);
  EXPECT_DOUBLE_EQ(spec.camera->distance, 0.5 * front.distance);
  EXPECT_TRUE(spec.camera->orthographic);
  EXPECT_EQ(spec.camera->azimuth_deg, 10);
}

TEST(CameraText, NonsenseIsNamed) {
  for (const char* text :
       {"", "  ", "sideways", "azimuth", "azimuth=", "azimuth=x", "azimuth=1,2", "target=1,2",
        "target=1,2,3,4", "distance=0", "distance=-1", "fov=0", "fov=170", "zoom=0", "up=x",
        "azimuth=nan", "distance=inf", "front=1", "iso sideways"}) {
    const CameraSpec spec = parse_camera(text, Camera(), unit, aspect);
    EXPECT_FALSE(spec.camera) << text;
    EXPECT_FALSE(spec.error.empty()) << text;
  }
  EXPECT_NE(parse_camera("iso sideways", Camera(), unit, aspect).error.find("'sideways'"),
            std::string::npos);
}

}  // namespace
}  // namespace aomd::scene::camera_test
