// A VTU file that is gone through piece by piece is the surface that a whole reader reads, and a
// PVTU names tiles.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/io/base64.h"
#include "core/io/io.h"
#include "core/io/streamed_surface.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::streamed_vtu_test {
namespace {

using io::StreamedSurface;

template <typename Value>
std::string raw(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

template <typename Count>
std::string with_size(const std::string& bytes) {
  return raw(std::vector<Count>{static_cast<Count>(bytes.size())}) + bytes;
}

/// A file as VTK writes it: base64 in the elements, the sizes encoded apart.
struct VtuText {
  std::string root = R"(type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt32")";
  std::string counts = R"(NumberOfPoints="4" NumberOfCells="2")";
  std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  std::vector<std::int32_t> corners{0, 1, 2, 1, 3, 2}, ends{3, 6};
  std::vector<std::uint8_t> types{5, 5};
  std::string point_data, cell_data;

  template <typename Value>
  static std::string array(const char* type, const char* name, const std::vector<Value>& values,
                           int components = 1, const char* format = "binary") {
    const std::string bytes = raw(values);
    return std::string("<!-- a > \"b --><DataArray type=\"") + type + "\" Name=\"" + name +
           "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"" + format +
           "\">\n  " +
           io::detail::to_base64(raw(std::vector{static_cast<std::uint32_t>(bytes.size())})) +
           io::detail::to_base64(bytes) + "\n</DataArray>\n";
  }

  [[nodiscard]] std::string text() const {
    return "<?xml version=\"1.0\"?>\n<VTKFile " + root + ">\n<UnstructuredGrid>\n<Piece " + counts +
           ">\n<PointData Scalars=\"a>b\">" + point_data + "</PointData><CellData>" + cell_data +
           "</CellData>\n<Points>" + array("Float32", "Points", points, 3) + "</Points><Cells>" +
           array("Int32", "connectivity", corners) + array("Int32", "offsets", ends) +
           array("UInt8", "types", types) + "</Cells></Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }
};

class StreamedVtuTest : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& bytes, const char* name = "a.vtu") const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  static void expect_as_read(const std::filesystem::path& path) {
    MeshData whole = io::read(path).mesh;
    const StreamedSurface surface(path);
    EXPECT_EQ(surface.vertices(), whole.positions.size());
    EXPECT_EQ(surface.faces(), whole.faces.size());
    const StreamedSurface::Part part = surface.part([](const auto&) { return true; });
    whole.vertex_classes.clear();
    whole.faces.classes.clear();
    EXPECT_TRUE(part.mesh == whole);
  }

  template <typename Error = io::ReadError>
  void expect_refused(const std::string& bytes, const std::string& fragment,
                      const char* name = "a.vtu") const {
    try {
      const StreamedSurface surface(put(bytes, name));
      surface.each_vertices([](auto, auto) {});
      surface.each_faces([](auto, auto) {});
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  }

  test::TemporaryFolder folder_;
};

/// A mesh with arrays of several types.
MeshData with_arrays(MeshData mesh) {
  Attribute red{.name = "rgb",
                .components = 3,
                .integer = true,
                .values = {},
                .type = NumberType::UInt8,
                .meaning = Meaning::Colour};
  Attribute heat{.name = "heat", .values = {}, .type = NumberType::Float64};
  Attribute part{
      .name = "part", .dimension = 2, .integer = true, .values = {}, .type = NumberType::Int16};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    heat.values.push_back(double(v) / 7);
    for (const std::size_t k : {1u, 2u, 3u}) red.values.push_back(double(k * v % 256));
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) part.values.push_back(double(f % 100) - 50);
  mesh.attributes = {red, heat, part};
  return mesh;
}

