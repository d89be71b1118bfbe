// Real meshes with regions, through every format that can hold them; exact counts are from the
// README of the data.

#include <map>

#include "core/samples/samples.h"
#include "tests/support/volume_helpers.h"

namespace aomd::io_volume_test {
namespace {

using test::count;

const std::filesystem::path data = AOMD_SHARED_DATA;

/// Reads a file of the shared data, or skips the test.
#define READ_SHARED(result, name)                                                                \
  if (!std::filesystem::exists(data / (name))) GTEST_SKIP() << data / (name) << " is not there"; \
  const io::ReadResult result = io::read(data / (name))

/// How many regions have positive, zero and negative volume at their first corner.
struct Signs {
  int positive = 0, zero = 0, negative = 0;
};
std::map<Shape, Signs> signs(const MeshData& mesh) {
  std::map<Shape, Signs> result;
  test::for_each_corner_volume(mesh, [&](Shape shape, double volume) {
    Signs& s = result[shape];
    ++(volume > 0 ? s.positive : volume < 0 ? s.negative : s.zero);
  });
  return result;
}

/// VTK, VTU and SU2 keep everything that such a mesh has; so does Medit, up to what `medit` says.
void expect_vtk_round_trips(const MeshData& mesh) {
  for (const char* name : {"a.vtk", "a.vtu"}) {
    for (const bool binary : {false, true}) {
      SCOPED_TRACE(std::string(name) + (binary ? " binary" : " text"));
      MeshData expected = mesh;
      expected.model = {};
      test::expect_same(test::written_and_read(name, mesh, binary).mesh, expected);
    }
  }
}

TEST(Volumes, BeamOfHexahedra) {
  READ_SHARED(r, "beam_hex.vtk");
  EXPECT_EQ(r.format, io::Format::Vtk);
  EXPECT_EQ(r.mesh.positions.size(), 36u);
  EXPECT_EQ(count(r.mesh.regions, Shape::Hexahedron), 8u);
  EXPECT_EQ(r.mesh.regions.size(), 8u);
  EXPECT_EQ(signs(r.mesh)[Shape::Hexahedron].positive, 8);
  EXPECT_EQ(r.mesh.regions.classes.front(), ModelRef(3, 1));
  EXPECT_EQ(r.mesh.regions.classes.back(), ModelRef(3, 2));
  EXPECT_TRUE(r.mesh.attributes.empty());
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, WedgesOfVtkBecomePrismsOfPositiveVolume) {
  READ_SHARED(r, "beam_wedge.vtk");
  EXPECT_EQ(r.mesh.positions.size(), 27u);
  EXPECT_EQ(count(r.mesh.regions, Shape::Prism), 8u);
  EXPECT_EQ(signs(r.mesh)[Shape::Prism].positive, 8);
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, BrickOfPrisms) {
  READ_SHARED(r, "brick_prism.vtk");
  EXPECT_EQ(r.mesh.positions.size(), 16800u);
  EXPECT_EQ(r.mesh.regions.size(), 29640u);
  EXPECT_EQ(count(r.mesh.regions, Shape::Prism), 29640u);
  EXPECT_EQ(signs(r.mesh)[Shape::Prism].positive, 29640);
  expect_vtk_round_trips(r.mesh);
}

const char* const knowles_note = "2624 pyramids and 3680 hexahedra listed inside out renumbered";

/// The file's own hexahedra are inside out, and so are two thirds of its pyramids: SU2 turns them
/// when it reads, and so do we.
void expect_knowles(const MeshData& mesh) {
  EXPECT_EQ(mesh.positions.size(), 9161u);
  EXPECT_EQ(mesh.regions.size(), 3936u + 4128 + 3680);
  EXPECT_EQ(count(mesh.regions, Shape::Pyramid), 3936u);
  EXPECT_EQ(count(mesh.regions, Shape::Prism), 4128u);
  EXPECT_EQ(count(mesh.regions, Shape::Hexahedron), 3680u);
  std::map<Shape, Signs> s = signs(mesh);
  EXPECT_EQ(s[Shape::Prism].positive, 4128);
  EXPECT_EQ(s[Shape::Hexahedron].positive, 3680);
  EXPECT_EQ(s[Shape::Pyramid].positive, 3936);
}

TEST(Volumes, MixedCells) {
  READ_SHARED(r, "mixed_knowles.vtk");
  expect_knowles(r.mesh);
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, MixedCellsWithMarkers) {
  READ_SHARED(r, "mixed_knowles.su2");
  EXPECT_EQ(r.format, io::Format::Su2);
  expect_knowles(r.mesh);
  EXPECT_EQ(count(r.mesh.faces, Shape::Quad), 160u);
  EXPECT_EQ(std::count(r.mesh.faces.classes.begin(), r.mesh.faces.classes.end(), ModelRef(2, 1)),
            80);
  EXPECT_EQ(std::count(r.mesh.faces.classes.begin(), r.mesh.faces.classes.end(), ModelRef(2, 2)),
            80);
  ASSERT_EQ(r.mesh.model.groups.size(), 2u);
  EXPECT_EQ(r.mesh.model.groups[0], (PhysicalGroup{2, 1, "clamped"}));
  EXPECT_EQ(r.mesh.model.groups[1], (PhysicalGroup{2, 2, "load"}));
  EXPECT_EQ(r.notes, (std::vector<std::string>{knowles_note}));
  test::expect_same(test::written_and_read("a.su2", r.mesh).mesh, r.mesh);
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, TheSameMeshFromSu2AndVtk) {
  READ_SHARED(a, "mixed_knowles.su2");
  READ_SHARED(b, "mixed_knowles.vtk");
  EXPECT_EQ(a.mesh.regions.shapes, b.mesh.regions.shapes);
  EXPECT_EQ(a.mesh.regions.vertices, b.mesh.regions.vertices);
}

TEST(Volumes, HandOfTetrahedra) {
  READ_SHARED(r, "hand.mesh");
  EXPECT_EQ(r.format, io::Format::Medit);
  EXPECT_EQ(r.mesh.positions.size(), 7234u);
  EXPECT_EQ(count(r.mesh.faces, Shape::Triangle), 9556u);
  EXPECT_EQ(count(r.mesh.regions, Shape::Tetrahedron), 29998u);
  EXPECT_TRUE(r.mesh.edges.empty());
  EXPECT_FALSE(r.mesh.classified());  // all references are 0
  EXPECT_EQ(signs(r.mesh)[Shape::Tetrahedron].negative, 0);
  test::expect_same(test::written_and_read("a.mesh", r.mesh).mesh, r.mesh);
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, BoxWithCornersAndRidges) {
  READ_SHARED(r, "tiny_box_t.mesh");
  EXPECT_EQ(r.mesh.positions.size(), 11866u);
  EXPECT_EQ(r.mesh.faces.size(), 5056u);
  EXPECT_EQ(count(r.mesh.regions, Shape::Tetrahedron), 63434u);
  EXPECT_EQ(r.mesh.edges.size(), 233u);
  EXPECT_EQ(signs(r.mesh)[Shape::Tetrahedron].negative, 0);
  const auto on = [&](int d) {
    return std::count_if(r.mesh.vertex_classes.begin(), r.mesh.vertex_classes.end(),
                         [&](ModelRef m) { return m.dimension() == d; });
  };
  EXPECT_EQ(on(0), 8);
  EXPECT_EQ(on(7), 0);
  double required = 0, ridges = 0;
  for (const Attribute& a : r.mesh.attributes) {
    for (const double x : a.values) {
      if (a.name == "medit:required" && a.dimension == 0) required += x;
      if (a.name == "medit:ridge") ridges += x;
    }
  }
  EXPECT_EQ(required, 8);
  EXPECT_EQ(ridges, 233);
  test::expect_same(test::written_and_read("a.mesh", r.mesh).mesh, r.mesh);
  expect_vtk_round_trips(r.mesh);
}

TEST(Volumes, SurfaceOfSeveralMaterials) {
  READ_SHARED(r, "multi_mat_surface.mesh");
  EXPECT_EQ(r.mesh.positions.size(), 3664u);
  EXPECT_EQ(count(r.mesh.faces, Shape::Triangle), 7094u);
  EXPECT_EQ(r.mesh.edges.size(), 400u);
  EXPECT_TRUE(r.mesh.regions.empty());
  EXPECT_EQ(std::count_if(r.mesh.vertex_classes.begin(), r.mesh.vertex_classes.end(),
                          [](ModelRef m) { return m.dimension() == 0; }),
            16);
  test::expect_same(test::written_and_read("a.mesh", r.mesh).mesh, r.mesh);
  test::expect_same(test::written_and_read("a.ply", r.mesh).mesh, r.mesh);
  expect_vtk_round_trips(r.mesh);
}

/// What Medit holds: vertices get the class of their lowest entity, corners are numbered.
TEST(Volumes, OneOfEachThroughEveryFormat) {
  const MeshData mesh = test::one_of_each();
  test::for_each_corner_volume(
      mesh, [](Shape shape, double volume) { EXPECT_GT(volume, 0) << shape_template(shape).name; });
  expect_vtk_round_trips(mesh);
  test::expect_same(test::written_and_read("a.mesh", mesh).mesh, mesh);
  test::expect_same(test::written_and_read("a.meshb", mesh).mesh, mesh);

  MeshData faces_only = mesh;  // SU2: markers, without edges, vertex classes and classes of regions
  faces_only.edges = {};
  faces_only.vertex_classes.clear();
  faces_only.regions.classes.clear();
  faces_only.model.groups = {{2, 1, "marker_1"}, {2, 2, "marker_2"}};
  faces_only.model.entities = {{ModelRef(2, 1), {1}, {}, {}}, {ModelRef(2, 2), {2}, {}, {}}};
  test::expect_same(test::written_and_read("a.su2", mesh).mesh, faces_only);
}

/// Every shape, in every format: what is listed inside out comes back right.
TEST(Volumes, RegionsListedInsideOutAreRenumbered) {
  MeshData right = make_sample("mixed", 2);
  right.edges = right.faces = {};
  right.vertex_classes.clear();
  right.regions.classes.clear();
  right.model = {};
  MeshData listed = right;
  std::vector<std::uint32_t> odd;
  std::size_t first = 0;
  for (std::uint32_t r = 0; r < right.regions.size(); ++r) {
    const auto n = static_cast<std::size_t>(shape_template(right.regions.shapes[r]).vertex_count);
    std::uint32_t* const v = &listed.regions.vertices[first];
    first += n;
    if (r % 3 != 0) continue;
    odd.push_back(r);
    for (const std::size_t base : {std::size_t{0}, n / 2}) {
      const bool quads = n == 5 || n == 8;
      if (base == 0 || n >= 6) std::swap(v[base + 1], v[base + (quads ? 3 : 2)]);
    }
  }
  for (const char* name : {"a.msh", "a.mesh", "a.meshb", "a.vtk", "a.vtu", "a.su2"})
    for (const bool binary : {false, true}) {
      SCOPED_TRACE(std::string(name) + (binary ? " binary" : " text"));
      const MeshData expected = test::written_and_read(name, right, binary).mesh;
      const io::ReadResult read = test::written_and_read(name, listed, binary);
      test::expect_same(read.mesh, expected);
      EXPECT_EQ(read.turned.size(), odd.size());
      ASSERT_EQ(read.notes.size(), 1u);
      EXPECT_TRUE(read.notes[0].ends_with(" listed inside out renumbered")) << read.notes[0];
    }
  EXPECT_EQ(test::written_and_read("a.vtu", listed).turned, odd);
}

TEST(Volumes, AttributesOfSomeDimensionsOnly) {
  MeshData mesh = test::one_of_each();
  mesh.attributes = {{"p", 0, 3, false, std::vector<double>(36, 0.1)},
                     {"only edges", 1, 1, true, {1, 0}},
                     {"both", 1, 2, false, {1.5, 2, 3, 4}},
                     {"large", 2, 1, true, {0, 1e15}},
                     {"both", 3, 2, false, {1, 2, 3, 4, 5, 6, 7, 1.0 / 3}}};
  expect_vtk_round_trips(mesh);
}

/// Without classes, an array that would classify stays an attribute.
TEST(Volumes, ArraysNamedLikeClassesSurvive) {
  MeshData mesh = test::one_of_each();
  mesh.vertex_classes.clear();
  for (int d = 1; d <= 3; ++d) mesh.list(d).classes.clear();
  mesh.attributes = {{"material", 3, 1, true, {1, 1, 2, 3}}};
  expect_vtk_round_trips(mesh);
}

TEST(Volumes, SurfaceFormatsRefuseRegions) {
  const test::TemporaryFolder folder;
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl"}) {
    EXPECT_THROW(io::write(folder / name, test::one_of_each()), io::WriteError) << name;
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Volumes, Su2RefusesSurfacesInSpace) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  const test::TemporaryFolder folder;
  EXPECT_THROW(io::write(folder / "a.su2", mesh), io::WriteError);
  mesh.positions[2].z = 0;
  test::expect_same(test::written_and_read("a.su2", mesh).mesh, mesh);
}

/// Quads go out as quads where the format has them; surface formats read them back as triangles.
TEST(Volumes, SurfaceFormatsWriteQuads) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.faces.add(Shape::Quad, {0, 1, 2, 3});
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : {std::pair{"a.obj", "f 1 2 3 4\n"}, {"a.off", "4 0 1 2 3\n"}}) {
    io::write(folder / name, mesh);
    EXPECT_NE(test::bytes_of(folder / name).find(text), std::string::npos) << name;
  }
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl"}) {
    for (const bool binary : {false, true}) {
      const MeshData again = test::written_and_read(name, mesh, binary).mesh;
      EXPECT_EQ(again.positions.size(), 4u) << name;
      EXPECT_EQ(again.faces.shapes, std::vector<Shape>(2, Shape::Triangle)) << name;
    }
  }
  for (const char* name : {"a.vtk", "a.vtu", "a.mesh", "a.meshb", "a.su2"})
    EXPECT_TRUE(test::written_and_read(name, mesh).mesh == mesh) << name;
}

TEST(Volumes, ContentDecides) {
  const auto format = [](const char* bytes) { return io::read_bytes("unnamed", bytes).format; };
  EXPECT_EQ(format("MeshVersionFormatted 2 Dimension 3 Vertices 0 End"), io::Format::Medit);
  EXPECT_EQ(format("# comment\nmeshversionformatted\n2\nDimension\n2\nVertices\n0\n"),
            io::Format::Medit);
  EXPECT_EQ(format("% comment\nNDIME= 2\nNELEM= 0\nNPOIN= 0\n"), io::Format::Su2);
  EXPECT_EQ(format("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n"),
            io::Format::Vtk);
  EXPECT_EQ(format("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid/></VTKFile>"),
            io::Format::Vtu);
  test::expect_error("a.meshb", std::string("\1\0\0\0\5\0\0\0", 8), {"byte 4", "version 5"});
  test::expect_error("a.mesh", "MFEM mesh v1.0\n", {"a.mesh:1: ", "\"MFEM\""});
}

}  // namespace
}  // namespace aomd::io_volume_test
