// Templates that a program adds or replaces (paper, section 2.2).

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "core/io/error.h"
#include "core/io/io.h"
#include "core/mesh/verify.h"
#include "tests/support/message.h"
#include "tests/support/program.h"
#include "tests/support/twin.h"
#include "tests/support/volume_mesh.h"
#include "tests/support/zoo.h"

namespace aomd::templates_test {
namespace {

using oracle::Ids;
using oracle::Twin;
using test::message;
using test::set_all;

ShapeTemplate make(std::string_view name, int dimension, int vertices,
                   const std::vector<Ids>& edges,
                   const std::vector<std::pair<Shape, Ids>>& faces = {}) {
  ShapeTemplate t{
      name, dimension, vertices, static_cast<int>(edges.size()), static_cast<int>(faces.size()),
      {},   {}};
  const auto fill = [](SubEntity& sub, Shape shape, const Ids& ids) {
    sub.shape = shape;
    for (std::size_t k = 0; k < ids.size(); ++k)
      sub.vertices[k] = static_cast<std::uint8_t>(ids[k]);
  };
  for (std::size_t i = 0; i < edges.size(); ++i) fill(t.edges[i], Shape::Line, edges[i]);
  for (std::size_t i = 0; i < faces.size(); ++i) fill(t.faces[i], faces[i].first, faces[i].second);
  return t;
}

// Shapes of the program's own; added once, for templates stay.
struct OwnShapes {
  Shape hexagon, hexagonal_prism, bipyramid, orange;
};

//      11--10            the bottom 0 to 5, the top 6 to 11
//     /      \           .
//    6        9
//     \      /
//      7----8
ShapeTemplate hexagonal_prism(Shape hexagon) {
  std::vector<Ids> edges;
  std::vector<std::pair<Shape, Ids>> faces{{hexagon, {0, 5, 4, 3, 2, 1}},
                                           {hexagon, {6, 7, 8, 9, 10, 11}}};
  for (std::uint32_t k = 0; k < 6; ++k) {
    const std::uint32_t next = (k + 1) % 6;
    edges.insert(edges.end(), {{k, next}, {k + 6, next + 6}, {k, k + 6}});
    faces.push_back({Shape::Quad, {k, next, next + 6, k + 6}});
  }
  return make("hexagonal prism", 3, 12, edges, faces);
}

const OwnShapes& own() {
  static const OwnShapes shapes = [] {
    OwnShapes s{};
    s.hexagon =
        add_template(make("hexagon", 2, 6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}));
    s.hexagonal_prism = add_template(hexagonal_prism(s.hexagon));
    constexpr Shape tri = Shape::Triangle, quad = Shape::Quad;
    // 3 above and 4 below the triangle 0 1 2
    s.bipyramid = add_template(make(
        "bipyramid", 3, 5, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}, {0, 4}, {1, 4}, {2, 4}},
        {{tri, {0, 1, 3}},
         {tri, {1, 2, 3}},
         {tri, {2, 0, 3}},
         {tri, {1, 0, 4}},
         {tri, {2, 1, 4}},
         {tri, {0, 2, 4}}}));
    // Three quads from pole 0 to pole 1: each pole lies on all faces, so that faces alone cannot
    // tell them apart.
    s.orange =
        add_template(make("orange", 3, 5, {{0, 2}, {0, 3}, {0, 4}, {2, 1}, {3, 1}, {4, 1}},
                          {{quad, {0, 2, 1, 3}}, {quad, {0, 3, 1, 4}}, {quad, {0, 4, 1, 2}}}));
    return s;
  }();
  return shapes;
}

Ids numbers(std::uint32_t n, std::uint32_t first = 0) {
  Ids ids(n);
  for (std::uint32_t k = 0; k < n; ++k) ids[k] = first + k;
  return ids;
}

MeshData points(std::uint32_t n) {
  MeshData data;
  for (std::uint32_t k = 0; k < n; ++k) data.positions.emplace_back(k % 5, k % 7, k % 3);
  return data;
}

TEST(TemplatesTest, OwnShapesAreCountedAndNamed) {
  const std::size_t before = shape_count();
  const OwnShapes& s = own();
  EXPECT_EQ(shape_count(), std::max(before, builtin_shapes + 4));
  EXPECT_EQ(shape_template(s.hexagonal_prism).name, "hexagonal prism");
  EXPECT_EQ(face_shape(6), s.hexagon);
  EXPECT_EQ(face_shape(4), Shape::Quad);
  EXPECT_THROW((void)face_shape(5), std::invalid_argument);
}

