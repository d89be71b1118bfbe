// One mesh as text of every format, written in all the ways in which programs and people write it:
// it is read as the same mesh, or refused with what would help.

#include <functional>

#include "core/base/text.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/surface_facts.h"

namespace aomd::io_variants_test {
namespace {

using test::raw;
using test::same_mesh;
using test::TemporaryFolder;

struct TextFile {
  std::string name, text;
};

/// A box in every surface format, a ball in the one that holds volumes alone.
std::vector<TextFile> text_files() {
  const TemporaryFolder folder;
  std::vector<TextFile> files;
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl", "a.msh", "b.msh", "a.mesh", "a.vtk",
                           "a.vtu", "a.su2"}) {
    const MeshData mesh = make_sample(name == std::string("a.su2") ? "tet-ball" : "box", 1);
    io::write(folder / name, mesh, {.binary = false, .msh2 = name[0] == 'b'});
    files.push_back({name, test::bytes_of(folder / name)});
  }
  return files;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// Expects each file to read as before, with no more to say, after `change`.
void expect_same(const std::function<std::string(const TextFile&)>& change) {
  for (const TextFile& file : text_files()) {
    const std::string text = change(file);
    if (text.empty()) continue;
    const io::ReadResult plain = io::read_bytes(file.name, file.text);
    ASSERT_EQ(test::error_of(file.name, text), "") << file.name;
    for (const std::string& name : {file.name, std::string("no_extension")}) {
      const io::ReadResult other = io::read_bytes(name, text);
      EXPECT_TRUE(same_mesh(other.mesh, plain.mesh)) << name << " of " << file.name;
      EXPECT_EQ(other.notes, plain.notes) << name << " of " << file.name;
    }
  }
}

TEST(Variants, LineEnds) {
  for (const char* end : {"\r\n", "\r", "\n\n", "\n \t\n", "\r\n\r\n", "  \n", "\t\r\n"})
    expect_same([&](const TextFile& file) { return replaced(file.text, "\n", end); });
  expect_same([](const TextFile& file) { return file.text.substr(0, file.text.size() - 1); });
  expect_same([](const TextFile& file) { return "\n \r\n" + file.text; });
}

TEST(Variants, BlanksBetweenWords) {
  for (const char* blanks : {"\t", "   ", " \t "})
    expect_same([&](const TextFile& file) { return replaced(file.text, " ", blanks); });
  expect_same([](const TextFile& file) { return replaced(file.text, "\n", "\n  "); });
}

/// In the header of a legacy VTK file the second line is the title, whatever it holds.
TEST(Variants, CommentLines) {
  expect_same([](const TextFile& file) {
    if (file.name == "a.vtu") return std::string();
    const std::size_t second = file.text.find('\n', file.text.find('\n') + 1);
    return file.text.substr(0, second) + replaced(file.text.substr(second), "\n", "\n# 1 2 3\n");
  });
  expect_same([](const TextFile& file) {
    return file.name == "a.vtk" || file.name == "a.vtu" ? "" : "# made by hand\n" + file.text;
  });
}

TEST(Variants, PaddingBehindTheEnd) {
  for (const std::string& padding :
       {std::string(7, '\0'), std::string(512, '\0'), std::string("\x1a"), std::string("\f\n"),
        "\r\n\x1a" + std::string(3, '\0')})
    expect_same([&](const TextFile& file) { return file.text + padding; });
}

TEST(Variants, CapitalsAndSmallLetters) {
  const auto not_names = [](const TextFile& file) {
    return file.name == "a.obj" || file.name == "a.stl" || file.name.ends_with("msh") ||
           file.name.ends_with("vtu") || file.name.ends_with("su2") || file.name.ends_with("vtk");
  };
  expect_same([&](const TextFile& file) { return not_names(file) ? "" : lower(file.text); });
  expect_same([&](const TextFile& file) {
    std::string text = not_names(file) ? "" : file.text;
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  });
}

TEST(Variants, KeywordsInTheOtherCase) {
  const auto faces = [](const std::string& name, const std::string& text) {
    EXPECT_EQ(test::error_of(name, text), "");
    return io::read_bytes(name, text).mesh.faces.vertices;
  };
  const test::Indices one{0, 1, 2};
  EXPECT_EQ(faces("a.obj", "V 0 0 0\nV 1 0 0\nV 0 1 0\nVT 0 0\nF 1/1 2/1 3/1\n"), one);
  EXPECT_EQ(faces("a", "off\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), one);
  EXPECT_EQ(faces("a", "Coff\n3 1 0\n0 0 0 9 9 9 9\n1 0 0\n0 1 0\n3 0 1 2\n"), one);
  EXPECT_EQ(faces("a", "ndime= 2\nnelem= 1\n5 0 1 2\nnpoin= 3\n0 0\n1 0\n0 1\nnmark= 0\n"), one);
  EXPECT_EQ(faces("a",
                  "# VTK  datafile\tversion 3.0\n\n\nt\n\nascii\n\ndataset polydata\npoints 3 "
                  "float\n0 0 0 1 0 0 0 1 0\npolygons 1 4\n3 0 1 2\n"),
            one);
  EXPECT_EQ(faces("a",
                  "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                  "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"),
            one);
  test::expect_error("a.off", "nOFF\n4\n0 0 0\n", {"only three-dimensional OFF is read"});
}

/// The coordinate 2 of one triangle in each format, with `x` in its place.
std::vector<TextFile> with_coordinate(const std::string& x) {
  const std::string points = "0 0 0\n" + x + " 0 0\n0 1 0\n";
  return {{"a.obj", "v 0 0 0\nv " + x + " 0 0\nv 0 1 0\nf 1 2 3\n"},
          {"a.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n"},
          {"a.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
               points + "3 0 1 2\n"},
          {"a.stl", "solid\nfacet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex " + x +
                        " 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
          {"a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 " + x +
                        " 0 0\n3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 0 1 2 3\n$EndElements\n"},
          {"a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n" + x +
                         " 0 0 0\n0 1 0 0\nTriangles 1\n1 2 3 0\nEnd\n"},
          {"a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n" +
                        points + "POLYGONS 1 4\n3 0 1 2\n"},
          {"a.su2", "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n" + x + " 0\n0 1\nNMARK= 0\n"}};
}

TEST(Variants, NumbersAsProgramsWriteThem) {
  for (const char* number :
       {"2", "2.", "+2.0", "2e0", "2.0E+00", "2.0E+000", ".2e1", "20D-1", "2.0d0", "2.d+00"})
    for (const TextFile& file : with_coordinate(number)) {
      ASSERT_EQ(test::error_of(file.name, file.text), "");
      EXPECT_EQ(io::read_bytes(file.name, file.text).mesh.positions[1], glm::dvec3(2, 0, 0))
          << file.name << ' ' << number;
    }
  EXPECT_EQ(
      io::read_bytes("a.off", "OFF\n+3 +1 0\n0 0 0\n1 0 0\n0 1 0\n+3 0 1 2\n").mesh.faces.size(),
      1u);
}

TEST(Variants, NumbersThatAreRefusedSayWhy) {
  const auto all_say = [](const char* number, const char* says) {
    for (const TextFile& file : with_coordinate(number))
      test::expect_error(file.name, file.text, {file.name.c_str(), says});
  };
  for (const char* number : {"nan", "-nan(ind)", "inf", "-Infinity", "1e999"})
    all_say(number, "not a finite number");
  all_say("2,0", "found \"2,0\": write decimal points, not commas");
  all_say("2,0,0", "found \"2,0,0\": write blanks between numbers");
  all_say("2;0", "found \"2;0\": write blanks between numbers");
  all_say("2.0f", "found \"2.0f\"");
  test::expect_error("a.ply", with_coordinate("-1.#IND")[2].text, {"not a finite number"});
  test::expect_error("a.ply", with_coordinate("1.#INF")[2].text, {"not a finite number"});
}

TEST(Variants, WideTextIsNamed) {
  for (const TextFile& file : text_files()) {
    std::string little, big;
    for (const char c : file.text) {
      little += {c, '\0'};
      big += {'\0', c};
    }
    for (const std::string& text : {little, big, "\xff\xfe" + little, "\xfe\xff" + big})
      EXPECT_EQ(test::error_of(file.name, text),
                file.name + ": is text in UTF-16: save it as UTF-8");
    EXPECT_EQ(test::error_of(file.name, std::string("\xff\xfe\0\0", 4) + file.text),
              file.name + ": is text in UTF-32: save it as UTF-8");
    EXPECT_EQ(test::error_of(file.name, "\x1f\x8b\x08" + file.text),
              file.name + ": is compressed by gzip: unpack it first");
  }
}

TEST(Variants, MeditSectionsInAnyOrder) {
  const std::string start = "MeshVersionFormatted 2\n", dimension = "Dimension 3\n",
                    vertices = "Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n",
                    triangles = "Triangles 1\n1 2 3 4\n", corners = "Corners 1\n2\n",
                    normals = "Normals 1\n0 0 1\nNormalAtVertices 1\n3 1\n";
  const MeshData plain =
      io::read_bytes("a.mesh", start + dimension + vertices + triangles + corners + normals).mesh;
  EXPECT_EQ(plain.vertex_classes[1], ModelRef(0, 1));
  for (const std::string& body : {triangles + corners + normals + vertices + dimension,
                                  normals + dimension + triangles + vertices + corners,
                                  vertices + triangles + corners + dimension + normals})
    EXPECT_EQ(io::read_bytes("a.mesh", start + body + "End\n").mesh, plain);
  test::expect_error("a.mesh", start + vertices, {"the file has no Dimension"});
  test::expect_error("a.mesh", start + dimension + triangles, {"the file has no Vertices"});
}

/// A section is its keyword, where the next one stands, and what it holds.
std::string meshb(const std::vector<std::pair<std::int32_t, std::string>>& sections) {
  std::string bytes = raw(std::int32_t{1}) + raw(std::int32_t{2});
  for (const auto& [keyword, content] : sections) {
    const bool last = keyword == sections.back().first;
    const std::size_t next = bytes.size() + 8 + content.size();
    bytes += raw(keyword) + raw(last ? 0 : static_cast<std::int32_t>(next)) + content;
  }
  return bytes;
}

TEST(Variants, BinaryMeditSectionsInAnyOrderAndWithoutEnd) {
  std::string points = raw(std::int32_t{3});
  for (const glm::dvec3& p : {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)})
    points += raw(p.x) + raw(p.y) + raw(p.z) + raw(std::int32_t{0});
  std::string triangle;
  for (const std::int32_t n : {1, 1, 2, 3, 4}) triangle += raw(n);
  const MeshData mesh =
      io::read_bytes("a.meshb", meshb({{6, triangle}, {4, points}, {3, raw(std::int32_t{3})}}))
          .mesh;
  EXPECT_EQ(mesh.positions[2], glm::dvec3(0, 1, 0));
  EXPECT_EQ(mesh.faces.vertices, (test::Indices{0, 1, 2}));
}

TEST(Variants, AMarkerThatIsPromisedMustBeThere) {
  const std::string mesh = "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 2\n";
  const std::string marker = "MARKER_TAG= a\nMARKER_ELEMS= 1\n3 0 1\n";
  test::expect_error("a.su2", mesh + marker, {"a.su2:12: ", "the file ends after 1 of 2 markers"});
  EXPECT_EQ(test::error_of("a.su2", mesh + marker + marker), "");
}

}  // namespace
}  // namespace aomd::io_variants_test
