// What is drawn of meshes with regions or quads, and what a session says about them.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "tests/support/message.h"
#include "tests/support/session_helpers.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene::skin_test {
namespace {

using test::drive;

constexpr ModelRef left{3, 1};
constexpr ModelRef right{3, 2};

/// Two tetrahedra on the triangle 0 1 2, the tips 3 above and 4 below.
MeshData two_tetrahedra(ModelRef above, ModelRef below) {
  MeshData data;
  data.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 2}, {1, 1, -2}};
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, above);
  data.regions.add(Shape::Tetrahedron, {0, 2, 1, 4}, below);
  return data;
}

/// Two unit cubes side by side along x.
MeshData two_cubes(ModelRef first, ModelRef second) {
  MeshData data;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z) data.positions.emplace_back(x, y, z);
  const auto cube = [&](std::uint32_t o, ModelRef model) {
    data.regions.add(Shape::Hexahedron, {o, o + 4, o + 6, o + 2, o + 1, o + 5, o + 7, o + 3},
                     model);
  };
  cube(0, first);
  cube(4, second);
  return data;
}

MeshData two_quads() {
  MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  data.faces.add(Shape::Quad, {0, 1, 4, 3});
  data.faces.add(Shape::Quad, {1, 2, 5, 4});
  return data;
}

glm::dvec3 middle(const Mesh& mesh, std::span<const std::uint32_t> corners) {
  glm::dvec3 sum{0};
  for (const std::uint32_t v : corners) sum += mesh.position(Vertex(v));
  return sum / static_cast<double>(corners.size());
}

glm::dvec3 normal(const Mesh& mesh, std::span<const std::uint32_t> c) {
  const auto p = [&](std::size_t k) { return mesh.position(Vertex(c[k])); };
  return glm::cross(p(1) - p(0), p(2) - p(0));
}

void expect_outward(const Mesh& mesh, const glm::dvec3& center) {
  const Skin skin(mesh);
  for (const SkinFace& face : skin.faces())
    EXPECT_GT(glm::dot(normal(mesh, face.corners()), middle(mesh, face.corners()) - center), 0);
}

TEST(Skin, OfTwoTetrahedraHasSixSidesAndOneMoreBetweenModelRegions) {
  EXPECT_EQ(Skin(Mesh(two_tetrahedra(left, left))).faces().size(), 6u);
  const Skin skin(Mesh(two_tetrahedra(left, right)));
  EXPECT_EQ(skin.faces().size(), 7u);
  EXPECT_EQ(skin.outer(), 6);
  const auto between = std::find_if(skin.faces().begin(), skin.faces().end(),
                                    [](const SkinFace& f) { return f.has_outside; });
  ASSERT_NE(between, skin.faces().end());
  EXPECT_EQ(between->inside, left);
  EXPECT_EQ(between->outside, right);
  EXPECT_EQ(std::set<std::uint32_t>(between->corners().begin(), between->corners().end()),
            (std::set<std::uint32_t>{0, 1, 2}));
}

TEST(Skin, FacesOfTheFileClassifyItAndShowInsideWhereTheyLieOnAModelFace) {
  MeshData data = two_tetrahedra(left, left);
  data.faces.add(Shape::Triangle, {1, 3, 0}, ModelRef(2, 8));
  data.faces.add(Shape::Triangle, {2, 1, 0}, ModelRef(2, 9));
  data.faces.add(Shape::Triangle, {0, 3, 4});
  const Skin skin{Mesh(data)};
  EXPECT_EQ(skin.faces().size(), 8u);  // six sides, the inner face, the loose one
  EXPECT_EQ(skin.outer(), 7);
  const auto lie_on = [&](ModelRef model) {
    return std::count_if(skin.faces().begin(), skin.faces().end(),
                         [&](const SkinFace& f) { return f.model == model; });
  };
  EXPECT_EQ(lie_on(ModelRef(2, 8)), 1);
  EXPECT_EQ(lie_on(ModelRef(2, 9)), 1);
  data.faces.classes[1] = {};
  EXPECT_EQ(Skin(Mesh(data)).faces().size(), 7u);
}

