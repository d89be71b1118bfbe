// Dirt in surfaces as the program names it: check, info, the notes of decimate, and repair --weld.

#include "core/io/io.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_dirt_test {
namespace {

using DirtCommands = CommandLine;

//  2--1 5
//  | / /|      the square as two triangles with corners of their own
//  |/ / |
//  0 3--4
constexpr const char* apart =
    "OFF\n6 2 0\n0 0 0\n1 1 0\n0 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 3 4 5\n";

// The same with a gap of 0.003.
constexpr const char* gap =
    "OFF\n6 2 0\n0 0 0\n1 1 0\n0 1 0\n0.003 0 0\n1.003 0 0\n1.003 1 0\n3 0 1 2\n3 3 4 5\n";

// A tetrahedron of which every face is listed twice.
constexpr const char* doubled =
    "OFF\n4 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
    "3 2 1 0\n3 1 3 0\n3 2 3 1\n3 0 3 2\n";

TEST_F(DirtCommands, CheckNamesTheDirtAndWhatMendsIt) {
  put("s.off", apart);
  const Outcome run = aomd("check s.off");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out,
            "unwelded borders: 2 of 6 border edges lie on others (at faces 0, 1): "
            "aomd repair s.off OUT --weld\n"
            "s.off: nothing found in the mesh, 1 kind of dirt on the surface\n");
  put("d.off", doubled);
  EXPECT_EQ(aomd("check d.off").out,
            "repeated faces: 4 faces on the vertices of others, the same way round (faces 4, 5, 7, "
            "6): aomd repair d.off OUT\n"
            "non-manifold edges: 6 edges of three or more faces, 0 without the repeated ones (at "
            "faces 0, 1, 2, ...): aomd repair d.off OUT\n"
            "self-intersections: 4 pairs of faces cut each other (faces 0, 4, 1, 5, 2, 6, 3, 7)\n"
            "d.off: nothing found in the mesh, 3 kinds of dirt on the surface\n");
}

TEST_F(DirtCommands, OnlyWhatIsRequiredFails) {
  put("s.off", apart);
  for (const char* fails : {"welded", "closed", "clean", "oriented,welded"}) {
    const Outcome run = aomd("check s.off --require " + std::string(fails));
    EXPECT_EQ(run.code, 1) << fails;
  }
  for (const char* holds : {"oriented", "manifold,distinct,embedded,used,nondegenerate"})
    EXPECT_EQ(aomd("check s.off --require " + std::string(holds)).code, 0) << holds;
  const std::string out = aomd("check s.off --require closed,welded").out;
  EXPECT_EQ(out.find("border edges: 6 edges of one face (at faces 0, 1, ...)\n"), 0u) << out;
  EXPECT_NE(out.find(" on the surface: not closed, welded\n"), std::string::npos) << out;
  expect_failure("check s.off --require shiny", 2, "shiny");
}

