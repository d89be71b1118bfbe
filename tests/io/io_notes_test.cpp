// What is said beside a mesh: escapes and limits of messages, notes of writers.

#include "core/base/text.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/volume_helpers.h"

namespace aomd::io_notes_test {
namespace {

using Notes = std::vector<std::string>;
using test::TemporaryFolder;

TEST(Messages, ControlCharactersAreEscaped) {
  EXPECT_EQ(printable("plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"),
            "plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(printable(std::string_view("\0\x01\x0b\x1b[2J\x7f", 8)),
            "\\x00\\x01\\x0b\\x1b[2J\\x7f");
  EXPECT_EQ(printable("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J")
      << "a control of terminals in UTF-8";
  EXPECT_EQ(printable("\x9b"
                      "2J"),
            "\\x9b2J")
      << "the same in Latin-1";
  EXPECT_EQ(printable("\xc3("), "\\xc3(") << "half a character";
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than it need be";
  EXPECT_EQ(shown("a\x0b"), "\"a\\x0b\"");
  EXPECT_EQ(shown(std::string(23, 'x') + "\xc3\xa9"), '"' + std::string(23, 'x') + "...\"");
}

TEST(Messages, OfReadersAreOneLineWhateverTheFileHolds) {
  EXPECT_EQ(test::error_of("a\nb\x1b.obj", "v 0 0 \x0b\n"),
            "a\\nb\\x1b.obj:1: expected a number for z, found \"\\x0b\"");
  const io::ReadResult mesh =
      io::read_bytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\x1b[2J 1\nf 1 2 3\n");
  EXPECT_EQ(mesh.notes, Notes{"left out: \"\\x1b[2J\" lines"});
}

TEST(Messages, AreLimitedInNumberAndLength) {
  Notes lines(100'000, "x");
  lines[1] = std::string(10'000, 'y');
  const Notes limited = limited_lines(lines);
  ASSERT_EQ(limited.size(), 20u);
  EXPECT_EQ(limited[1], std::string(397, 'y') + "...");
  EXPECT_EQ(limited[19], "and 99981 more");
  EXPECT_EQ(limited_lines(limited), limited);
  EXPECT_EQ(limited_lines(Notes(20, "x")), Notes(20, "x"));
  EXPECT_EQ(limited_lines({std::string(400, 'z')}), Notes{std::string(400, 'z')});
  EXPECT_EQ(limited_lines({std::string(396, 'z') + "\xc3\xa9\xc3\xa9\xc3\xa9"}),
            Notes{std::string(396, 'z') + "..."})
      << "no half characters";
}

TEST(Messages, SayWhatWouldHelp) {
  EXPECT_EQ(test::error_of("a.stl", "\x1f\x8b\x08"),
            "a.stl: is compressed by gzip: unpack it first");
  EXPECT_EQ(test::error_of("a.obj", "\xff\xfev\0"), "a.obj: is text in UTF-16: save it as UTF-8");
  EXPECT_EQ(test::error_of("a.stp", "ISO-10303-21;\n"),
            "a.stp: is a STEP file, which holds surfaces but no mesh: mesh it first");
}

Notes notes_of(const std::string& name, const MeshData& mesh, std::optional<bool> binary = {}) {
  const TemporaryFolder folder;
  return io::write(folder / name.c_str(), mesh, {.binary = binary});
}

TEST(WriteNotes, NameWhatTheFormatDoesNotHold) {
  MeshData mesh = make_sample("box", 1);
  ASSERT_TRUE(mesh.classified());
  mesh.positions.emplace_back(9, 9, 9);
  mesh.vertex_classes.emplace_back();
  mesh.attributes = {{"heat", 0, 1, false, std::vector<double>(mesh.positions.size())}};
  mesh.model.groups = {{2, 1, "wall"}};
  const std::string edges = counted(mesh.edges.size(), "edge");
  EXPECT_EQ(notes_of("a.obj", mesh),
            Notes{"left out: classification of vertices, classification of edges, attribute "
                  "\"heat\", names of physical groups"});
  EXPECT_EQ(notes_of("a.ply", mesh), Notes{"left out: names of physical groups"});
  EXPECT_EQ(notes_of("a.off", mesh),
            Notes{"left out: " + edges +
                  ", classification of vertices, classification of edges, "
                  "classification of faces, attribute \"heat\", names of physical groups"});
  EXPECT_EQ(notes_of("a.stl", mesh),
            Notes{"left out: " + edges +
                  ", 1 vertex that no face uses, classification of vertices, "
                  "classification of edges, attribute \"heat\", names of physical groups"});
  EXPECT_EQ(notes_of("a.msh", mesh), Notes{});
  EXPECT_EQ(notes_of("a.vtu", mesh), Notes{"left out: names of physical groups"});
  mesh.attributes[0].name = "medit:reference";
  EXPECT_EQ(notes_of("a.mesh", mesh), Notes{"left out: names of physical groups"});
}

TEST(WriteNotes, NothingLostIsNothingSaid) {
  const MeshData mesh = make_sample("scan", 500);
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.msh", "a.mesh", "a.vtk", "a.vtu"})
    EXPECT_EQ(notes_of(name, mesh), Notes{}) << name;
}

/// A strip of n faces, `gap` apart, far from the origin.
MeshData far_strip(int n, double gap) {
  MeshData mesh;
  for (int i = 0; i < n + 2; ++i) mesh.positions.emplace_back(4'194'304 + gap * i, i % 2, 0);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i)
    mesh.faces.add(Shape::Triangle, {i, i + 1, i + 2});
  return mesh;
}

/// From 2^22 to 2^23 floats are half a unit apart.
TEST(WriteNotes, SayWhatRoundingDoes) {
  MeshData mesh = far_strip(200, 1);
  EXPECT_EQ(notes_of("a.stl", mesh), Notes{});
  mesh.positions[100].x += 0.125;
  const Notes moved{"coordinates rounded to 32-bit floats by up to 0.125; text keeps them"};
  EXPECT_EQ(notes_of("a.stl", mesh), moved);
  EXPECT_EQ(notes_of("a.off", mesh, true), moved);
  EXPECT_EQ(notes_of("a.stl", mesh, false), Notes{});
  EXPECT_EQ(notes_of("a.ply", mesh), Notes{});
  mesh.positions[100].x = mesh.positions[98].x + 0.125;  // one face shares both with a third
  EXPECT_EQ(notes_of("a.stl", mesh),
            Notes{"coordinates rounded to 32-bit floats by up to 0.125; 1 face collapses; text "
                  "keeps them"});
}

TEST(WriteNotes, MuchLostByRoundingIsRefused) {
  const TemporaryFolder folder;
  MeshData mesh = far_strip(200, 1);
  for (const std::size_t i : {50u, 100u}) mesh.positions[i].x = mesh.positions[i - 2].x + 0.125;
  EXPECT_EQ(notes_of("a.stl", mesh).size(), 1u) << "1 % of the faces";
  mesh.positions[150].x = mesh.positions[148].x + 0.125;
  io::write_file(folder / "a.stl", "old");
  try {
    io::write(folder / "a.stl", mesh);
    FAIL() << "written";
  } catch (const io::WriteError& error) {
    EXPECT_EQ(std::string(error.what()).substr((folder / "a.stl").string().size()),
              ": 3 faces of 200 would collapse, since coordinates are rounded to 32-bit floats by "
              "up to 0.125: write text, or move the mesh to the origin");
  }
  EXPECT_EQ(test::bytes_of(folder / "a.stl"), "old");
  mesh.faces.vertices[0] = mesh.faces.vertices[1];
  EXPECT_EQ(notes_of("a.off", mesh, false), Notes{});
}

/// A mesh of small numbers loses digits that nobody measures.
TEST(WriteNotes, OrdinaryRoundingIsNotSpokenOf) {
  MeshData mesh = make_sample("scan", 500);
  for (glm::dvec3& p : mesh.positions) p *= 0.1;
  EXPECT_EQ(notes_of("a.stl", mesh), Notes{});
}

}  // namespace
}  // namespace aomd::io_notes_test