// More than one piece.
TEST_F(StreamedVtuTest, IsWhatAWholeReaderReads) {
  io::WriteOptions how;
  how.binary = true;
  io::write(folder_ / "a.vtu", with_arrays(make_sample("scan", 80'000)), how);
  expect_as_read(folder_ / "a.vtu");
}

TEST_F(StreamedVtuTest, ReadsWhatStandsInElements) {
  VtuText vtu;
  vtu.point_data = VtuText::array<double>("Float64", "a&gt;b", {1, 2, 3, 4}) +
                   VtuText::array<std::uint8_t>("UInt8", "c", std::vector<std::uint8_t>(12, 9), 3);
  vtu.cell_data = VtuText::array<std::int16_t>("Int16", "part", {-7, 8});
  expect_as_read(put(vtu.text()));
  MeshData mesh =
      StreamedSurface(folder_ / "a.vtu").part([](const auto& t) { return t[0] == 1; }).mesh;
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  ASSERT_EQ(mesh.attributes.size(), 3u);
  EXPECT_EQ(mesh.attributes[0].values, (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(mesh.attributes[0].meaning, Meaning::Scalars);
  EXPECT_EQ(mesh.attributes[1].meaning, Meaning::Colour);
  EXPECT_EQ(mesh.attributes[2].values, (std::vector<double>{8}));
}

TEST_F(StreamedVtuTest, ReadsAppendedBase64AndTheOtherByteOrder) {
  for (const bool wide : {false, true}) {
    std::string data;
    const auto array = [&](const char* type, const char* name, const std::string& bytes, int n) {
      const std::string offset = std::to_string(data.size());
      data += io::detail::to_base64(wide ? with_size<std::uint64_t>(bytes)
                                         : with_size<std::uint32_t>(bytes));
      return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
             "\" NumberOfComponents=\"" + std::to_string(n) + "\" format=\"appended\" offset=\"" +
             offset + "\"/>";
    };
    const VtuText vtu;
    std::string text = "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"";
    text += wide ? " header_type=\"UInt64\">" : ">";
    text += "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\"><Points>" +
            array("Float32", "p", raw(vtu.points), 3) + "</Points><Cells>" +
            array("Int32", "connectivity", raw(vtu.corners), 1) +
            array("Int32", "offsets", raw(vtu.ends), 1) +
            array("UInt8", "types", raw(vtu.types), 1) +
            "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"base64\">\n  _";
    expect_as_read(put(text + data + "</AppendedData></VTKFile>"));
  }
  VtuText big;
  big.root = R"(type="UnstructuredGrid" byte_order="BigEndian")";
  expect_refused(big.text(), "the data end early");
}

TEST_F(StreamedVtuTest, SaysWhatIsWrong) {
  const auto refused = [&](const std::string& fragment, const auto& change) {
    VtuText vtu;
    change(vtu);
    expect_refused(vtu.text(), fragment);
  };
  refused("cell 1 of type 9 (quad) cannot be read in blocks", [](VtuText& v) { v.types[1] = 9; });
  refused("cell 1: a triangle of other than 3", [](VtuText& v) { v.ends[1] = 7; });
  refused("cell 1: there is no vertex 4", [](VtuText& v) { v.corners[4] = 4; });
  refused("cell 0: there is no vertex -1", [](VtuText& v) { v.corners[0] = -1; });
  refused("only triangles can be read in blocks", [](VtuText& v) { v.corners.push_back(0); });
  refused("a coordinate of point 2 is not a finite number",
          [](VtuText& v) { v.points[7] = std::numeric_limits<float>::infinity(); });
  refused("array \"Points\" has 48 bytes for 400000000 times 12",
          [](VtuText& v) { v.counts = R"(NumberOfPoints="400000000" NumberOfCells="2")"; });
  refused("compressed by \"vtkLZ4DataCompressor\"; only vtkZLibDataCompressor is read: save it",
          [](VtuText& v) { v.root += R"( compressor="vtkLZ4DataCompressor")"; });
  refused("a VTK file of type \"PolyData\"", [](VtuText& v) { v.root = R"(type="PolyData")"; });
  refused("has no vertices or no faces",
          [](VtuText& v) { v.counts = R"(NumberOfPoints="0" NumberOfCells="0")"; });
  refused("not base64: \"!\"", [](VtuText& v) {
    v.cell_data = "<DataArray type=\"Int8\" Name=\"a\" format=\"binary\">AA!A</DataArray>";
  });
  refused("VTU as text", [](VtuText& v) {
    v.cell_data = "<DataArray type=\"Int8\" Name=\"a\" format=\"ascii\">1 2</DataArray>";
  });
  std::string text = VtuText().text();
  expect_refused(text.substr(0, text.size() / 2), "XML");
  text.insert(
      text.find("</UnstructuredGrid>"),
      text.substr(text.find("<Piece"), text.find("</UnstructuredGrid>") - text.find("<Piece")));
  expect_refused(text, "a VTU file of several pieces");
  io::WriteOptions how;
  how.binary = true;
  io::write(folder_ / "b.vtu", make_sample("torus", 20), how);
  std::ifstream file(folder_ / "b.vtu", std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(file), {});
  expect_refused(whole.substr(0, whole.size() - 1000), "the data end early");
}

TEST_F(StreamedVtuTest, NamesWhatIsLeftOut) {
  VtuText vtu;
  vtu.point_data = "<DataArray type=\"String\" Name=\"words\" format=\"ascii\">1</DataArray>";
  vtu.cell_data = VtuText::array<std::int32_t>("Int32", "model_dimension", {2, 2}) +
                  VtuText::array<std::int32_t>("Int32", "model_tag", {1, 1});
  EXPECT_EQ(StreamedSurface(put(vtu.text())).left_out(),
            (std::vector<std::string>{"vertex \"words\"", "cell \"model_dimension\"",
                                      "cell \"model_tag\""}));
}

std::string pvtu_of(const std::vector<std::string>& pieces, const std::string& more = {}) {
  std::string text = "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid " + more + ">";
  for (const std::string& piece : pieces) text += "<Piece Source=\"" + piece + "\"/>";
  return text + "</PUnstructuredGrid></VTKFile>\n";
}

TEST_F(StreamedVtuTest, APvtuNamesTilesInItsOrder) {
  VtuText left, right, none;
  for (std::size_t k = 0; k < right.points.size(); k += 3) right.points[k] -= 1;
  none.counts = R"(NumberOfPoints="0" NumberOfCells="0")";
  std::filesystem::create_directory(folder_ / "p");
  put(left.text(), "z.vtu");
  put(none.text(), "p/b.vtu");
  put(right.text(), "p/a.vtu");
  const StreamedSurface surface(put(pvtu_of({"z.vtu", "p/b.vtu", "p/a.vtu"}), "a.pvtu"));
  EXPECT_EQ(surface.vertices(), 8u);
  const MeshData mesh = surface.part([](const auto&) { return true; }).mesh;
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.positions[3], (glm::dvec3{1, 1, 0}));
  EXPECT_EQ(mesh.positions[4], (glm::dvec3{-1, 0, 0}));
}

TEST_F(StreamedVtuTest, SaysWhatIsWrongWithAPvtu) {
  put(VtuText().text(), "a.vtu");
  expect_refused(pvtu_of({"a.vtu", "b.vtu"}), "b.vtu: is no file", "a.pvtu");
  expect_refused(pvtu_of({"./a.pvtu"}), ":1: names itself as a piece", "a.pvtu");
  put(pvtu_of({"a.vtu"}), "c.pvtu");
  expect_refused(pvtu_of({"c.pvtu"}), "type \"PUnstructuredGrid\"; only", "a.pvtu");
  expect_refused(pvtu_of({}), "names no pieces", "a.pvtu");
  expect_refused(pvtu_of({""}), "a piece without a Source", "a.pvtu");
  expect_refused(pvtu_of({"a.vtu"}, "GhostLevel=\"1\""), "has ghost cells", "a.pvtu");
  expect_refused(VtuText().text(), "has no element PUnstructuredGrid", "a.pvtu");
  VtuText other;
  other.cell_data = VtuText::array<std::int16_t>("Int16", "part", {-7, 8});
  put(other.text(), "b.vtu");
  expect_refused(pvtu_of({"a.vtu", "b.vtu"}), "b.vtu: has other properties than", "a.pvtu");
}

}  // namespace
}  // namespace aomd::streamed_vtu_test
