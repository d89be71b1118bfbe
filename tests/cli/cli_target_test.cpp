// aomd decimate: towards a number of faces, and what is said where it is missed.

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_target_test {
namespace {

class TargetCommand : public CommandLine {
 protected:
  /// Decimates with a report, expects success and returns "stopped".
  nlohmann::json stopped(const std::string& arguments) const {
    const Outcome run = aomd("decimate --report r.json " + arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    return json("r.json")["stopped"];
  }
};

TEST_F(TargetCommand, IsReached) {
  sample("scan", "s.ply", 6000);
  for (const char* strategy : {"paper", "quality"}) {
    const auto why = stopped(std::string("s.ply o.ply --target-faces 1000 --strategy ") + strategy);
    EXPECT_EQ(why["why"], "target");
    EXPECT_TRUE(why["refused"].empty());
    EXPECT_TRUE(why["would_help"].is_null());
    EXPECT_LE(json("r.json")["output"]["faces"], 1000);
    EXPECT_GE(json("r.json")["output"]["faces"], 990);
  }
}

TEST_F(TargetCommand, IsANumberOrAShareOfTheInput) {
  sample("sphere", "s.ply", 8);  // 20 * 8 * 8 faces
  for (const char* same : {"320", "3.2e2", "25%", "25.01%"}) {
    stopped(std::string("s.ply o.ply --target-faces ") + same);
    EXPECT_EQ(json("r.json")["options"]["target_faces"], 320) << same;
    EXPECT_EQ(json("r.json")["output"]["faces"], 320) << same;
    EXPECT_TRUE(json("r.json")["options"]["factor"].is_null());
  }
  for (const char* wrong : {"0", "-5", "1.5", "1e300", "4294967295", "0%", "-1%", "101%", "%", "x%",
                            "nan", "''", "1e3x"})
    expect_failure(std::string("decimate s.ply n.ply --target-faces ") + wrong, 2,
                   "aomd: --target-faces: must be a whole number from 1 to 4294967294, or a share "
                   "such as 10%, not ");
  EXPECT_FALSE(exists("n.ply"));
}

TEST_F(TargetCommand, MissedSaysTheReasonsInNumbersAndWhatWouldHelp) {
  sample("sphere", "s.ply", 8);
  const Outcome run =
      aomd("decimate s.ply o.ply --target-faces 10 --angle 5 --no-swap --report r.json");
  EXPECT_EQ(run.code, 0);
  const auto report = json("r.json");
  const auto& why = report["stopped"];
  EXPECT_EQ(why["why"], "missed");
  EXPECT_EQ(why["would_help"], "--angle 10");
  const auto angle = why["refused"]["Angle"].get<int>();
  int refused = 0;
  for (const auto& each : why["refused"]) refused += each.get<int>();
  EXPECT_LE(refused, report["output"]["edges"]);
  EXPECT_EQ(run.err.rfind("aomd: note: o.ply: ", 0), 0u) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  for (const std::string& part :
       {std::string(" faces, above the target of 10: of "), std::string(" edges left, "),
        std::to_string(angle) + " would turn a face by more than 5 degrees",
        std::string("; --angle 10 would help\n")})
    EXPECT_NE(run.err.find(part), std::string::npos) << part << " in " << run.err;
}

TEST_F(TargetCommand, MissedByOnePercentIsReached) {
  // All vertices of a tetrahedron stay: 4 faces are above 3, and a hundred are within 1 % of 99.
  put("t.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  EXPECT_EQ(stopped("t.off o.off --target-faces 3")["why"], "missed");
  EXPECT_EQ(stopped("t.off o.off --target-faces 4")["why"], "target");
  std::string text = "OFF\n400 400 0\n", faces;
  for (int i = 0; i < 100; ++i) {
    const std::string x = std::to_string(3 * i), x1 = std::to_string(3 * i + 1);
    text += x + " 0 0\n" + x1 + " 0 0\n" + x + " 1 0\n" + x + " 0 1\n";
    for (const auto& t : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      faces += "3 " + std::to_string(4 * i + t[0]) + ' ' + std::to_string(4 * i + t[1]) + ' ' +
               std::to_string(4 * i + t[2]) + '\n';
  }
  put("many.off", text + faces);
  EXPECT_EQ(stopped("many.off o.off --target-faces 397")["why"], "target");
  EXPECT_EQ(stopped("many.off o.off --target-faces 396")["why"], "missed");
}

TEST_F(TargetCommand, MissedStrictlyIsCode1AndWritesAll) {
  sample("sphere", "s.ply", 8);
  EXPECT_EQ(aomd("decimate s.ply o.ply --target-faces 10 --angle 5 --strict --quiet").code, 1);
  EXPECT_TRUE(exists("o.ply"));
  EXPECT_EQ(aomd("decimate s.ply o.ply --target-faces 640 --strict").code, 0);
  EXPECT_EQ(aomd("decimate s.ply o.ply --strict").code, 0);
}

// A box whose edges are features, the same without the limits that keep it, and surfaces that have
// borders and edges of many faces only because they are not mended.
TEST_F(TargetCommand, MissedForEachReasonNamesTheOptionThatLoosensIt) {
  sample("box", "box.ply", 4);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  EXPECT_EQ(stopped("bare.off o.off --target-faces 8")["would_help"], "--feature-angle off");
  EXPECT_EQ(stopped("box.ply o.ply --target-faces 8 --feature-angle off")["would_help"],
            "aomd classify --replace");
  sample("sphere", "s.ply", 8);
  put("keep.txt", "0-600\n");
  EXPECT_EQ(stopped("s.ply o.ply --target-faces 8 --keep keep.txt")["would_help"],
            "fewer vertices in --keep");
  EXPECT_EQ(stopped("s.ply o.ply --target-faces 20 --max-distance 0.5")["would_help"],
            "--max-distance 1");
  EXPECT_EQ(stopped("s.ply o.ply --target-faces 20 --min-angle 50")["would_help"],
            "a smaller --min-angle");
  EXPECT_EQ(stopped("s.ply o.ply --target-faces 20 --spacing h")["would_help"],
            "a larger --spacing");
}

TEST_F(TargetCommand, MissedForWantOfRepairPointsToIt) {
  sample("sphere", "s.ply", 4);
  const MeshData sphere = io::read(at("s.ply")).mesh;
  MeshData soup, doubled = sphere;
  for (std::size_t i = 0; i < sphere.faces.vertices.size(); i += 3) {
    const auto n = static_cast<std::uint32_t>(i);
    for (std::size_t k = 0; k < 3; ++k)
      soup.positions.push_back(sphere.positions[sphere.faces.vertices[i + k]]);
    soup.faces.add(Shape::Triangle, {n, n + 1, n + 2});
    const auto& v = sphere.faces.vertices;
    doubled.faces.add(Shape::Triangle, {v[i], v[i + 1], v[i + 2]});
  }
  doubled.faces.classes.clear();
  io::write(at("soup.off"), soup);
  io::write(at("doubled.off"), doubled);
  EXPECT_EQ(stopped("soup.off o.off --target-faces 100")["would_help"], "aomd repair --weld");
  ASSERT_EQ(aomd("repair --weld soup.off welded.off").code, 0);
  EXPECT_EQ(stopped("welded.off o.off --target-faces 100")["why"], "target");
  EXPECT_EQ(stopped("doubled.off o.off --target-faces 100")["would_help"], "--repair");
  EXPECT_EQ(stopped("doubled.off o.off --target-faces 100 --repair")["why"], "target");
}

// Each reason that keeps a twentieth of the edges has its own option, the first one is named first.
TEST_F(TargetCommand, MissedNamesWhatHelpsForEachReason) {
  sample("box", "box.ply", 4);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  const auto why = stopped("bare.off o.off --target-faces 8");
  EXPECT_EQ(why["help"], (nlohmann::json{{"Classification", "--feature-angle off"}}));
  EXPECT_TRUE(why["let_go"].empty());
}

// Without its features a part goes further; the corners of borders are a matter of --reach.
TEST_F(TargetCommand, MissedForItsModelNamesWhatGoesFurther) {
  sample("bracket", "bracket.ply", 5);
  ASSERT_EQ(aomd("convert bracket.ply bare.off").code, 0);
  const auto faces = [&](const std::string& options) {
    const auto why = stopped("bare.off o.off --target-faces 10 " + options);
    EXPECT_EQ(why["why"], "missed");
    return json("r.json")["output"]["faces"].get<int>();
  };
  const int before = faces("");
  EXPECT_EQ(json("r.json")["stopped"]["would_help"], "--feature-angle off");
  EXPECT_LT(faces("--feature-angle off"), before);
}

// The edges of a box are features that 8 faces leave no room for.
TEST_F(TargetCommand, ReachLetsGoOfGuardsInOrderUntilItIsMet) {
  sample("sphere", "s.ply", 8);
  EXPECT_EQ(stopped("s.ply o.ply --target-faces 320 --reach")["let_go"], nlohmann::json::array());
  const auto shape = stopped("s.ply o.ply --target-faces 20 --min-angle 50 --reach");
  EXPECT_EQ(shape["why"], "target");
  EXPECT_EQ(shape["let_go"], nlohmann::json({"shape"}));
  const auto facing = stopped("s.ply o.ply --target-faces 20 --angle 5 --no-swap --reach");
  EXPECT_EQ(facing["why"], "target");
  EXPECT_EQ(facing["let_go"], nlohmann::json({"facing"}));
  sample("box", "box.ply", 4);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  const Outcome run = aomd("decimate bare.off o.off --target-faces 8 --reach --report r.json");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(json("r.json")["stopped"]["let_go"], nlohmann::json({"facing", "features"}));
  EXPECT_EQ(json("r.json")["output"]["faces"], 8);
  EXPECT_EQ(json("r.json")["output"]["euler"], 2) << "the topology stays";
  EXPECT_NE(run.err.find("note: o.off: let go of facing and features to come that far\n"),
            std::string::npos)
      << run.err;
}

// A sheet's corners go last, and only if the file did not put them there.
TEST_F(TargetCommand, ReachLetsGoOfCornersLast) {
  std::string text = "OFF\n8 8 0\n", faces;
  // A square ring around a square hole: 8 corners, which leave 8 faces.
  for (const char* p : {"0 0", "3 0", "3 3", "0 3", "1 1", "2 1", "2 2", "1 2"})
    text += std::string(p) + " 0\n";
  for (const auto& t : {std::array{0, 1, 5},
                        {0, 5, 4},
                        {1, 2, 6},
                        {1, 6, 5},
                        {2, 3, 7},
                        {2, 7, 6},
                        {3, 0, 4},
                        {3, 4, 7}})
    faces += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) +
             '\n';
  put("ring.off", text + faces);
  EXPECT_EQ(stopped("ring.off o.off --target-faces 6")["would_help"], "--reach");
  const auto why = stopped("ring.off o.off --target-faces 6 --reach");
  EXPECT_EQ(why["let_go"], nlohmann::json({"facing", "features", "corners"}));
  ASSERT_EQ(aomd("classify ring.off ring.ply").code, 0);
  EXPECT_EQ(stopped("ring.ply o.ply --target-faces 6 --reach")["let_go"],
            nlohmann::json({"facing"}));
}

// What a run with what was let go of from the start does, it does.
TEST_F(TargetCommand, ReachIsAsIfItHadBeenTold) {
  sample("sphere", "s.ply", 8);
  stopped("s.ply a.ply --target-faces 20 --min-angle 50 --reach --journal a.journal");
  stopped("s.ply b.ply --target-faces 20");
  EXPECT_EQ(text("a.ply"), text("b.ply"));
  ASSERT_EQ(aomd("replay s.ply a.journal c.ply").code, 0);
  EXPECT_EQ(text("a.ply"), text("c.ply"));
}

TEST_F(TargetCommand, ReachNeedsATarget) {
  sample("sphere", "s.ply", 2);
  expect_failure("decimate s.ply n.ply --reach", 2,
                 "aomd: --reach is for --target-faces and --target-tets");
  EXPECT_EQ(aomd("decimate s.ply n.ply --reach --target-error 1").code, 2);
  EXPECT_FALSE(exists("n.ply"));
}

TEST_F(TargetCommand, ErrorIsMetAsCompareMeasuresIt) {
  sample("scan", "s.ply", 6000);
  for (const char* aim : {"0.5", "2%"}) {
    const auto why = stopped(std::string("s.ply o.ply --target-error ") + aim);
    const double limit = std::stod(aim), error = why["error_pct"].get<double>();
    EXPECT_EQ(why["why"], "error");
    EXPECT_LE(error, limit);
    EXPECT_GE(error, 0.8 * limit);
    EXPECT_GE(why["tries"], 1);
    const auto report = json("r.json");
    EXPECT_EQ(report["options"]["target_error_pct"], limit);
    EXPECT_TRUE(report["options"]["target_faces"].is_null());
    const auto compared = nlohmann::json::parse(aomd("compare s.ply o.ply --json").out);
    EXPECT_NEAR(compared["hausdorff_pct"].get<double>(), error, 1e-9);
  }
}

TEST_F(TargetCommand, ErrorOfSurfacesThatAreHardlyAny) {
  put("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  put("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  put("none.off", "OFF\n0 0 0\n");
  put("tet.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  for (const auto& [file, faces] :
       {std::pair{"flat.off", 2}, {"one.off", 1}, {"none.off", 0}, {"tet.off", 4}}) {
    const auto why = stopped(std::string(file) + " o.off --target-error 1");
    EXPECT_LT(why["error_pct"].get<double>(), 1e-12) << file;
    EXPECT_EQ(json("r.json")["output"]["faces"], faces) << file;
  }
}

TEST_F(TargetCommand, ErrorIsANumberAndTheOnlyAim) {
  sample("sphere", "s.ply", 2);
  for (const char* wrong : {"0", "-1", "nan", "x", "''", "inf"})
    expect_failure(std::string("decimate s.ply n.ply --target-error ") + wrong, 2,
                   "aomd: --target-error: must be a number above 0, not ");
  for (const char* other : {"--target-faces 9", "--factor 2", "--coarsest", "--max-distance 1"})
    EXPECT_EQ(aomd(std::string("decimate s.ply n.ply --target-error 1 ") + other).code, 2) << other;
  sample("ball-in-box", "v.msh", 3);
  expect_failure("decimate v.msh n.msh --target-error 1", 2,
                 "aomd: --target-error is for surfaces, and v.msh has regions");
  EXPECT_FALSE(exists("n.ply"));
  EXPECT_FALSE(exists("n.msh"));
}

TEST_F(TargetCommand, ReachOfAVolumeLetsGoOfItsLeastAngles) {
  sample("ball-in-box", "v.msh", 4);
  const auto held = stopped("v.msh o.msh --target-tets 60 --min-dihedral 25");
  EXPECT_EQ(held["why"], "missed");
  const auto why = stopped("v.msh o.msh --target-tets 60 --min-dihedral 25 --reach");
  EXPECT_EQ(why["let_go"][0], "shape");
  EXPECT_TRUE(json("r.json")["options"]["reach"].get<bool>());
}

}  // namespace
}  // namespace aomd::test::cli_target_test
