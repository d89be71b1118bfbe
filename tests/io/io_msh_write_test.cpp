// What MSH files keep of a mesh: through all four variants and back.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/io/formats.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::io_msh_write_test {
namespace {

struct Variant {
  bool binary, msh2;
};
constexpr Variant variants[] = {{false, false}, {true, false}, {false, true}, {true, true}};

MeshData through(const MeshData& mesh, Variant v) {
  return io::read_bytes("a.msh", io::detail::write_msh(mesh, v.binary, v.msh2)).mesh;
}

/// All shapes, every kind of class, and an order that no grouping by model entity keeps.
MeshData zoo() {
  MeshData mesh;
  for (int i = 0; i < 12; ++i)
    mesh.positions.emplace_back(i & 1, -0.1 * (i >> 1 & 1), -1e-300 * (i >> 2));
  mesh.regions.add(Shape::Tetrahedron, {0, 1, 2, 4}, ModelRef(3, 8));
  mesh.regions.add(Shape::Hexahedron, {0, 1, 3, 2, 4, 5, 7, 6}, ModelRef(3, 2));
  mesh.regions.add(Shape::Pyramid, {0, 1, 3, 2, 8}, ModelRef(3, 8));
  mesh.regions.add(Shape::Prism, {0, 1, 2, 8, 9, 10}, ModelRef(3, 2));
  mesh.regions.add(Shape::Tetrahedron, {8, 9, 10, 11}, ModelRef(3, 8));
  mesh.faces.add(Shape::Quad, {0, 1, 3, 2}, ModelRef(2, 70));
  mesh.faces.add(Shape::Triangle, {3, 2, 4}, ModelRef(2, -5));
  mesh.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 70));
  mesh.edges.add(Shape::Line, {2, 3}, ModelRef(1, 9));
  mesh.edges.add(Shape::Line, {1, 0}, ModelRef(1, 4));
  return mesh;
}

/// The classes that reading 2.2 derives, too.
std::vector<ModelRef> zoo_vertex_classes() {
  return {{0, 3}, {1, 4}, {1, 9}, {1, 9}, {2, -5}, {3, 2},
          {3, 2}, {3, 2}, {3, 2}, {3, 2}, {3, 2},  {3, 8}};
}

/// What `zoo` is with a table of its entities, as the files keep it.
MeshData described_zoo() {
  MeshData mesh = zoo();
  mesh.vertex_classes = zoo_vertex_classes();
  mesh.model = through(mesh, {false, false}).model;
  mesh.model.groups = {{3, 1, "all of it"}, {0, 7, "tip"}};
  for (ModelEntity& entity : mesh.model.entities) {
    if (entity.ref.dimension() == 3) entity.groups = {1};
    if (entity.ref == ModelRef(1, 4)) entity.boundary = {3, -3};
  }
  return mesh;
}

TEST(MshWrite, KeepsEverythingIn4) {
  MeshData mesh = described_zoo();
  mesh.attributes = {{"pressure", 0, 1, false, std::vector<double>(12, 0.1)},
                     {"normal", 2, 3, false, {1, 2, 3, 4, 5, 6, 7, 8, -0.5}},
                     {"id", 3, 1, false, {5, 4, 3, 2, 1}}};
  EXPECT_EQ(through(mesh, {false, false}), mesh);
  EXPECT_EQ(through(mesh, {true, false}), mesh);
}

TEST(MshWrite, KeepsAllBut2sTableIn2) {
  MeshData mesh = described_zoo();
  mesh.attributes = {{"pressure", 0, 1, false, std::vector<double>(12, 0.1)},
                     {"id", 1, 1, false, {5, 4}}};
  for (const bool binary : {false, true}) {
    MeshData back = through(mesh, {binary, true});
    ASSERT_EQ(back.model.entities.size(), 2u);
    EXPECT_EQ(back.model.entities[0],
              (ModelEntity{ModelRef(3, 2), {1}, {}, mesh.model.entities[6].box}));
    back.model.entities = mesh.model.entities;
    EXPECT_EQ(back, mesh);
  }
}

