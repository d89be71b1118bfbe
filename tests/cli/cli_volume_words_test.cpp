// What aomd says of volumes that it cannot decimate, or write, as they are.

#include <algorithm>
#include <map>

#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_volume_words_test {
namespace {

using Notes = std::vector<std::string>;

class VolumeWords : public CommandLine {
 protected:
  /// What stands on standard error.
  [[nodiscard]] std::string said(const std::string& arguments) const {
    const Outcome run = aomd(arguments);
    EXPECT_EQ(run.code, 0) << arguments << '\n' << run.err;
    return run.err;
  }
  [[nodiscard]] nlohmann::json would_help(const std::string& arguments) const {
    EXPECT_EQ(aomd("decimate " + arguments + " --report r.json").code, 0);
    const auto stopped = nlohmann::json::parse(text("r.json"))["stopped"];
    EXPECT_EQ(stopped["why"], "missed") << stopped;
    return stopped["would_help"];
  }
};

TEST_F(VolumeWords, WhatSu2DoesNotHold) {
  EXPECT_EQ(said("sample ball-in-box o.su2 --size 2"),
            "aomd: note: o.su2: left out: 96 edges, classification of vertices, classification of "
            "regions\n");
  EXPECT_EQ(said("convert o.su2 again.su2"), "") << "all that is left is held";
  MeshData mesh = io::read(at("o.su2")).mesh;
  const std::size_t markers = mesh.faces.size();
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  mesh.model.groups.push_back({3, 1, "steel"});
  EXPECT_EQ(io::write(at("o.su2"), mesh),
            Notes{"left out: 1 face on no model face, names of physical groups"});
  EXPECT_EQ(io::read(at("o.su2")).mesh.faces.size(), markers);
}

TEST_F(VolumeWords, WhatSu2DoesNotHoldInThePlane) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2}, ModelRef(2, 5));
  mesh.edges.add(Shape::Line, {0, 1}, ModelRef(1, 7));
  EXPECT_EQ(io::write(at("p.su2"), mesh), Notes{"left out: classification of faces"});
}

TEST_F(VolumeWords, RepairIsForSurfaces) {
  sample("tet-box", "v.msh", 2);
  ASSERT_EQ(aomd("decimate v.msh o.msh --journal j").code, 0);
  ASSERT_TRUE(exists("o.msh"));
  for (const char* options : {" --repair", " --repair --weld", " --repair --weld 1%"}) {
    expect_failure(std::string("decimate v.msh r.msh") + options, 5,
                   "v.msh: Repair mends surfaces; this mesh has regions");
    expect_failure(std::string("replay v.msh j r.msh") + options, 5,
                   "v.msh: Repair mends surfaces; this mesh has regions");
  }
  EXPECT_FALSE(exists("r.msh"));
}

TEST_F(VolumeWords, AnAngleThatHasNoSay) {
  const std::string no_say = "the file classifies faces or edges: --feature-angle has no say";
  sample("ball-in-box", "v.msh", 2);
  sample("box", "box.ply", 2);
  ASSERT_EQ(aomd("convert box.ply bare.off").code, 0);
  for (const std::string in : {"v.msh", "box.ply"})
    EXPECT_NE(said("decimate " + in + " o" + in + " --feature-angle 40")
                  .find("aomd: note: " + in + ": " + no_say + '\n'),
              std::string::npos)
        << in;
  EXPECT_EQ(said("decimate v.msh o.msh").find("no say"), std::string::npos) << "not given";
  EXPECT_EQ(said("decimate v.msh o.msh --feature-angle 40 --quiet"), "");
  EXPECT_EQ(said("decimate bare.off o.off --feature-angle 40").find("no say"), std::string::npos);
}