TEST(TemplatesTest, RelationsOfOwnShapesAreThoseOfTheOracle) {
  for (const Shape shape : {own().hexagonal_prism, own().bipyramid, own().orange})
    for (const bool all_stored : {false, true}) {
      const auto n = static_cast<std::uint32_t>(shape_template(shape).vertex_count);
      Twin twin(points(n + 4), [&](Mesh& mesh) {
        if (all_stored) set_all(mesh);
        mesh.set(1, 0);
        mesh.set(2, 0);
      });
      ASSERT_TRUE(twin.create(shape, numbers(n), ModelRef(3, 1)));
      ASSERT_TRUE(twin.create(Shape::Tetrahedron, {0, 2, n, n + 1}, ModelRef(3, 2)));  // beside it
      EXPECT_NO_THROW(twin.check_all()) << shape_template(shape).name;
      EXPECT_EQ(twin.mesh().count(1),
                static_cast<std::uint32_t>(shape_template(shape).edge_count) +
                    (shape_template(shape).edge_count == 9 || shape == own().orange ? 5u : 6u));
    }
}

TEST(TemplatesTest, OwnRegionsFromVerticesEdgesAndFaces) {
  for (const Shape shape : {own().hexagonal_prism, own().bipyramid}) {
    const auto n = static_cast<std::uint32_t>(shape_template(shape).vertex_count);
    Twin twin(points(n), set_all);
    ASSERT_TRUE(twin.create(shape, numbers(n), ModelRef(3, 1)));
    for (const auto from : {Twin::From::Edges, Twin::From::Faces}) {
      ASSERT_TRUE(twin.destroy(Region(0)));
      ASSERT_TRUE(twin.create(shape, numbers(n), ModelRef(3, 1), from));
      EXPECT_NO_THROW(twin.check_all()) << shape_template(shape).name;
    }
    const auto row = twin.mesh().row<1>(Face(0));
    const std::vector<Edge> edges(row.begin(), row.end());
    twin.mesh().destroy_with_users(Face(0));
    EXPECT_EQ(twin.mesh().shape(twin.mesh().create_face(edges)),
              shape_template(shape).faces[0].shape);
  }
}

TEST(TemplatesTest, FacesThatCannotTellTheCornersMayNotHoldTheRegions) {
  Mesh mesh(points(5));
  set_all(mesh);
  std::vector<Vertex> v;
  for (std::uint32_t k = 0; k < 5; ++k) v.emplace_back(k);
  const Region r = mesh.create_region(own().orange, v);
  const std::string before = zoo::fingerprint(mesh);
  mesh.unset(3, 0);
  EXPECT_EQ(zoo::fingerprint(mesh), before) << "by edges";
  EXPECT_EQ(message([&] { mesh.unset(3, 1); }), "T(3,1) defines the regions: set T(3,0) first");
  const auto row = mesh.row<2>(r);
  const std::vector<Face> faces(row.begin(), row.end());
  EXPECT_THROW((void)mesh.create_region(own().orange, std::span<const Face>(faces)),
               std::invalid_argument);
  EXPECT_TRUE(verify(mesh).empty());
}

TEST(TemplatesTest, RegionsOfOwnShapesMayBeHeldByTheirSides) {
  for (const Shape shape : {own().hexagonal_prism, own().bipyramid})
    for (const int held_by : {1, 2}) {
      const auto n = static_cast<std::uint32_t>(shape_template(shape).vertex_count);
      Twin twin(points(n), set_all);
      ASSERT_TRUE(twin.create(shape, numbers(n), {}));
      twin.unset(3, 0);
      twin.unset(3, 3 - held_by);
      EXPECT_NO_THROW(twin.check_all()) << shape_template(shape).name << held_by;
    }
}

TEST(TemplatesTest, RandomProgramsOnOwnShapes) {
  MeshData data = points(20);
  const auto add = [&](Shape shape, const Ids& v) {
    data.regions.shapes.push_back(shape);
    data.regions.vertices.insert(data.regions.vertices.end(), v.begin(), v.end());
  };
  add(own().hexagonal_prism, numbers(12));
  add(own().bipyramid, {6, 7, 8, 12, 13});
  add(own().orange, {14, 15, 16, 17, 18});
  add(Shape::Hexahedron, {0, 1, 7, 6, 14, 15, 16, 17});
  Twin twin(data);
  oracle::Program program(twin, 3, {true, true, true, true});
  for (int i = 0; i < 4000; ++i) {
    ASSERT_NO_THROW(program.operation()) << i;
    if (i % 200 == 0) {
      ASSERT_NO_THROW(twin.check_all()) << i;
    }
  }
}

TEST(TemplatesTest, NoFileFormatKnowsOwnShapes) {
  MeshData data = points(12);
  data.regions.shapes = {own().hexagonal_prism};
  data.regions.vertices = numbers(12);
  const auto folder = std::filesystem::temp_directory_path() / "aomd_templates_test";
  std::filesystem::create_directory(folder);
  for (const char* name :
       {"a.msh", "a.mesh", "a.vtk", "a.vtu", "a.su2", "a.ply", "a.obj", "a.off", "a.stl"}) {
    EXPECT_THROW(io::write(folder / name, data), io::WriteError) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  }
  std::filesystem::remove_all(folder);
}