TEST(MshWrite, DescribesEntitiesThatTheTableLacks) {
  const MeshData mesh = described_zoo();
  std::vector<ModelRef> refs;
  for (const ModelEntity& entity : mesh.model.entities) refs.push_back(entity.ref);
  EXPECT_EQ(refs,
            (std::vector<ModelRef>{{0, 3}, {1, 4}, {1, 9}, {2, -5}, {2, 70}, {3, 2}, {3, 8}}));
  EXPECT_EQ(mesh.model.entities[2].box, (std::array<double, 6>{0, -0.1, 0, 1, -0.1, 0}));
}

TEST(MshWrite, InventsNoClassification) {
  MeshData mesh = zoo();
  for (int dim = 1; dim <= 3; ++dim) mesh.list(dim).classes.clear();
  for (const Variant v : variants) EXPECT_EQ(through(mesh, v), mesh);
  mesh.faces.classes = {ModelRef(), ModelRef(2, 6), ModelRef()};
  for (const bool binary : {false, true}) {
    const MeshData back = through(mesh, {binary, false});
    EXPECT_EQ(back.faces.classes, mesh.faces.classes);
    EXPECT_TRUE(back.vertex_classes.empty());
    EXPECT_TRUE(back.regions.classes.empty());
    ASSERT_EQ(back.model.entities.size(), 1u);
    EXPECT_EQ(back.model.entities[0].ref, ModelRef(2, 6));
  }
}

// Gmsh refuses a line that is listed for a surface.
TEST(MshWrite, ElementsInsideALargerEntityAreUnclassified) {
  MeshData mesh = zoo();
  mesh.edges.classes = {ModelRef(2, 70), ModelRef(1, 4)};
  for (const Variant v : variants)
    EXPECT_EQ(through(mesh, v).edges.classes, (std::vector{ModelRef(), ModelRef(1, 4)}));
}

TEST(MshWrite, LeavesOutWhatAnAttributeDoesNotKnow) {
  MeshData mesh = zoo();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  mesh.attributes = {{"two", 1, 2, false, {unknown, unknown, 3, unknown}}};
  for (const Variant v : variants) {
    const std::string bytes = io::detail::write_msh(mesh, v.binary, v.msh2);
    EXPECT_NE(bytes.find("\n0\n2\n1\n"), std::string::npos);  // step, components, values
    const MeshData back = io::read_bytes("a.msh", bytes).mesh;
    ASSERT_EQ(back.attributes.size(), 1u);
    const std::vector<double>& values = back.attributes[0].values;
    ASSERT_EQ(values.size(), 4u);
    EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]) && std::isnan(values[3]));
    EXPECT_EQ(values[2], 3);
  }
}

TEST(MshWrite, NamesStayOnOneLine) {
  MeshData mesh = zoo();
  mesh.model.groups = {{2, 1, "a \"b\"\nc"}};
  EXPECT_EQ(through(mesh, {false, false}).model.groups[0].name, "a 'b' c");
}

TEST(MshWrite, WritesAnEmptyMesh) {
  for (const Variant v : variants) EXPECT_EQ(through({}, v), MeshData());
}

TEST(MshWrite, NoPrefixIsAMesh) {
  for (const Variant v : variants) {
    const std::string bytes = io::detail::write_msh(described_zoo(), v.binary, v.msh2);
    for (std::size_t size = 0; size + 1 < bytes.size(); ++size)
      EXPECT_NE(test::error_of("a.msh", bytes.substr(0, size)), "")
          << size << " of " << bytes.size();
  }
}

TEST(MshWrite, TheExtensionChoosesIt) {
  const test::TemporaryFolder folder;
  const MeshData mesh = make_sample("box", 1);
  io::write(folder / "a.msh", mesh, {.binary = true, .msh2 = true});
  const io::ReadResult result = io::read(folder / "a.msh");
  EXPECT_EQ(result.format, io::Format::Msh);
  EXPECT_EQ(test::bytes_of(folder / "a.msh").substr(0, 19), "$MeshFormat\n2.2 1 8");
  EXPECT_EQ(result.mesh.faces, mesh.faces);
  EXPECT_EQ(result.mesh.positions, mesh.positions);
}

