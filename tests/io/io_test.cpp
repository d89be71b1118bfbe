#include "core/io/io.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <set>

#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/surface_facts.h"

namespace aomd::io_test {
namespace {

using test::same_mesh;
using test::TemporaryFolder;

std::string read_error(const std::filesystem::path& path) {
  try {
    (void)io::read(path);
    return "";
  } catch (const io::ReadError& error) {
    return error.what();
  }
}

void expect_message(const std::string& message, const char* fragment) {
  EXPECT_NE(message.find(fragment), std::string::npos) << message;
}

TEST(Read, SaysWhatIsWrongWithTheFile) {
  const TemporaryFolder folder;
  expect_message(read_error(folder / "none.ply"), "none.ply: cannot be opened: No such file");
  std::filesystem::create_directory(folder / "d.ply");
  expect_message(read_error(folder / "d.ply"), "is a folder");
  io::write_file(folder / "empty.ply", "");
  expect_message(read_error(folder / "empty.ply"), "is empty");
  ASSERT_EQ(::mkfifo((folder / "pipe.ply").c_str(), 0600), 0);
  expect_message(read_error(folder / "pipe.ply"), "not a regular file");
  io::write_file(folder / "text.xyz", "hello\n");
  expect_message(read_error(folder / "text.xyz"), "no format that is known");
  if (::geteuid() != 0) {
    io::write_file(folder / "secret.ply", "ply\n");
    std::filesystem::permissions(folder / "secret.ply", std::filesystem::perms::none);
    expect_message(read_error(folder / "secret.ply"), "Permission denied");
  }
}

TEST(Read, ContentGoesBeforeTheExtension) {
  const io::ReadResult result =
      io::read_bytes("a.ply", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(result.format, io::Format::Off);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0], "read as .off, which is what the content is");
  EXPECT_EQ(io::read_bytes("a", "# c\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").format,
            io::Format::Obj);
}

TEST(Read, AByteOrderMarkMeansNothing) {
  const TemporaryFolder folder;
  const MeshData box = make_sample("box", 1), ball = make_sample("tet-ball", 1);
  for (const bool binary : {false, true}) {
    for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl", "a.msh", "a.mesh", "a.vtk",
                             "a.vtu", "b.msh", "b.mesh", "b.vtk", "b.vtu", "b.su2"}) {
      io::write(folder / name, name[0] == 'a' ? box : ball, {.binary = binary});
      const std::string bytes = test::bytes_of(folder / name);
      if (binary && name == std::string("a.stl")) continue;  // no text anywhere
      const io::ReadResult plain = io::read_bytes(name, bytes);
      for (const char* other : {name, "no_extension"}) {
        const io::ReadResult marked = io::read_bytes(other, "\xef\xbb\xbf" + bytes);
        EXPECT_TRUE(same_mesh(marked.mesh, plain.mesh)) << other << binary;
        EXPECT_EQ(marked.notes, plain.notes) << other << binary;
      }
    }
  }
  test::expect_error("a.ply", "\xef\xbb\xbf", {"a.ply: is empty"});
}

TEST(Read, BytesCountFromTheStartOfTheFile) {
  const std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n";
  const auto byte = [](std::size_t n) { return "byte " + std::to_string(n) + ":"; };
  test::expect_error("a.ply", bytes + "1234", {byte(bytes.size() + 4).c_str()});
  test::expect_error("a.ply", "\xef\xbb\xbf" + bytes + "1234", {byte(bytes.size() + 7).c_str()});
}

struct RoundTrip {
  const char* name;
  std::optional<bool> binary;
};

/// Classification of faces alone, as OBJ and STL carry it.
MeshData faces_only(MeshData mesh) {
  mesh.vertex_classes.clear();
  mesh.edges = {};
  return mesh;
}

TEST(RoundTrip, PlyKeepsEverything) {
  const TemporaryFolder folder;
  for (const SampleInfo& info : samples()) {
    if (info.dimension == 3) continue;  // these formats hold surfaces
    const MeshData mesh = make_sample(info.name);
    for (const bool binary : {false, true}) {
      io::write(folder / "a.ply", mesh, {.binary = binary});
      EXPECT_TRUE(same_mesh(io::read(folder / "a.ply").mesh, mesh)) << info.name << binary;
    }
  }
}