// The same tetrahedron twice, its vertices in another order: nothing of it could ever collapse.
TEST_F(VolumeWords, RepeatedTetrahedraAreRefused) {
  const std::string head =
      "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 "
      "0\n"
      "Tetrahedra\n3\n1 2 3 4 1\n2 3 4 5 1\n";
  put("twice.mesh", head + "3 1 2 4 1\nEnd\n");
  for (const char* how : {"--coarsest", "--strategy paper", "--target-tets 1"})
    expect_failure(std::string("decimate twice.mesh o.msh ") + how, 3,
                   "twice.mesh: cannot be decimated: region 2 has the same vertices as region 0");
  EXPECT_FALSE(exists("o.msh"));
  put("once.mesh", head + "1 4 3 5 1\nEnd\n");
  EXPECT_EQ(aomd("decimate once.mesh o.msh --coarsest").code, 0);
}

// The fifth vertex lies on the wrong side of the face that both have.
TEST_F(VolumeWords, SomeThatStandInsideOutAreCounted) {
  put("tangled.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
      "0.1 0.1 0.1 0\nTetrahedra\n2\n1 2 3 4 1\n1 3 2 5 1\nEnd\n");
  EXPECT_EQ(
      said("decimate tangled.mesh o.msh --coarsest"),
      "aomd: note: tangled.mesh: 1 of 2 tetrahedra stand inside out or are flat, and may stay "
      "so: aomd check names them\n");
  const Outcome check = aomd("check tangled.mesh");
  EXPECT_EQ(check.code, 1);
  EXPECT_EQ(check.out,
            "inverted region: region 1: its volume is zero or negative\n"
            "tangled.mesh: 1 finding\n");
}

// The regions of such a file are let go of while it is decimated: their data are not.
TEST_F(VolumeWords, WhatMeditSaysOfVerticesStaysWhereNothingIsDone) {
  const std::string head = "MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n";
  put("one.mesh", head +
                      "4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 1\n"
                      "Normals\n1\n0 0 -1\nNormalAtVertices\n1\n2 1\nEnd\n");
  EXPECT_EQ(said("decimate one.mesh o.mesh --coarsest"), "");
  const MeshData before = io::read(at("one.mesh")).mesh, after = io::read(at("o.mesh")).mesh;
  ASSERT_EQ(before.attributes.size(), 1u);
  EXPECT_EQ(after.attributes, before.attributes);
  sample("tet-box", "box.mesh", 4);
  std::string file = text("box.mesh");
  put("box.mesh",
      file.substr(0, file.rfind("End")) + "Normals\n1\n0 0 -1\nNormalAtVertices\n1\n2 1\nEnd\n");
  EXPECT_EQ(said("decimate box.mesh o.mesh --target-tets 50%"),
            "aomd: note: o.mesh: left out, as it does not follow the operations: "
            "\"medit:normal\"\n");
}

// Labels too large for tags count as 1, 2; in the result each region has that of its class.
TEST_F(VolumeWords, MaterialsFollowTheOperations) {
  sample("tet-box", "box.msh", 4);
  MeshData mesh = io::read(at("box.msh")).mesh;
  mesh.edges = {};
  mesh.faces = {};
  mesh.vertex_classes.clear();
  mesh.regions.classes.clear();
  mesh.attributes = {{"Material_ds", 3, 1, true, {}}, {"heat", 3, 1, false, {}}};
  for (std::size_t i = 0; i < mesh.regions.size(); ++i) {
    mesh.attributes[0].values.push_back(2 * i < mesh.regions.size() ? 1e9 : 4e9);
    mesh.attributes[1].values.push_back(0.5);
  }
  io::write(at("m.vtk"), mesh);
  std::string file = text("m.vtk");
  file[file.find("Material_ds") + 8] = 'I';  // under its own name it would come with classes
  put("m.vtk", file);
  const std::string notes = said("decimate m.vtk o.vtk --target-tets 50%");
  EXPECT_EQ(notes.find("left out"), std::string::npos) << notes;
  const MeshData result = io::read(at("o.vtk")).mesh;
  ASSERT_LT(result.regions.size(), mesh.regions.size());
  const auto found =
      std::find_if(result.attributes.begin(), result.attributes.end(),
                   [](const Attribute& a) { return a.name == "MaterialIds" && a.dimension == 3; });
  ASSERT_NE(found, result.attributes.end());
  std::map<double, std::size_t> regions;
  for (std::size_t i = 0; i < result.regions.size(); ++i) {
    const bool first = result.regions.classes[i] == ModelRef(3, 1);
    EXPECT_EQ(found->values[i], first ? 1e9 : 4e9);
    ++regions[found->values[i]];
  }
  EXPECT_EQ(regions.size(), 2u);
}

