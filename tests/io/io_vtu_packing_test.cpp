// VTU as other programs pack it: blocks of zlib, offsets, sizes that do not fit.

#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_blocks.h"
#include "tests/support/vtu_texts.h"

namespace aomd::io_vtu_packing_test {
namespace {

using test::Blocks;
using test::expect_error;
using test::Indices;
using test::raw;

template <class Word>
std::string packed(const std::string& bytes, std::size_t block, Blocks blocks) {
  const test::Packed result = test::packed_in_blocks<Word>(bytes, block, blocks);
  return result.head + result.data;
}

/// A strip of n quads as a file with appended raw data; `offset` writes an offset.
template <class Word, class Offset>
std::string strip(std::size_t n, std::size_t block, Blocks blocks, Offset&& offset) {
  std::string points, indices, ends, types, data;
  for (std::size_t i = 0; i <= n; ++i)
    for (const double y : {0.0, 1.0}) points += raw(double(i)) + raw(y) + raw(0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t v : {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1})
      indices += raw(std::int64_t(v));
    ends += raw(std::int64_t(4 * i + 4));
    types += '\x09';
  }
  const auto array = [&](const char* type, const char* name, const std::string& bytes) {
    const std::string at = offset(data.size());
    data += packed<Word>(bytes, block, blocks);
    return test::vtu_array(type, name,
                           "NumberOfComponents=\"" + std::string(*name ? "1" : "3") +
                               "\" format=\"appended\" offset=\"" + at + "\"",
                           "");
  };
  std::string piece = "<Piece NumberOfPoints=\" " + std::to_string(2 * n + 2) +
                      "\" NumberOfCells=\"" + std::to_string(n) + " \"><Points>" +
                      array("Float64", "", points) + "</Points><Cells>";
  piece += array("Int64", "connectivity", indices);
  piece += array("Int64", "offsets", ends);
  piece += array("UInt8", "types", types) + "</Cells></Piece>";
  return test::vtu_file(piece, sizeof(Word) == 4 ? test::zlib : test::zlib_wide,
                        "<AppendedData encoding=\"raw\">_" + data + "</AppendedData>");
}

TEST(VtuPacking, BlocksOfEveryWriter) {
  const auto plain = [](std::size_t at) { return std::to_string(at); };
  for (const std::size_t n : {1u, 2u, 3u, 7u, 100u}) {
    for (const Blocks blocks : {Blocks::Vtk, Blocks::Meshio}) {
      for (const std::size_t block : {32u, 48u, 1000u, 32768u, 1u << 22}) {
        for (const std::string& text : {strip<std::uint32_t>(n, block, blocks, plain),
                                        strip<std::uint64_t>(n, block, blocks, plain)}) {
          SCOPED_TRACE(std::to_string(n) + " quads, blocks of " + std::to_string(block));
          const MeshData mesh = io::read_bytes("a.vtu", text).mesh;
          EXPECT_EQ(mesh.positions.size(), 2 * n + 2);
          EXPECT_EQ(mesh.positions.back(), glm::dvec3(double(n), 1, 0));
          EXPECT_EQ(mesh.faces.shapes, std::vector<Shape>(n, Shape::Quad));
        }
      }
    }
  }
}

TEST(VtuPacking, NumbersMayStandBetweenBlanks) {
  const std::string text = strip<std::uint32_t>(
      2, 64, Blocks::Vtk, [](std::size_t at) { return "   " + std::to_string(at) + " \n"; });
  EXPECT_EQ(io::read_bytes("a.vtu", text).mesh.faces.size(), 2u);
  expect_error("a.vtu", test::vtu_file("<Piece NumberOfPoints=\"4 4\"/>"),
               {"a.vtu:4: ", "\"4 4\""});
}

/// Zeros pack a thousandfold: what would not fit the mesh, or not the file, is never unpacked.
TEST(VtuPacking, NoMoreIsUnpackedThanBelongsThere) {
  const auto file = [](const std::string& attributes, const std::string& element,
                       const std::string& bytes) {
    const std::string array = "<" + element +
                              "><DataArray type=\"UInt8\" Name=\"a\" format=\"appended\" "
                              "offset=\"0\"/></" +
                              element + ">";
    const std::string piece =
        "<Piece " + attributes + ">" + (element == "FieldData" ? "" : array) +
        "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0"
        "</DataArray></Points></Piece>";
    return test::vtu_file((element == "FieldData" ? array : "") + piece, test::zlib_wide,
                          "<AppendedData encoding=\"raw\">_" + bytes + "</AppendedData>");
  };
  const std::string zeros =
      packed<std::uint64_t>(std::string(20'000'000, '\0'), 20'000'000, Blocks::Vtk);
  const std::string one = "NumberOfPoints=\"1\" NumberOfCells=\"0\"";
  EXPECT_TRUE(io::read_bytes("a.vtu", file(one, "FieldData", zeros)).mesh.attributes.empty());
  expect_error("a.vtu", file(one, "PointData", zeros),
               {"byte ", "unpacks to 20000000 bytes, and at most 1024 belong here"});
  const std::string many = test::vtu_file(
      "<Piece NumberOfPoints=\"20000000\" NumberOfCells=\"0\"><Points><DataArray type=\"UInt8\" "
      "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points></Piece>",
      test::zlib_wide, "<AppendedData encoding=\"raw\">_" + zeros + "</AppendedData>");
  expect_error("a.vtu", many, {"byte ", "unpacks to 20000000 bytes, and at most "});
}

TEST(VtuPacking, LegacyBinaryTextIsPassedOver) {
  const bool big = true;
  std::string bytes =
      "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 1 float\n" + raw(1.f, big) +
      raw(2.f, big) + raw(3.f, big) + "\nPOINT_DATA 1\nFIELD f 4\ns 1 1 string\n" +
      std::string(
          "\xc3"
          "abc",
          4) +
      "\nl 1 1 string\n" + std::string("\x80\x64", 2) + std::string(100, 'x') + "\nw 1 1 string\n" +
      std::string("\x40\0\0\x01y", 5) + "\nv 1 1 int\n" + raw(7, big) + "\n";
  const io::ReadResult result = io::read_bytes("a.vtk", bytes);
  EXPECT_EQ(result.mesh.attributes, (std::vector<Attribute>{{"v", 0, 1, true, {7}}}));
  EXPECT_EQ(result.notes,
            std::vector<std::string>{"passed over: text \"s\", text \"l\", text \"w\""});
  bytes.resize(bytes.find("xxx"));
  expect_error("a.vtk", bytes, {"byte ", "ends within an array of text"});
}

}  // namespace
}  // namespace aomd::io_vtu_packing_test