TEST(Skin, LooksOutwardAlsoWhereAFileNumbersRegionsInsideOut) {
  MeshData data = two_tetrahedra(left, left);
  expect_outward(Mesh(data), {4.0 / 3, 4.0 / 3, 0});
  std::swap(data.regions.vertices[0], data.regions.vertices[1]);
  expect_outward(Mesh(data), {4.0 / 3, 4.0 / 3, 0});
  expect_outward(Mesh(two_cubes(left, left)), {1, 0.5, 0.5});
}

TEST(Skin, QuadsThatShareThreeVerticesAreTwo) {
  MeshData data = two_quads();
  data.positions.emplace_back(1, 1, 1);
  data.faces.add(Shape::Quad,
                 {0, 1, 6, 3});  // smallest, second and largest id as in {0, 1, 2, 6} below
  data.faces.add(Shape::Quad, {0, 1, 2, 6});
  EXPECT_EQ(Skin(Mesh(data)).faces().size(), 4u);
}

TEST(SkinSurface, HidingARegionShowsItsNeighbourFromOutside) {
  const Mesh mesh(two_tetrahedra(left, right));
  const Skin skin(mesh);
  EXPECT_EQ(make_skin_surface(mesh, skin, {}).mesh.count(2), 7u);
  EXPECT_EQ(make_skin_surface(mesh, skin, {.interfaces = false}).mesh.count(2), 6u);
  const SkinSurface rest =
      make_skin_surface(mesh, skin, {.hidden_regions = {left}, .interfaces = false});
  EXPECT_EQ(rest.mesh.count(2), 4u);
  for (const Face f : rest.mesh.faces()) {
    EXPECT_EQ(rest.mesh.classification(f), right);
    VertexBuffer buffer;
    const auto corners = rest.mesh.vertices_of(f, buffer);
    EXPECT_GT(
        glm::dot(normal(rest.mesh, corners), middle(rest.mesh, corners) - glm::dvec3(1, 1, -0.5)),
        0);
  }
  EXPECT_EQ(make_skin_surface(mesh, skin, {.hidden_regions = {left, right}}).mesh.count(2), 0u);
  const SkinSurface bright = make_skin_surface(mesh, skin, {.highlighted_region = right});
  EXPECT_EQ(std::count(bright.flags.begin(), bright.flags.end(), highlighted), 4);
}

TEST(SkinSurface, QuadsAreTwoTrianglesWithoutTheLineBetweenThem) {
  const Mesh mesh(two_cubes(left, left));
  const SkinSurface surface = make_skin_surface(mesh, Skin(mesh), {});
  ASSERT_EQ(surface.mesh.count(2), 20u);
  for (const Face f : surface.mesh.faces()) {
    const auto t = surface.mesh.triangle(f);
    int hidden = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length =
          glm::length(surface.mesh.position(t[k]) - surface.mesh.position(t[(k + 1) % 3]));
      const bool line = (surface.flags[f.index] >> k & 1u) == 0;
      EXPECT_EQ(line, length < 1.1) << f.index;
      hidden += !line;
    }
    EXPECT_EQ(hidden, 1);
  }
}

TEST(SkinSurface, BordersAreLinesWhereTheMeshNamesNoModelEdge) {
  const auto borders = [](const MeshData& data) {
    const Mesh mesh(data);
    const SkinSurface surface = make_skin_surface(mesh, Skin(mesh), {});
    std::uint32_t count = 0;
    for (const Edge e : surface.mesh.edges())
      count += surface.mesh.classification(e) == unnamed_border;
    return count;
  };
  EXPECT_EQ(borders(two_cubes(left, left)), 0u);
  MeshData data = two_cubes(left, right);
  EXPECT_EQ(borders(data), 4u);
  data.edges.add(Shape::Line, {0, 4}, ModelRef(1, 5));
  EXPECT_EQ(borders(data), 0u);
  const Mesh mesh(data);
  const SkinSurface surface = make_skin_surface(mesh, Skin(mesh), {});
  EXPECT_EQ(surface.mesh.class_lists()->entities(1, ModelRef(1, 5)).size(), 1u);
}

void show(Session& s, const MeshData& data) {
  s.show(make_loaded(data, "made"));
  s.refresh();
}

