// Compressed arrays of VTU that are gone through piece by piece: what a whole reader reads, in
// memory that does not depend on how long they are.

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/io/base64.h"
#include "core/io/streamed_surface.h"
#include "core/io/vtu_column.h"
#include "core/samples/numeric.h"
#include "core/samples/samples.h"
#include "tests/io/fuzz/counted_new.h"
#include "tests/support/vtu_blocks.h"

namespace aomd::streamed_vtu_packing_test {
namespace {

using io::StreamedSurface;
using test::Blocks;
using test::raw;

/// How a file is packed.
struct How {
  bool wide = false, big = false;
  enum class Where { Elements, AppendedText, AppendedBytes } where = Where::AppendedBytes;
  std::size_t block = 64;
  Blocks blocks = Blocks::Vtk;

  [[nodiscard]] test::Packed packed(const std::string& bytes) const {
    return wide ? test::packed_in_blocks<std::uint64_t>(bytes, block, blocks, big)
                : test::packed_in_blocks<std::uint32_t>(bytes, block, blocks, big);
  }
};

/// A file of arrays, one after the other.
class File {
 public:
  explicit File(How how = {}) : how_(how) {}

  [[nodiscard]] std::string element(const char* type, const char* name, int components,
                                    const test::Packed& packed) {
    std::string text = std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
                       "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"";
    const bool raw_bytes = how_.where == How::Where::AppendedBytes;
    const std::string bytes =
        raw_bytes ? packed.head + packed.data
                  : io::detail::to_base64(packed.head) + io::detail::to_base64(packed.data);
    if (how_.where == How::Where::Elements)
      return text + "binary\">\n " + in_lines(bytes) + "\n</DataArray>";
    text += "appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>";
    appended_ += bytes;
    return text;
  }

  template <typename Value>
  [[nodiscard]] std::string array(const char* type, const char* name, int components,
                                  const std::vector<Value>& values) {
    std::string bytes;
    for (const Value value : values) bytes += raw(value, how_.big);
    return element(type, name, components, how_.packed(bytes));
  }

  /// `piece` stands in the only piece.
  [[nodiscard]] std::string text(std::size_t points, std::size_t cells, const std::string& piece,
                                 const char* compressor = "vtkZLibDataCompressor") const {
    std::string all = std::string("<VTKFile type=\"UnstructuredGrid\" compressor=\"") + compressor +
                      "\" byte_order=\"" + (how_.big ? "BigEndian" : "LittleEndian") +
                      "\" header_type=\"" + (how_.wide ? "UInt64" : "UInt32") +
                      "\"><UnstructuredGrid><Piece NumberOfPoints=\"" + std::to_string(points) +
                      "\" NumberOfCells=\"" + std::to_string(cells) + "\">" + piece +
                      "</Piece></UnstructuredGrid>";
    if (how_.where == How::Where::AppendedBytes)
      all += "<AppendedData encoding=\"raw\">_" + appended_ + "</AppendedData>";
    if (how_.where == How::Where::AppendedText)
      all += "<AppendedData encoding=\"base64\">\n _" + appended_ + "\n</AppendedData>";
    return all + "</VTKFile>\n";
  }

 private:
  /// Groups of four go on in the next line.
  static std::string in_lines(std::string text) {
    for (std::size_t at = 70; at < text.size(); at += 72) text.insert(at, "\r\n");
    return text;
  }

  How how_;
  std::string appended_;
};

/// A mesh with an array on its vertices and one on its faces.
std::string packed_as(const How& how, const MeshData& mesh) {
  File file(how);
  std::vector<double> x, heat;
  std::vector<std::int16_t> part;
  std::vector<std::int64_t> ends;
  std::vector<std::int32_t> corners(mesh.faces.vertices.begin(), mesh.faces.vertices.end());
  for (const glm::dvec3& p : mesh.positions) {
    x.insert(x.end(), {p.x, p.y, p.z});
    heat.push_back(p.x * p.y);
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    ends.push_back(static_cast<std::int64_t>(3 * f + 3));
    part.push_back(static_cast<std::int16_t>(f % 1000));
  }
  const std::vector<std::uint8_t> types(mesh.faces.size(), 5);
  std::string piece =
      "<PointData>" + file.array("Float64", "heat", 1, heat) + "</PointData><CellData>";
  piece += file.array("Int16", "part", 1, part) + "</CellData><Points>";
  piece += file.array("Float64", "p", 3, x) + "</Points><Cells>";
  piece += file.array("Int32", "connectivity", 1, corners);
  piece += file.array("Int64", "offsets", 1, ends);
  piece += file.array("UInt8", "types", 1, types) + "</Cells>";
  return file.text(mesh.positions.size(), mesh.faces.size(), piece);
}

class StreamedVtuPacking : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& bytes) const {
    std::ofstream(folder_ / "a.vtu", std::ios::binary) << bytes;
    return folder_ / "a.vtu";
  }

