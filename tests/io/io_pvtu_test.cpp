// Meshes in pieces, as PVTU: what is written reads back as the same mesh, whatever the number of
// pieces, and pieces of other programs are joined at their borders.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/io/io.h"
#include "core/io/streamed_surface.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::io_pvtu_test {
namespace {

class PvtuTest : public testing::Test {
 protected:
  static io::WriteOptions in_pieces(std::size_t pieces, bool binary = true) {
    io::WriteOptions how;
    how.pieces = pieces;
    how.binary = binary;
    return how;
  }
  [[nodiscard]] std::filesystem::path at(const std::string& name) const {
    return folder_ / name.c_str();
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& name, const std::string& bytes) const {
    std::ofstream(at(name), std::ios::binary) << bytes;
  }
  /// In all pieces, as if another program had written them.
  void replace(std::size_t pieces, const std::string& what, const std::string& by) const {
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::string name = "a_" + std::to_string(i) + ".vtu";
      std::string bytes = text(name);
      for (std::size_t k = 0; (k = bytes.find(what, k)) != std::string::npos; k += by.size())
        bytes.replace(k, what.size(), by);
      put(name, bytes);
    }
  }
  void expect_refused(const std::string& fragment) const {
    try {
      static_cast<void>(io::read(folder_ / "a.pvtu"));
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  }

  test::TemporaryFolder folder_;
};

MeshData classified(const char* sample, int size) {
  Mesh mesh(make_sample(sample, size));
  classify(mesh, {});
  MeshData data = to_data(mesh);
  Attribute heat{.name = "heat", .components = 2, .values = {}};
  for (const glm::dvec3& p : data.positions) {
    heat.values.push_back(p.x);
    heat.values.push_back(p.y - 1);
  }
  Attribute part{.name = "part", .dimension = 2, .integer = true, .values = {}};
  for (std::size_t f = 0; f < data.faces.size(); ++f) part.values.push_back(double(f));
  data.attributes.push_back(heat);
  data.attributes.push_back(part);
  return data;
}

// Edges on model edges, classes, arrays, in the order of the whole; more pieces than cells, too.
TEST_F(PvtuTest, ReadsBackAsTheSameMesh) {
  MeshData lone = make_sample("torus", 10);
  lone.positions.emplace_back(9, 9, 9);  // that nothing uses
  MeshData one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.faces.shapes = {Shape::Triangle};
  one.faces.vertices = {0, 1, 2};
  for (const MeshData& mesh : {classified("terrain", 12), classified("nonmanifold", 8),
                               make_sample("layered-beam", 1), lone, one}) {
    io::write(at("whole.vtu"), mesh);
    const MeshData whole = io::read(at("whole.vtu")).mesh;
    for (const std::size_t pieces : {1u, 2u, 7u})
      for (const bool binary : {false, true}) {
        io::write(at("a.pvtu"), mesh, in_pieces(pieces, binary));
        const io::ReadResult back = io::read(at("a.pvtu"));
        EXPECT_TRUE(back.mesh == whole) << pieces;
        EXPECT_EQ(back.format, io::Format::Pvtu);
        EXPECT_TRUE(back.notes.empty() || back.notes[0].find("piece") == std::string::npos);
      }
  }
}

TEST_F(PvtuTest, PiecesHaveEqualNumbersOfCellsAndShareTheirBorders) {
  const MeshData mesh = make_sample("scan", 4000);
  io::write(at("a.pvtu"), mesh, in_pieces(7));
  std::size_t faces = 0, vertices = 0;
  for (int i = 0; i < 7; ++i) {
    const MeshData piece = io::read(at("a_" + std::to_string(i) + ".vtu")).mesh;
    EXPECT_NEAR(double(piece.faces.size()), double(mesh.faces.size()) / 7, 1);
    faces += piece.faces.size();
    vertices += piece.positions.size();
    std::set<std::uint32_t> used(piece.faces.vertices.begin(), piece.faces.vertices.end());
    EXPECT_EQ(used.size(), piece.positions.size());
  }
  EXPECT_EQ(faces, mesh.faces.size());
  EXPECT_GT(vertices, mesh.positions.size());
  EXPECT_LT(vertices, mesh.positions.size() * 5 / 4);
  EXPECT_FALSE(std::filesystem::exists(at("a_7.vtu")));
}

// Without the arrays that say what is what: by where borders are.
TEST_F(PvtuTest, PiecesOfOthersAreJoinedAtTheirBorders) {
  for (const char* sample : {"torus", "layered-beam", "terrain"}) {
    const MeshData mesh = make_sample(sample, sample[0] == 'l' ? 1 : 20);
    io::write(at("a.pvtu"), mesh, in_pieces(5, false));
    replace(5, "GlobalPointIds", "pids");
    replace(5, "GlobalCellIds", "cids");
    const MeshData back = io::read(at("a.pvtu")).mesh;
    EXPECT_EQ(back.positions.size(), mesh.positions.size()) << sample;
    EXPECT_EQ(back.faces.size(), mesh.faces.size());
    EXPECT_EQ(back.regions.size(), mesh.regions.size());
    const auto sorted = [](std::vector<glm::dvec3> points) {
      std::sort(points.begin(), points.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
      });
      return points;
    };
    EXPECT_EQ(sorted(back.positions), sorted(mesh.positions)) << sample;
  }
}