/// Replaces a template for as long as it lives.
class Override {
 public:
  Override(Shape shape, const ShapeTemplate& replacement)
      : shape_(shape), before_(shape_template(shape)) {
    override_template(shape, replacement);
  }
  Override(const Override&) = delete;
  Override& operator=(const Override&) = delete;
  ~Override() { override_template(shape_, before_); }

 private:
  Shape shape_;
  ShapeTemplate before_;
};

TEST(TemplatesTest, TheTetrahedronNumberedInAnotherWayAndBack) {
  constexpr Shape tri = Shape::Triangle;
  const auto edges = [] {
    Mesh mesh(zoo::one_tet());
    set_all(mesh);
    std::vector<Ids> ends;
    for (const Edge e : mesh.row<1>(Region(0))) {
      const auto [a, b] = mesh.edge_vertices(e);
      ends.push_back(oracle::sorted({a.index, b.index}));
    }
    return ends;
  };
  const std::vector<Ids> usual{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  const std::vector<Ids> gmsh{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};
  EXPECT_EQ(edges(), usual);
  {
    const Override as_in_gmsh(
        Shape::Tetrahedron,
        make("tetrahedron", 3, 4, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}},
             {{tri, {0, 2, 1}}, {tri, {0, 1, 3}}, {tri, {0, 3, 2}}, {tri, {3, 1, 2}}}));
    EXPECT_EQ(edges(), gmsh);
    Twin twin(zoo::two_tets(), set_all);
    EXPECT_NO_THROW(twin.check_all());
    twin.unset(3, 0);
    twin.unset(3, 2);
    EXPECT_NO_THROW(twin.check_all()) << "held by edges";
  }
  EXPECT_EQ(edges(), usual);
}

// A tetrahedron with one thing wrong.
ShapeTemplate spoilt(const std::function<void(ShapeTemplate&)>& spoil) {
  ShapeTemplate t = shape_template(Shape::Tetrahedron);
  t.name = "odd";
  spoil(t);
  return t;
}

TEST(TemplatesTest, ContradictionsAreRefusedWithTheReason) {
  const std::pair<const char*, std::function<void(ShapeTemplate&)>> cases[] = {
      {"the dimension is 2 or 3", [](ShapeTemplate& t) { t.dimension = 1; }},
      {"too few or too many vertices", [](ShapeTemplate& t) { t.vertex_count = 13; }},
      {"too few or too many vertices", [](ShapeTemplate& t) { t.vertex_count = -1; }},
      {"too few or too many edges", [](ShapeTemplate& t) { t.edge_count = 19; }},
      {"too few or too many faces", [](ShapeTemplate& t) { t.face_count = 9; }},
      {"a position is out of range", [](ShapeTemplate& t) { t.edges[2].vertices[1] = 4; }},
      {"a lower entity has a shape of another dimension",
       [](ShapeTemplate& t) { t.faces[0].shape = Shape::Line; }},
      {"a lower entity has a shape of another dimension",
       [](ShapeTemplate& t) { t.edges[0].shape = static_cast<Shape>(31); }},
      {"a lower entity repeats a vertex", [](ShapeTemplate& t) { t.edges[0].vertices[1] = 0; }},
      {"a lower entity is listed twice", [](ShapeTemplate& t) { t.edges[1] = t.edges[0]; }},
      {"a lower entity is listed twice", [](ShapeTemplate& t) { t.faces[3] = t.faces[1]; }},
      {"a face has a side that is no edge of the shape",
       [](ShapeTemplate& t) { t.edge_count = 5; }}};
  const std::size_t before = shape_count();
  for (const auto& [reason, spoil] : cases) {
    const ShapeTemplate odd = spoilt(spoil);
    EXPECT_EQ(message([&] { (void)add_template(odd); }),
              std::string("template \"odd\": ") + reason);
    EXPECT_THROW(override_template(Shape::Tetrahedron, odd), std::invalid_argument);
  }
  ShapeTemplate crossed = shape_template(Shape::Quad);
  std::swap(crossed.edges[1], crossed.edges[2]);
  EXPECT_EQ(message([&] { (void)add_template(crossed); }),
            "template \"quad\": edge k of a face joins its vertices k and k + 1");
  EXPECT_EQ(message([&] { override_template(Shape::Tetrahedron, shape_template(Shape::Pyramid)); }),
            "template \"pyramid\": dimension and vertex count must stay");
  EXPECT_EQ(shape_count(), before);
}

TEST(TemplatesTest, ZLastThereIsRoomForSoManyOnly) {
  while (shape_count() < max_shapes) (void)add_template(shape_template(Shape::Prism));
  EXPECT_THROW((void)add_template(shape_template(Shape::Prism)), std::length_error);
  EXPECT_EQ(shape_count(), max_shapes);
}

}  // namespace
}  // namespace aomd::templates_test