  static MeshData streamed(const std::filesystem::path& path) {
    return StreamedSurface(path).part([](const auto&) { return true; }).mesh;
  }

  void expect_as_read(const std::string& bytes) const {
    const std::filesystem::path path = put(bytes);
    MeshData whole = io::read(path).mesh;
    whole.vertex_classes.clear();
    whole.faces.classes.clear();
    EXPECT_EQ(whole.attributes.size(), 2u);
    EXPECT_TRUE(streamed(path) == whole);
  }

  struct Errors {
    std::string whole, in_pieces;
  };
  /// What the readers say; "" where they read it.
  Errors errors_of(const std::string& bytes) const {
    const std::filesystem::path path = put(bytes);
    Errors errors;
    try {
      (void)io::read(path);
    } catch (const io::FileError& e) {
      errors.whole = e.what();
    }
    try {
      (void)streamed(path);
    } catch (const io::FileError& e) {
      errors.in_pieces = e.what();
    }
    return errors;
  }
  std::string error_of_both(const std::string& bytes) const {
    const Errors errors = errors_of(bytes);
    EXPECT_EQ(errors.whole, errors.in_pieces);
    return errors.in_pieces;
  }

  test::TemporaryFolder folder_;
};

TEST_F(StreamedVtuPacking, IsWhatAWholeReaderReads) {
  const MeshData mesh = make_sample("torus", 12);
  for (const auto where :
       {How::Where::Elements, How::Where::AppendedText, How::Where::AppendedBytes}) {
    for (const bool wide : {false, true}) {
      for (const bool big : {false, true}) {
        for (const std::size_t block : {24u, 1000u, 1u << 20}) {
          for (const Blocks blocks : {Blocks::Vtk, Blocks::Meshio})
            expect_as_read(packed_as({wide, big, where, block, blocks}, mesh));
        }
      }
    }
  }
}