TEST(RoundTrip, ObjKeepsVerticesEdgesAndTheClassesOfFaces) {
  const TemporaryFolder folder;
  for (const SampleInfo& info : samples()) {
    if (info.dimension == 3) continue;  // these formats hold surfaces
    MeshData mesh = make_sample(info.name);
    io::write(folder / "a.obj", mesh);
    mesh.vertex_classes.clear();
    mesh.edges.classes.clear();
    EXPECT_TRUE(same_mesh(io::read(folder / "a.obj").mesh, mesh)) << info.name;
  }
}

TEST(RoundTrip, OffKeepsVerticesAndFaces) {
  const TemporaryFolder folder;
  for (const SampleInfo& info : samples()) {
    if (info.dimension == 3) continue;  // these formats hold surfaces
    MeshData mesh = faces_only(make_sample(info.name));
    mesh.faces.classes.clear();
    io::write(folder / "a.off", mesh);
    EXPECT_TRUE(same_mesh(io::read(folder / "a.off").mesh, mesh)) << info.name;
  }
  MeshData floats = make_sample("scan", 500);  // its coordinates are 32-bit floats
  io::write(folder / "b.off", floats, {.binary = true});
  EXPECT_TRUE(same_mesh(io::read(folder / "b.off").mesh, floats));
}

/// Each face by its corners' coordinates and its class; STL knows no more, and sorts by class.
std::multiset<std::array<double, 10>> soup(const MeshData& mesh) {
  std::multiset<std::array<double, 10>> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::array<double, 10> face{};
    for (std::size_t i = 0; i < 9; ++i) {
      face[i] = mesh.positions[mesh.faces.vertices[3 * f + i / 3]][static_cast<int>(i % 3)];
    }
    face[9] = mesh.faces.classes.empty() ? -1 : mesh.faces.classes[f].tag();
    faces.insert(face);
  }
  return faces;
}

TEST(RoundTrip, StlTextKeepsFacesAndTheirClasses) {
  const TemporaryFolder folder;
  for (const SampleInfo& info : samples()) {
    if (info.dimension == 3) continue;  // these formats hold surfaces
    const MeshData mesh = make_sample(info.name);
    io::write(folder / "a.stl", mesh, {.binary = false});
    const MeshData back = io::read(folder / "a.stl").mesh;
    EXPECT_EQ(back.positions.size(), mesh.positions.size()) << info.name;
    EXPECT_EQ(soup(back), soup(mesh)) << info.name;
    io::write(folder / "b.stl", mesh);
    EXPECT_EQ(io::read(folder / "b.stl").mesh.faces.classes.empty(), mesh.faces.classes.empty())
        << "by default";
  }
}

TEST(RoundTrip, StlBinaryKeepsFloats) {
  const TemporaryFolder folder;
  const MeshData mesh = make_sample("scan", 2000);
  io::write(folder / "a.stl", mesh, {.binary = true});
  EXPECT_EQ(soup(io::read(folder / "a.stl").mesh), soup(mesh));
  EXPECT_EQ(std::filesystem::file_size(folder / "a.stl"), 84 + 50 * mesh.faces.size());
}

/// A single coordinate that is no float makes the file hold doubles, whichever axis it is on.
TEST(RoundTrip, BinaryPlyWidensOnlyWhenItMust) {
  const TemporaryFolder folder;
  for (int axis = 0; axis < 4; ++axis) {
    MeshData mesh = make_sample("scan", 500);
    if (axis < 3) mesh.positions[77][axis] = 0.1;
    io::write(folder / "a.ply", mesh);
    EXPECT_EQ(test::bytes_of(folder / "a.ply").find("property double") != std::string::npos,
              axis < 3);
    EXPECT_TRUE(same_mesh(io::read(folder / "a.ply").mesh, mesh));
  }
}