TEST(Volume, IsShownWithoutStoringMoreThanItsDataLists) {
  Session s;
  show(s, two_cubes(left, right));
  const Mesh& mesh = s.document().mesh();
  EXPECT_EQ(mesh.count(1) + mesh.count(2), 0u);
  EXPECT_FALSE(mesh.complete(2));
  drive(s, {"expect regions = 2", "expect outer-faces = 10", "expect model-regions = 2",
            "expect unused = 0", "expect adjacency 3 0 = on", "expect adjacency 2 3 = off",
            "expect faces = 0"});
  EXPECT_EQ(s.sheet().drawing().drawable().corners.size(), 3u * 22);
  drive(s, {"adjacency 2 3 on", "expect faces = 11", "expect adjacency 2 3 = on",
            "expect outer-faces = 10"});
  EXPECT_TRUE(mesh.complete(2));
  EXPECT_EQ(s.sheet().drawing().drawable().corners.size(), 3u * 22);
  drive(s, {"hide region:1"});
  EXPECT_EQ(s.sheet().drawing().drawable().corners.size(), 3u * 12);
  drive(s, {"hide", "show interfaces off"});
  EXPECT_EQ(s.sheet().drawing().drawable().corners.size(), 3u * 20);
}

TEST(Volume, WithoutTetrahedraRefusesDecimationWithASentenceAndKeepsTheRest) {
  Session s;
  show(s, two_cubes(left, right));
  for (const char* line : {"step", "step 3", "sweep", "swap", "smooth", "improve", "run"}) {
    try {
      drive(s, {line});
      FAIL() << line;
    } catch (const CommandError& error) {
      EXPECT_NE(std::string(error.what()).find("only tetrahedra"), std::string::npos);
    }
  }
  drive(s, {"undo", "redo", "seek end", "reset", "play", "highlight region:2", "color none", "fit",
            "expect steps = 0", "expect regions = 2"});
  drive(s, {"sample sphere 8", "step", "expect steps = 1", "expect regions = 0"});
}

TEST(Volume, CountsShapesAndUnusedVertices) {
  MeshData data = two_tetrahedra(left, right);
  data.positions.emplace_back(9, 9, 9);
  Session s;
  show(s, data);
  EXPECT_EQ(s.sheet().facts().shapes[static_cast<std::size_t>(Shape::Tetrahedron)], 2);
  EXPECT_EQ(s.sheet().facts().unused, 1);
  EXPECT_DOUBLE_EQ(s.document().content().bounds.high.x, 3);
}

TEST(Volume, WithoutAnyClassGetsOneFromItsAngles) {
  Session s;
  show(s, two_cubes({}, {}));
  drive(s, {"expect model-regions = 1", "expect model-faces = 6", "expect model-edges = 12"});
  const auto drawn = [&] {
    std::set<ModelRef> models;
    for (const SkinFace& face : s.document().content().skin->faces()) models.insert(face.model);
    return models.size();
  };
  EXPECT_EQ(drawn(), 6u);
  drive(s, {"feature-angle off", "expect model-faces = 1"});
  EXPECT_EQ(drawn(), 1u);
  drive(s, {"undo", "expect model-faces = 6"});
  EXPECT_EQ(drawn(), 6u);
}

TEST(Volume, ThatItsFileClassifiesSaysWhatDerivesOtherModelEdges) {
  Session s;
  drive(s, {"sample tet-box"});
  const std::string why = aomd::test::message([&] { execute(s, "feature-angle 30"); });
  EXPECT_NE(why.find("aomd classify IN OUT --replace --angle DEG"), std::string::npos) << why;
}

TEST(Quads, AreCountedAndDrawnButNotDecimated) {
  Session s;
  show(s, two_quads());
  drive(s, {"expect faces = 2", "expect edges = 7", "expect boundary = 6", "expect euler = 1"});
  EXPECT_EQ(s.sheet().facts().shapes[static_cast<std::size_t>(Shape::Quad)], 2);
  EXPECT_EQ(s.sheet().drawing().drawable().corners.size(), 3u * 4);
  EXPECT_THROW(drive(s, {"sweep"}), CommandError);
  EXPECT_NE(s.document().hindrance().find("quads"), std::string_view::npos);
}

}  // namespace
}  // namespace aomd::scene::skin_test