// More than one piece of tuples, and of what is read at once, in blocks that end anywhere.
TEST_F(StreamedVtuPacking, BlocksNeedNotEndWherePiecesDo) {
  const MeshData mesh = make_sample("scan", 80'000);
  expect_as_read(packed_as({.block = 32'768}, mesh));
  expect_as_read(packed_as({.where = How::Where::Elements, .block = 100'001}, mesh));
  expect_as_read(packed_as({.block = 1 << 24}, mesh));
}

/// Two triangles, whose types are packed like this.
std::string with_types(const test::Packed& types, How how = {}) {
  File file(how);
  std::string piece = "<Points>" +
                      file.array<float>("Float32", "p", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}) +
                      "</Points><Cells>";
  piece += file.array<std::int32_t>("Int32", "connectivity", 1, {0, 1, 2, 1, 3, 2});
  piece += file.array<std::int32_t>("Int32", "offsets", 1, {3, 6});
  piece += file.element("UInt8", "types", 1, types) + "</Cells>";
  return file.text(4, 2, piece);
}

/// One block for each of these, of which it is said that they unpack to so many bytes.
test::Packed in_blocks(const std::vector<std::string>& packed, std::uint32_t size,
                       std::uint32_t last = 0) {
  test::Packed result{raw(static_cast<std::uint32_t>(packed.size())) + raw(size) + raw(last), {}};
  for (const std::string& block : packed) {
    result.head += raw(static_cast<std::uint32_t>(block.size()));
    result.data += block;
  }
  return result;
}

const std::string one_type = test::deflated("\5"), both_types = test::deflated("\5\5");

TEST_F(StreamedVtuPacking, DamagedBlocksAreNamedWithTheByte) {
  const auto damaged = [&](const std::vector<std::string>& packed, std::uint32_t size,
                           std::uint32_t last, int block) {
    const std::string text = with_types(in_blocks(packed, size, last));
    const std::string error = error_of_both(text);
    // Blocks are handed to zlib as a whole, so that the end of the last one is as far as it came.
    std::size_t end = text.find("</AppendedData>");
    for (std::size_t i = static_cast<std::size_t>(block) + 1; i < packed.size(); ++i)
      end -= packed[i].size();
    EXPECT_EQ(error, (folder_ / "a.vtu").string() + ": byte " + std::to_string(end) + ": block " +
                         std::to_string(block) + " of compressed data is damaged");
  };
  EXPECT_EQ(error_of_both(with_types(in_blocks({one_type, one_type}, 1))), "");
  std::string flipped = one_type, no_zlib = one_type;
  flipped.back() ^= 1;  // of the check sum
  no_zlib.front() ^= 1;
  damaged({one_type, flipped}, 1, 0, 1);
  damaged({flipped, one_type}, 1, 0, 0);
  damaged({no_zlib, one_type}, 1, 0, 0);
  damaged({one_type}, 2, 0, 0);              // too few bytes
  damaged({both_types, one_type}, 1, 0, 0);  // too many
  damaged({test::deflated(""), both_types}, 1, 0, 0);
  damaged({one_type + "x", one_type}, 1, 0, 0);  // more behind it
  damaged({one_type, one_type.substr(0, 5)}, 1, 0, 1);
  damaged({one_type, one_type.substr(0, one_type.size() - 1)}, 1, 0, 1);
  damaged({one_type, ""}, 1, 0, 1);
  damaged({both_types + "x"}, 5, 2, 0);  // a last block that is smaller
}

// Arrays that end with the file.
TEST_F(StreamedVtuPacking, EmptyBlocksAreLookedAtToo) {
  io::detail::VtuPacking packing;
  packing.compressed = true;
  const auto bytes_of = [&](const test::Packed& packed) {
    const std::string bytes = packed.head + packed.data;
    io::detail::VtuColumn column(put(bytes), {0, bytes.size(), false}, packing);
    std::string all = "x";
    column.take(static_cast<std::size_t>(column.size()), all);
    return all;
  };
  const auto expect_damaged = [&](const test::Packed& packed) {
    try {
      EXPECT_EQ(bytes_of(packed), "nothing");
    } catch (const io::ReadError& e) {
      EXPECT_TRUE(std::string_view(e.what()).ends_with(" of compressed data is damaged"))
          << e.what();
    }
  };
  const std::string nothing = test::deflated("");
  EXPECT_EQ(bytes_of(in_blocks({}, 64)), "");
  EXPECT_EQ(bytes_of(in_blocks({nothing, nothing}, 0)), "");
  EXPECT_EQ(bytes_of(in_blocks({nothing, both_types}, 0, 2)), "\5\5");
  expect_damaged(in_blocks({nothing, one_type}, 0));
  expect_damaged(in_blocks({one_type.substr(0, 3)}, 1));
}

TEST_F(StreamedVtuPacking, WhatIsOnlyPromisedIsNotBelieved) {
  const auto expect = [&](const std::string& text, const std::string& fragment) {
    const std::string error = error_of_both(text);
    EXPECT_NE(error.find(": byte "), std::string::npos) << error;
    EXPECT_NE(error.find(fragment), std::string::npos) << error;
  };
  constexpr std::uint32_t much = std::numeric_limits<std::uint32_t>::max();
  expect(with_types({raw(much) + raw(1u) + raw(0u), both_types}),
         "the data end early: a header of 4294967295 words should follow");
  expect(with_types(in_blocks({both_types}, much)),
         "the data end early: 1 block of 4294967295 bytes should follow");
  expect(with_types(in_blocks({one_type, one_type}, much, 1)),
         "the data end early: 2 blocks of 4294967295 bytes should follow");
  expect(with_types({raw(2u) + raw(1u) + raw(0u) + raw(9u) + raw(1000u), one_type + one_type}),
         "the data end early: block 1 of 1000 bytes should follow");
  const std::string whole = with_types(in_blocks({both_types}, 2));
  expect(whole.substr(0, whole.find("</AppendedData>") - 1), "the data end early: block 0 of ");
  How text;
  text.where = How::Where::Elements;
  std::string no_base64 = with_types(in_blocks({both_types}, 2), text);
  const std::size_t last = no_base64.rfind("\n</DataArray>") - 4;
  expect(std::string(no_base64).erase(last, 4), "the data end early");
  no_base64[last] = '!';
  expect(no_base64, "not base64: \"!\"");
}

TEST_F(StreamedVtuPacking, CountsAndCompressorsMustFit) {
  const auto refused = [&](const std::string& text, const std::string& fragment) {
    try {
      (void)streamed(put(text));
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  };
  refused(with_types(in_blocks({one_type, one_type, one_type}, 1)),
          "array \"types\" has 3 bytes for 2 times 1 (only triangles can be read in blocks)");
  const std::string text = with_types(in_blocks({both_types}, 2));
  for (const std::string other : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"}) {
    std::string renamed = text;
    const std::string zlib = "vtkZLibDataCompressor";
    renamed.replace(renamed.find(zlib), zlib.size(), other);
    refused(renamed, "compressed by \"" + other +
                         "\"; only vtkZLibDataCompressor is read: save it with that, or "
                         "uncompressed");
  }
}

// One block may be all of the array. What is packed has half of its size.
TEST_F(StreamedVtuPacking, TakesNoMoreMemoryForMoreBytes) {
  constexpr std::size_t much = 4'000'000, a_piece = 100'000;
  std::string all;
  for (std::size_t i = 0; i < much; ++i) all += static_cast<char>(8 * sample::hashed(i));
  io::detail::VtuPacking packing;
  packing.compressed = true;
  for (const std::size_t block : {much, std::size_t{32'768}}) {
    const test::Packed array = test::packed_in_blocks<std::uint32_t>(all, block, Blocks::Vtk);
    EXPECT_GT(array.data.size(), much / 4);
    for (const bool base64 : {false, true}) {
      const std::string bytes =
          base64 ? io::detail::to_base64(array.head) + io::detail::to_base64(array.data)
                 : array.head + array.data;
      const std::filesystem::path path = put(bytes);
      const std::size_t before = test::live_bytes;
      test::peak_bytes = before;
      io::detail::VtuColumn column(path, {0, bytes.size(), base64}, packing);
      ASSERT_EQ(column.size(), much);
      std::string piece;
      for (std::size_t done = 0; done < much; done += a_piece) {
        column.take(a_piece, piece);
        ASSERT_TRUE(std::string_view(all).substr(done, a_piece) == piece) << done;
      }
      EXPECT_LT(test::peak_bytes - before, a_piece + (200u << 10)) << block << ' ' << base64;
    }
  }
}

// What one of both readers refuses the other refuses too, and what both read is the same.
TEST_F(StreamedVtuPacking, DamagedFilesAreRefusedOrReadByBoth) {
  const MeshData mesh = make_sample("torus", 5);
  const std::string good[] = {packed_as({.block = 200}, mesh),
                              packed_as({.wide = true, .block = 200}, mesh)};
  std::uint64_t draws = 0;
  const auto random = [&](std::size_t n) {
    return static_cast<std::size_t>((sample::hashed(draws++) + 1) / 2 * static_cast<double>(n));
  };
  int refused = 0;
  for (int round = 0; round < 1000 && !HasFailure(); ++round) {
    std::string text = good[round % 2];
    const std::size_t first = text.find("raw\">_") + 6;
    const std::size_t at = first + random(text.size() - first);
    switch (random(4)) {
      case 0:
        text[at] = static_cast<char>(random(256));
        break;
      case 1:
        text.resize(at);
        break;
      case 2:
        text.erase(at, 1 + random(8));
        break;
      default:
        text.insert(at, std::string(1 + random(8), "\0\xff"[random(2)]));
    }
    const Errors errors = errors_of(text);
    EXPECT_EQ(errors.whole.empty(), errors.in_pieces.empty()) << errors.whole << errors.in_pieces;
    EXPECT_EQ(errors.in_pieces.find('\n'), std::string::npos) << errors.in_pieces;
    refused += !errors.in_pieces.empty();
    if (errors.whole.empty()) expect_as_read(text);
  }
  EXPECT_GT(refused, 500);
  EXPECT_LT(refused, 1000);
}

}  // namespace
}  // namespace aomd::streamed_vtu_packing_test