TEST(RoundTrip, HardNumbersComeBack) {
  const TemporaryFolder folder;
  MeshData mesh;
  mesh.positions = {{0.1, 1.0 / 3, -0.0},
                    {5e-324, 1.7976931348623157e308, -2.2250738585072014e-308},
                    {1e22, 123456789012345678.0, 1e-7}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  for (const RoundTrip& r : {RoundTrip{"a.obj", {}},
                             {"a.off", {}},
                             {"a.ply", true},
                             {"a.ply", false},
                             {"a.stl", false}}) {
    io::write(folder / r.name, mesh, {.binary = r.binary});
    const MeshData back = io::read(folder / r.name).mesh;
    EXPECT_EQ(back.positions, mesh.positions) << r.name;
    EXPECT_TRUE(std::signbit(back.positions[0].z)) << r.name;
  }
}

TEST(RoundTrip, QuadsAreWrittenAsQuads) {
  const TemporaryFolder folder;
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.faces.add(Shape::Quad, {0, 1, 2, 3});
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl"}) {
    io::write(folder / name, mesh);
    const io::ReadResult back = io::read(folder / name);
    EXPECT_EQ(back.mesh.faces.size(), 2u) << name;
    EXPECT_EQ(back.notes.empty(), false) << name;
  }
}

struct SharedFile {
  const char* name;
  std::size_t vertices, faces;
  std::size_t model_faces = 0;
};

TEST(SharedData, EverySurfaceReads) {
  const std::filesystem::path folder(AOMD_SHARED_DATA);
  if (!std::filesystem::exists(folder / "truck.obj"))
    GTEST_SKIP() << "not all models in " << folder;
  constexpr SharedFile files[] = {{"beetle.obj", 1148, 2053},
                                  {"blobby_3cc.off", 1820, 3417},
                                  {"bunny.ply", 35947, 69451},
                                  {"cheese.off", 8629, 17786},
                                  {"dragon.ply", 100250, 202520},
                                  {"dragon_full.ply", 437645, 871414},
                                  {"dtc_hull.stl", 58033, 116062},
                                  {"elephant_with_holes.off", 2798, 4463},
                                  {"fandisk.off", 6475, 12946},
                                  {"fandisk_quads.off", 766, 2 * 764},
                                  {"featuretype.stl", 2010, 3476},
                                  {"fixed_top.ply", 2374, 4772},
                                  {"flange_4solids.stl", 3228, 6468, 4},
                                  {"rocker_arm.obj", 10044, 20088},
                                  {"self_intersect.obj", 8582, 17160},
                                  {"tray_bottom.stl", 2216, 4520},
                                  {"truck.obj", 2956, 4770},
                                  {"turbine.off", 9210, 18460}};
  for (const SharedFile& file : files) {
    const MeshData mesh = io::read(folder / file.name).mesh;
    EXPECT_EQ(mesh.positions.size(), file.vertices) << file.name;
    EXPECT_EQ(mesh.faces.size(), file.faces) << file.name;
    EXPECT_EQ(test::tags_of(mesh.faces.classes, 2).size(), file.model_faces) << file.name;
  }
}

TEST(SharedData, TopologyIsAsCounted) {
  const std::filesystem::path folder(AOMD_SHARED_DATA);
  if (!std::filesystem::exists(folder / "truck.obj"))
    GTEST_SKIP() << "not all models in " << folder;
  const test::SurfaceFacts bunny = test::facts_of(io::read(folder / "bunny.ply").mesh);
  EXPECT_EQ(bunny.boundary, 223u);
  EXPECT_EQ(bunny.unused, 1113u);
  EXPECT_EQ(bunny.euler, -3);
  const test::SurfaceFacts quads = test::facts_of(io::read(folder / "fandisk_quads.off").mesh);
  EXPECT_EQ(quads.boundary, 0u);
  EXPECT_EQ(quads.misoriented, 0u);
  EXPECT_EQ(quads.euler, 2);
}

TEST(SharedData, SurfacesSurviveARoundTrip) {
  const std::filesystem::path shared(AOMD_SHARED_DATA);
  if (!std::filesystem::exists(shared / "truck.obj"))
    GTEST_SKIP() << "not all models in " << shared;
  const TemporaryFolder folder;
  for (const char* name : {"bunny.ply", "beetle.obj", "cheese.off", "flange_4solids.stl"}) {
    const MeshData mesh = io::read(shared / name).mesh;
    for (const char* copy : {"a.ply", "a.obj"}) {
      io::write(folder / copy, mesh);
      EXPECT_TRUE(same_mesh(io::read(folder / copy).mesh, mesh)) << name << ' ' << copy;
    }
  }
}

}  // namespace
}  // namespace aomd::io_test