TEST_F(DirtCommands, EachPropertyIsBrokenByItsDirt) {
  const std::pair<const char*, const char*> cases[] = {
      {"distinct", doubled},
      {"embedded", doubled},
      {"manifold", "OFF\n5 2 0\n0 0 0\n1 1 0\n1 -1 0\n-1 1 0\n-1 -1 0\n3 0 2 1\n3 0 3 4\n"},
      {"oriented", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n"},
      {"nondegenerate", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"},
      {"used", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n"}};
  for (const auto& [property, mesh] : cases) {
    put("m.off", mesh);
    EXPECT_EQ(aomd("check m.off").code, 0) << property;
    EXPECT_EQ(aomd("check m.off --require " + std::string(property)).code, 1) << property;
  }
  put("disc.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(aomd("check disc.off --require clean").out, "disc.off: nothing found\n");
  sample("sphere", "clean.off", 8);
  EXPECT_EQ(aomd("check clean.off --require clean,closed").out, "clean.off: nothing found\n");
}

TEST_F(DirtCommands, JsonHoldsTheDirtBesideTheFindings) {
  put("g.off", gap);
  const Outcome run = aomd("check g.off --json --require welded");
  EXPECT_EQ(run.code, 1);
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_TRUE(json["findings"].empty());
  ASSERT_EQ(json["surface"].size(), 1u);
  const auto& found = json["surface"][0];
  EXPECT_EQ(found["name"], "gaps");
  EXPECT_EQ(found["count"], 2);
  EXPECT_EQ(found["entity"], "edge");
  EXPECT_EQ(found["first_faces"], (std::vector<int>{0, 1}));
  EXPECT_EQ(found["breaks"], "welded");
  EXPECT_DOUBLE_EQ(found["tolerance"], 0.0031);
  EXPECT_EQ(found["mend"], "aomd repair g.off OUT --weld 0.0031");
  EXPECT_EQ(json["required"], (std::vector<std::string>{"welded"}));
  EXPECT_EQ(json["missing"], (std::vector<std::string>{"welded"}));
  const auto closed = nlohmann::json::parse(aomd("check g.off --json --require closed").out);
  EXPECT_EQ(closed["surface"][0]["name"], "border edges");
  EXPECT_TRUE(closed["surface"][0]["mend"].is_null());
}

TEST_F(DirtCommands, InfoSaysItInALineEach) {
  put("d.off", doubled);
  const std::string out = aomd("info d.off").out;
  EXPECT_NE(out.find("\n  repeated faces: 4 faces on the vertices of others"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(aomd("info d.off --json").out)["surface"].size(), 2u);
  put("s.off", apart);
  EXPECT_EQ(aomd("info s.off").out.find("border edges:"), std::string::npos);  // counted above
}

TEST_F(DirtCommands, RepairWeldsWithinATolerance) {
  put("g.off", gap);
  const auto faces_after = [&](const std::string& options) {
    EXPECT_EQ(aomd("repair " + options + " --quiet").code, 0) << options;
    return io::read(at("o.off")).mesh.faces.vertices;
  };
  const Indices open{0, 1, 2, 3, 4, 5}, closed{0, 1, 2, 0, 4, 1};
  EXPECT_EQ(faces_after("g.off o.off --weld 0.003"), closed);
  EXPECT_EQ(faces_after("g.off o.off --weld=0.003"), closed);
  EXPECT_EQ(faces_after("--weld 0.003 g.off o.off"), closed);
  EXPECT_EQ(faces_after("g.off o.off --weld 0.0029"), open);
  EXPECT_EQ(faces_after("g.off o.off --weld 0.22%"), closed);  // of sqrt(2.006)
  EXPECT_EQ(faces_after("g.off o.off --weld 0.2%"), open);
  EXPECT_EQ(faces_after("--weld g.off o.off"), open);
  EXPECT_EQ(faces_after("g.off o.off --weld --drop-unused"), open);
  expect_failure("repair g.off o.off --weld -1", 2, "length");
  expect_failure("repair g.off o.off --weld=wide", 2, "wide");
}

TEST_F(DirtCommands, RepairTellsTheWeldAsAStage) {
  put("g.off", gap);
  const auto json = nlohmann::json::parse(aomd("repair g.off o.off --json --weld 0.01").out);
  ASSERT_EQ(json["done"].size(), 1u);
  EXPECT_EQ(json["done"][0]["name"], "welded vertices");
  EXPECT_EQ(json["done"][0]["text"], "2 vertices welded to others within the tolerance");
  EXPECT_EQ(json["done"][0]["first_vertices"], (std::vector<int>{3, 5}));
}

// Every triangle of a sphere with corners of its own, or listed twice.
class DirtySphere : public CommandLine {
 protected:
  void SetUp() override { sample("sphere", "s.off", 12); }

  void put_soup() const {
    const MeshData sphere = io::read(at("s.off")).mesh;
    MeshData soup;
    for (const std::uint32_t v : sphere.faces.vertices)
      soup.positions.push_back(sphere.positions[v]);
    for (std::uint32_t f = 0; f < sphere.faces.size(); ++f)
      soup.faces.add(Shape::Triangle, {3 * f, 3 * f + 1, 3 * f + 2});
    io::write(at("soup.ply"), soup);
  }
  void put_doubled() const {
    MeshData sphere = io::read(at("s.off")).mesh;
    const EntityList once = sphere.faces;
    sphere.faces.shapes.insert(sphere.faces.shapes.end(), once.shapes.begin(), once.shapes.end());
    sphere.faces.vertices.insert(sphere.faces.vertices.end(), once.vertices.begin(),
                                 once.vertices.end());
    io::write(at("doubled.ply"), sphere);
  }
};

TEST_F(DirtySphere, DecimateSaysWhatHinders) {
  put_soup();
  const Outcome soup = aomd("decimate soup.ply o.ply --target-faces 100");
  EXPECT_NE(soup.err.find("border edges lie on others (--repair --weld)\n"), std::string::npos)
      << soup.err;
  EXPECT_EQ(soup.err.find("lie on others"), soup.err.rfind("lie on others")) << soup.err;
  put_doubled();
  const Outcome twice = aomd("decimate doubled.ply o.ply --target-faces 100");
  EXPECT_NE(twice.err.find("the same way round (--repair)\n"), std::string::npos) << twice.err;
  EXPECT_EQ(aomd("decimate soup.ply o.ply --target-faces 100 --quiet").err, "");
  EXPECT_EQ(aomd("decimate s.off o.ply --target-faces 100").err, "");
}

TEST_F(DirtySphere, DecimateMendsWhenAsked) {
  put_soup();
  put_doubled();
  ASSERT_EQ(aomd("decimate soup.ply o.ply --target-faces 100 --repair --weld --report r.json").code,
            0);
  EXPECT_EQ(io::read(at("o.ply")).mesh.faces.size(), 100u);
  EXPECT_EQ(json("r.json")["repair"]["done"][0]["name"], "welded vertices");
  EXPECT_EQ(json("r.json")["options"]["weld"], "0");
  ASSERT_EQ(aomd("decimate doubled.ply o.ply --target-faces 100 --repair").code, 0);
  EXPECT_EQ(io::read(at("o.ply")).mesh.faces.size(), 100u);
  expect_failure("decimate soup.ply o.ply --weld 0.1", 2, "--repair");
}

// One repeated face in hundreds is told only where the target is missed.
TEST_F(DirtySphere, ALittleDirtIsToldWhenTheTargetIsMissed) {
  MeshData sphere = io::read(at("s.off")).mesh;
  const auto& v = sphere.faces.vertices;
  sphere.faces.add(Shape::Triangle, {v[0], v[1], v[2]});
  io::write(at("one.ply"), sphere);
  EXPECT_EQ(aomd("decimate one.ply o.ply --target-faces 200").err.find("way round"),
            std::string::npos);
  const Outcome missed = aomd("decimate one.ply o.ply --target-faces 1");
  EXPECT_NE(missed.err.find("one.ply: repeated faces: 1 face on the vertices of others"),
            std::string::npos)
      << missed.err;
}

// What was welded before it was decimated is welded before its journal is replayed.
TEST_F(DirtCommands, AJournalOfAWeldedSoupIsReplayed) {
  sample("sphere", "s.ply", 4);
  const MeshData whole = io::read(at("s.ply")).mesh;
  MeshData soup;
  for (const std::uint32_t v : whole.faces.vertices) soup.positions.push_back(whole.positions[v]);
  for (std::uint32_t v = 0; v < soup.positions.size(); v += 3)
    soup.faces.add(Shape::Triangle, {v, v + 1, v + 2});
  io::write(at("soup.ply"), soup);
  for (const char* weld : {"--weld", "--weld 1e-3"}) {
    const std::string mended = std::string(" --repair ") + weld;
    ASSERT_EQ(aomd("decimate soup.ply a.ply --target-faces 100 --journal j" + mended).code, 0);
    const Outcome replayed = aomd("replay soup.ply j b.ply" + mended);
    ASSERT_EQ(replayed.code, 0) << replayed.err;
    EXPECT_EQ(text("a.ply"), text("b.ply")) << weld;
  }
}

}  // namespace
}  // namespace aomd::test::cli_dirt_test
