// Rays, and what lies under a place of the picture.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/samples/samples.h"
#include "tests/support/zoo.h"
#include "viewer/document/loaded_mesh.h"
#include "viewer/drawing/picking.h"

namespace aomd::scene::picking_test {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

TEST(Ray, MeetsATriangleFromEitherSideAndItsRims) {
  const Triangle t{glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(distance_along({0.25, 0.25, 2}, {0, 0, -1}, t), 2);
  EXPECT_EQ(distance_along({0.25, 0.25, -2}, {0, 0, 1}, t), 2);
  EXPECT_EQ(distance_along({0.5, 0.5, 2}, {0, 0, -1}, t), 2);
  EXPECT_EQ(distance_along({0, 0, 2}, {0, 0, -1}, t), 2);
  EXPECT_EQ(distance_along({0.6, 0.6, 2}, {0, 0, -1}, t), nowhere);
  EXPECT_EQ(distance_along({0.25, 0.25, 2}, {0, 0, 1}, t), nowhere) << "behind";
  EXPECT_EQ(distance_along({-1, 0.25, 0}, {1, 0, 0}, t), nowhere) << "within its plane";
}

TEST(Ray, TheTreeFindsWhatLookingAtEachTriangleFinds) {
  const Mesh mesh(make_sample("torus", 24));
  const Triangles all = triangles_of(mesh);
  const TriangleTree tree(all.corners);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const double u = 0.37 * i, w = 0.11 * i;
    const glm::dvec3 origin(9 * std::cos(u), 9 * std::sin(u), 6 * std::sin(w));
    const glm::dvec3 direction =
        glm::dvec3(std::sin(3 * u), std::cos(2 * w), std::sin(w + u)) - origin;
    double nearest = nowhere;
    for (const Triangle& t : all.corners)
      nearest = std::min(nearest, distance_along(origin, direction, t));
    const auto found = tree.first_along(origin, direction, [](std::uint32_t) { return true; });
    EXPECT_EQ(found.distance, nearest) << i;
    hits += nearest < nowhere;
    const auto second =
        tree.first_along(origin, direction, [&](std::uint32_t n) { return n != found.triangle; });
    EXPECT_TRUE(second.distance >= nearest);
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(hits, 400);
}

/// The grid of 3 x 3 squares seen from above, 600 x 600 pixels.
struct Scene {
  explicit Scene(const MeshData& data) : loaded(make_loaded(data, "test")) {
    view.aspect = 1;
    view.height_px = 600;
    view.camera.orthographic = true;
    view.camera.turn_to(StandardView::Top);
    view.camera.fit(loaded->bounds, view.aspect);
    if (loaded->skin) skin.emplace(make_skin_surface(loaded->mesh, *loaded->skin, {}));
  }
  Shown shown() const {
    return {skin ? skin->mesh : loaded->mesh, loaded->mesh, skin ? &*skin : nullptr,
            loaded->bounds};
  }
  glm::dvec2 ndc(const glm::dvec3& p) const {
    const Projector project(view, loaded->bounds);
    return project.ndc(project(p));
  }
  EntityRef at(const glm::dvec3& p) { return picker.at(shown(), view, ndc(p)); }
  std::vector<EntityRef> within(const glm::dvec3& a, const glm::dvec3& b) {
    return picker.within(shown(), view, ndc(a), ndc(b));
  }
  std::unique_ptr<LoadedMesh> loaded;
  std::optional<SkinSurface> skin;
  View view;
  Picker picker;
};

TEST(Picking, TheNearestVertexOrEdgeWinsElseTheFace) {
  Scene s(zoo::grid(3));
  const Mesh& mesh = s.loaded->mesh;
  EXPECT_EQ(s.at({1.02, 1.01, 0}), EntityRef(Vertex(5)));
  EXPECT_EQ(s.at({1.5, 1.01, 0}), EntityRef(mesh.find_edge(Vertex(5), Vertex(6))));
  EXPECT_EQ(s.at({1.5, 1.52, 0}), EntityRef(mesh.find_edge(Vertex(5), Vertex(10))));
  EXPECT_EQ(s.at({1.7, 1.3, 0}), EntityRef(Face(8)));  // the fifth square's lower triangle
  EXPECT_EQ(s.at({3.4, 1.5, 0}), EntityRef());
  EXPECT_EQ(s.at({3.02, 2.5, 0}), EntityRef(mesh.find_edge(Vertex(11), Vertex(15))))
      << "just beside";
}

TEST(Picking, ALevelTakesNothingElse) {
  Scene s(zoo::grid(3));
  const glm::dvec3 p(1.7, 1.3, 0);
  s.view.pick_level = PickLevel::Vertex;
  EXPECT_EQ(s.at(p), EntityRef(Vertex(6)));
  s.view.pick_level = PickLevel::Edge;
  EXPECT_EQ(s.at(p), EntityRef(s.loaded->mesh.find_edge(Vertex(5), Vertex(10))));
  s.view.pick_level = PickLevel::Face;
  EXPECT_EQ(s.at({1.01, 1.005, 0}), EntityRef(Face(8)));
  s.view.pick_level = PickLevel::Region;
  EXPECT_EQ(s.at(p), EntityRef());
}

TEST(Picking, HiddenClassesAreLookedThrough) {
  MeshData two = zoo::square();
  for (const glm::dvec3& p : {glm::dvec3(0, 0, -1), {1, 0, -1}, {1, 1, -1}})
    two.positions.push_back(p);
  two.faces.add(Shape::Triangle, {4, 5, 6}, ModelRef(2, 2));
  two.faces.classes[0] = two.faces.classes[1] = ModelRef(2, 1);
  Scene s(two);
  s.view.pick_level = PickLevel::Face;
  EXPECT_EQ(s.at({0.7, 0.3, 0}), EntityRef(Face(0)));
  s.view.hidden.insert(ModelRef(2, 1));
  EXPECT_EQ(s.at({0.7, 0.3, 0}), EntityRef(Face(2)));
}

TEST(Picking, WhatIsClippedAwayIsLookedThrough) {
  Scene s(zoo::grid(3));
  s.view.clip = Clip{0, 0.5};
  EXPECT_EQ(s.at({1.3, 1.1, 0}), EntityRef(Face(8)));
  EXPECT_EQ(s.at({1.7, 1.3, 0}), EntityRef()) << "the other part of the same face";
  EXPECT_EQ(s.within({-1, -1, 0}, {4, 4, 0}).size(), 6u) << "whole ones only";
  s.view.clip->flip = true;
  EXPECT_EQ(s.at({1.3, 1.1, 0}), EntityRef());
  EXPECT_EQ(s.at({1.7, 1.3, 0}), EntityRef(Face(8)));
  s.view.clip = Clip{0, 0.6};
  s.view.pick_level = PickLevel::Vertex;
  EXPECT_EQ(s.at({1.7, 1.3, 0}), EntityRef(Vertex(5))) << "6 is nearer and not there";
}

TEST(Picking, WholeFacesAreClippedByTheirMiddles) {
  Scene s(zoo::grid(3));
  s.view.clip = Clip{0, 0.5, true};
  EXPECT_EQ(s.at({1.3, 1.1, 0}), EntityRef());
  EXPECT_EQ(s.at({1.3, 1.7, 0}), EntityRef(Face(9)));
  EXPECT_EQ(s.at({1.65, 1.85, 0}), EntityRef(Face(9)))
      << "beyond the plane, of a face that is there";
  EXPECT_EQ(s.within({-1, -1, 0}, {4, 4, 0}).size(), 9u);
}

TEST(Picking, AClippedBallShowsItsInside) {
  Scene s(make_sample("sphere", 12));
  s.view.pick_level = PickLevel::Face;
  const auto height = [&] {
    const EntityRef face = s.at({0.13, 0.07, 0});
    EXPECT_EQ(face.dimension, 2);
    const Mesh& mesh = s.loaded->mesh;
    return mesh.position(mesh.triangle(Face(face.index))[0]).z;
  };
  EXPECT_GT(height(), 0);
  s.view.clip = Clip{2, 0.5};
  EXPECT_LT(height(), 0);
  s.view.clip->flip = true;
  EXPECT_GT(height(), 0);
  s.view.camera.orthographic = false;
  s.view.clip->flip = false;
  EXPECT_LT(height(), 0);
}

TEST(Picking, ABoxTakesWhatCanBeSeenAsAWhole) {
  Scene s(zoo::grid(3));
  EXPECT_EQ(s.within({-0.1, -0.1, 0}, {1.1, 1.1, 0}),
            (std::vector{EntityRef(Face(0)), EntityRef(Face(1))}));
  s.view.pick_level = PickLevel::Vertex;
  auto corners = s.within({2.1, 2.1, 0}, {0.9, 0.9, 0});
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  EXPECT_EQ(corners, (std::vector<EntityRef>{Vertex(5), Vertex(6), Vertex(9), Vertex(10)}));
  s.view.pick_level = PickLevel::Edge;
  auto edges = s.within({-0.1, -0.1, 0}, {1.1, 1.1, 0});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<EntityRef> square;
  for (const auto& [a, b] : {std::pair{0u, 1u}, {1u, 5u}, {0u, 5u}, {5u, 4u}, {4u, 0u}})
    square.emplace_back(s.loaded->mesh.find_edge(Vertex(a), Vertex(b)));
  std::sort(square.begin(), square.end());
  EXPECT_EQ(edges, square);
  Scene ball(make_sample("sphere", 12));
  const auto seen = ball.within({-9, -9, 0}, {9, 9, 0});
  EXPECT_GT(seen.size(), 0u);
  for (const EntityRef e : seen) {
    const auto t = ball.loaded->mesh.triangle(Face(e.index));
    double z = 0;
    for (const Vertex v : t) z += ball.loaded->mesh.position(v).z;
    EXPECT_GT(z, -0.3) << "the far side is hidden";
  }
}

TEST(Picking, FollowsChangesBesideItsTree) {
  Scene s(zoo::grid(3));
  s.view.pick_level = PickLevel::Face;
  EXPECT_EQ(s.at({1.7, 1.3, 0}), EntityRef(Face(8)));
  Mesh& mesh = s.loaded->mesh;
  SurfaceChanges changes;
  changes.faces = {Face(8), Face(3)};
  mesh.destroy(Face(8));
  mesh.move(Vertex(6), {1.5, 1.5, 0});  // face 3 = (1, 6, 5) now reaches into the hole
  s.picker.note(changes);
  EXPECT_EQ(s.at({1.3, 0.9, 0}), EntityRef(Face(3)));
  EXPECT_EQ(s.at({1.9, 1.6, 0}), EntityRef());
}

TEST(Picking, OfAVolumeFacesLeadToRegionsAndVerticesBack) {
  Scene s(zoo::two_tets());
  s.view.camera.turn_to(StandardView::Bottom);
  s.view.pick_level = PickLevel::Region;
  EXPECT_EQ(s.at({0.25, 0.25, 0}), EntityRef(Region(0)));
  s.view.pick_level = PickLevel::Automatic;
  const EntityRef face = s.at({0.3, 0.3, 0});
  ASSERT_EQ(face.dimension, 2);
  VertexBuffer buffer;
  const auto corners = s.loaded->mesh.vertices_of(face, buffer);
  EXPECT_EQ(std::set<std::uint32_t>(corners.begin(), corners.end()),
            (std::set<std::uint32_t>{0, 1, 2}));
  s.view.pick_level = PickLevel::Vertex;
  EXPECT_EQ(s.at({0.9, 0.02, 0}), EntityRef(Vertex(1)));
}

}  // namespace
}  // namespace aomd::scene::picking_test