TEST_F(VolumeWords, NoOptionIsProposedThatHardlyHelps) {
  sample("tet-box", "v.msh", 2);
  EXPECT_EQ(would_help("v.msh o.msh --target-tets 1"), nullptr);
  MeshData mesh = io::read(at("v.msh")).mesh;
  mesh.edges = {};
  mesh.faces = {};
  mesh.vertex_classes.clear();
  for (std::size_t i = 0; i < mesh.regions.size(); ++i)
    mesh.regions.classes[i] = ModelRef(3, static_cast<std::int32_t>(i % 3) + 1);
  io::write(at("m.msh"), mesh);
  EXPECT_EQ(would_help("m.msh o.msh --target-tets 1"), nullptr);
  for (glm::dvec3& p : mesh.positions) p = glm::dvec3(0.0);
  io::write(at("point.msh"), mesh);
  EXPECT_EQ(would_help("point.msh o.msh --target-tets 1"), nullptr) << "no --keep was given";
  EXPECT_NE(aomd("decimate point.msh o.msh").out.find(", smallest dihedral angle 0 degrees, "),
            std::string::npos);
  sample("mixed", "mixed.msh", 2);
  EXPECT_EQ(would_help("mixed.msh o.msh --target-tets 1"), "aomd convert --split-to-tets");
}

// Their neighbours tell which tetrahedra are listed inside out: the result is that of the right
// file, byte for byte.
TEST_F(VolumeWords, ListedInsideOut) {
  sample("tet-drilled", "v.msh", 4);
  MeshData mesh = io::read(at("v.msh")).mesh;
  std::vector<std::uint32_t>& v = mesh.regions.vertices;
  const std::size_t n = mesh.regions.size();
  for (std::size_t i = 0; i < v.size(); i += 4 * 50) std::swap(v[i + 1], v[i + 2]);
  io::write(at("some.msh"), mesh);
  const std::string note = "aomd: note: some.msh: " + counted((n + 49) / 50, "tetrahedron") +
                           " listed inside out renumbered\n";
  EXPECT_EQ(said("convert some.msh w.msh"), note);
  EXPECT_EQ(text("w.msh"), text("v.msh"));
  EXPECT_EQ(aomd("check w.msh").code, 0);
  EXPECT_EQ(said("info some.msh"), note);
  EXPECT_EQ(said("decimate some.msh o.msh --target-tets 50%"), note);
  ASSERT_EQ(aomd("decimate v.msh r.msh --target-tets 50%").code, 0);
  EXPECT_EQ(text("o.msh"), text("r.msh"));
  const auto check = nlohmann::json::parse(aomd("check some.msh --json").out);
  EXPECT_EQ(check["findings"].size(), (n + 49) / 50);
  EXPECT_EQ(check["findings"][1]["entity"], "region 50");
  for (std::size_t i = 0; i < v.size(); i += 4)
    if (i % (4 * 50) != 0) std::swap(v[i + 1], v[i + 2]);
  io::write(at("all.msh"), mesh);
  EXPECT_EQ(said("convert all.msh w.msh"), "aomd: note: all.msh: " + counted(n, "tetrahedron") +
                                               " listed inside out renumbered\n");
  EXPECT_EQ(text("w.msh"), text("v.msh"));
}

}  // namespace
}  // namespace aomd::test::cli_volume_words_test