/// Counts of the shapes, by Shape, and of the vertices on entities of dimension 0 to 3.
struct RealFile {
  const char* name;
  std::size_t vertices, lines, triangles, quads, tetrahedra, pyramids, prisms, hexahedra;
  std::size_t on_points;  ///< vertices on model vertices
  std::size_t entities;
  std::size_t turned = 0;  ///< regions that are listed inside out
};

constexpr RealFile real_files[] = {
    {"bimetal_v41_binary.msh", 3881, 0, 0, 0, 16275, 0, 0, 0, 12, 45},
    {"cubes_3regions_v41.msh", 7714, 0, 0, 0, 32981, 0, 0, 0, 0, 3},
    {"frame_cad_v41.msh", 25681, 5208, 39620, 0, 95453, 0, 0, 0, 632, 1966},
    {"hex_surfaces_v41.msh", 462, 0, 0, 460, 0, 0, 0, 200, 0, 28, 200},
    {"hybrid_lshape_v41.msh", 75, 0, 0, 0, 48, 48, 24, 0, 0, 1},
    {"mixed_knowles_v22.msh", 9161, 0, 0, 160, 0, 3936, 4128, 3680, 0, 3, 10432},
    {"nested_cubes_v22.msh", 138, 0, 240, 0, 520, 0, 0, 0, 0, 14},
    {"sphere_hex_v22.msh", 19257, 0, 0, 384, 0, 0, 0, 18944, 0, 43},
    {"t5_spheres_v41.msh", 29899, 936, 16492, 0, 165295, 0, 0, 0, 49, 185},
};

class MshFiles : public ::testing::TestWithParam<RealFile> {};

TEST_P(MshFiles, AreReadWholeAndSurviveAllVariants) {
  const RealFile& file = GetParam();
  const std::filesystem::path path = std::filesystem::path(AOMD_SHARED_DATA) / file.name;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared data is not here: " << path;
  const io::ReadResult result = io::read(path);
  EXPECT_EQ(result.turned.size(), file.turned);
  EXPECT_EQ(result.notes.size(), file.turned > 0 ? 1u : 0u);
  const MeshData& mesh = result.mesh;
  std::array<std::size_t, builtin_shapes> counts{};
  for (int dim = 1; dim <= 3; ++dim)
    for (const Shape shape : mesh.list(dim).shapes) ++counts[static_cast<std::size_t>(shape)];
  EXPECT_EQ(mesh.positions.size(), file.vertices);
  EXPECT_EQ(counts, (std::array<std::size_t, builtin_shapes>{
                        0, file.lines, file.triangles, file.quads, file.tetrahedra, file.pyramids,
                        file.prisms, file.hexahedra}));
  EXPECT_EQ(mesh.model.entities.size(), file.entities);
  EXPECT_EQ(
      static_cast<std::size_t>(std::count_if(mesh.vertex_classes.begin(), mesh.vertex_classes.end(),
                                             [](ModelRef m) { return m.dimension() == 0; })),
      file.on_points);
  for (const Variant v : variants) {
    MeshData back = through(mesh, v);
    if (v.msh2) {  // no table, and vertex classes only as far as elements show them
      back.model.entities = mesh.model.entities;
      back.vertex_classes = mesh.vertex_classes;
    }
    EXPECT_TRUE(back == mesh) << (v.binary ? "binary" : "text") << (v.msh2 ? " 2.2" : " 4.1");
  }
}

INSTANTIATE_TEST_SUITE_P(Msh, MshFiles, ::testing::ValuesIn(real_files), [](const auto& test) {
  return std::string(test.param.name, std::strcspn(test.param.name, "."));
});

}  // namespace
}  // namespace aomd::io_msh_write_test