/// Square faces of a sheet z = 0, in one piece, and another sheet that touches it.
std::string sheet(const std::string& points, std::size_t n, const std::string& corners,
                  std::size_t faces, const std::string& data = {}) {
  std::string ends, types;
  for (std::size_t i = 1; i <= faces; ++i) {
    ends += std::to_string(3 * i) + ' ';
    types += "5 ";
  }
  const auto array = [](const char* type, const char* name, const std::string& numbers) {
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
           "\" NumberOfComponents=\"" + (name[0] == 'P' ? "3" : "1") + "\" format=\"ascii\">" +
           numbers + "</DataArray>";
  };
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"" +
         std::to_string(n) + "\" NumberOfCells=\"" + std::to_string(faces) + "\"><PointData>" +
         data + "</PointData><Points>" + array("Float64", "Points", points) + "</Points><Cells>" +
         array("Int64", "connectivity", corners) + array("Int64", "offsets", ends) +
         array("UInt8", "types", types) + "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

std::string list(const std::vector<std::string>& pieces) {
  std::string text = "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid>";
  for (const std::string& piece : pieces) text += "<Piece Source=\"" + piece + "\"/>";
  return text + "</PUnstructuredGrid></VTKFile>";
}

// A vertex inside of a sheet is none of its border, whatever touches it; nor are two of one piece
// at one place told apart.
TEST_F(PvtuTest, JoinsBordersAlone) {
  const std::string fan = "0 0 0 1 0 0 0 1 0 -1 0 0 0 -1 0", around = "0 1 2 0 2 3 0 3 4 0 4 1";
  put("0.vtu", sheet(fan, 5, around, 4));
  put("1.vtu", sheet("0 0 0 1 0 0 1 0 1", 3, "0 1 2", 1));
  put("a.pvtu", list({"0.vtu", "1.vtu"}));
  EXPECT_EQ(io::read(at("a.pvtu")).mesh.positions.size(), 5u + 3u - 1u);
  EXPECT_EQ(io::read(at("a.pvtu")).mesh.faces.vertices[12], 5u);  // the inner one stays two
  put("1.vtu", sheet("1 0 0 2 0 0 2 0 1 1 0 0 3 0 0 3 0 1", 6, "0 1 2 3 4 5", 2));
  EXPECT_EQ(io::read(at("a.pvtu")).mesh.positions.size(), 11u);
}

TEST_F(PvtuTest, SaysWhatIsWrong) {
  const std::string good = sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 2", 1);
  put("0.vtu", good);
  put("a.pvtu", list({"0.vtu", "1.vtu"}));
  expect_refused("1.vtu");
  put("1.vtu", sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 3", 1));
  expect_refused("1.vtu:1: vertex index 3 is out of range");
  put("1.vtu", sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 0", 1));
  EXPECT_EQ(io::read(at("a.pvtu")).mesh.faces.size(), 1u);
  std::string other = good;
  other.replace(other.find(">5 <") + 1, 1, "99");
  put("1.vtu", other);
  expect_refused("1.vtu: cell 0: cells of type 99");
  const std::string heat =
      "<DataArray type=\"Float32\" Name=\"heat\" format=\"ascii\">1 2 3</DataArray>";
  put("1.vtu", sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 2", 1, heat));
  expect_refused("1.vtu: array \"heat\" is not in every piece");
  put("a.pvtu", list({"1.vtu", "0.vtu"}));
  expect_refused("0.vtu: array \"heat\" is not the same in every piece");
  const std::string ids = "<DataArray type=\"Int64\" Name=\"GlobalPointIds\" format=\"ascii\">";
  put("0.vtu", sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 2", 1, ids + "0 1 2</DataArray>"));
  put("1.vtu", sheet("0 0 0 1 0 0 0 1 0", 3, "0 1 2", 1, ids + "0 2 1</DataArray>"));
  expect_refused("a point of GlobalPointIds is at two places");
  put("a.pvtu", list({"a.pvtu"}));
  expect_refused("a.pvtu:1: names itself as a piece");
  put("b.pvtu", list({"0.vtu"}));
  put("a.pvtu", list({"b.pvtu"}));
  expect_refused("b.pvtu:1: a VTK file of type \"PUnstructuredGrid\"");
  put("a.pvtu", list({}));
  expect_refused("names no pieces");
}

TEST_F(PvtuTest, NeedsFilesBesideIt) {
  const MeshData mesh = make_sample("torus", 10);
  io::WriteOptions how = in_pieces(2);
  how.beside = false;
  EXPECT_THROW(static_cast<void>(io::to_bytes("a.pvtu", io::Format::Pvtu, mesh, how)),
               io::WriteError);
}

TEST_F(PvtuTest, SaysThatPiecesAreLeftFromBefore) {
  const MeshData mesh = make_sample("torus", 10);
  EXPECT_TRUE(io::write(at("a.pvtu"), mesh, in_pieces(3)).empty());
  EXPECT_TRUE(io::write(at("a.pvtu"), mesh, in_pieces(3)).empty());
  const auto notes = io::write(at("a.pvtu"), mesh, in_pieces(2));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "a_2.vtu is there from before, and does not belong to the mesh");
}

// What is written can be gone through in blocks.
TEST_F(PvtuTest, IsTilesOfASurface) {
  const MeshData mesh = make_sample("torus", 30);
  io::write(at("a.pvtu"), mesh, in_pieces(4));
  const io::StreamedSurface surface(at("a.pvtu"));
  const MeshData all = surface.part([](const auto&) { return true; }).mesh;
  EXPECT_EQ(all.positions.size(), mesh.positions.size());
  EXPECT_EQ(all.faces.size(), mesh.faces.size());
  EXPECT_TRUE(all.attributes.empty());
}

}  // namespace
}  // namespace aomd::io_pvtu_test
