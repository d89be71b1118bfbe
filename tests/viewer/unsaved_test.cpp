// What counts as unsaved work, who is asked about it, and how the answers go on.

#include <gtest/gtest.h>

#include <fstream>

#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::unsaved_test {
namespace {

using test::drive;

/// Colours are of vertices, texture coordinates jump on a seam, and a line says where it is from.
MeshData painted() {
  MeshData mesh = make_sample("terrain", 12);
  Attribute color{"color", 0, 3, true, {}, NumberType::UInt8, Meaning::Colour};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (const double shade : {10.0 + static_cast<double>(v), 20.0, 30.0})
      color.values.push_back(shade);
  Attribute uv{"texcoord", 2, 2, false, {}, NumberType::Float32, Meaning::Texture};
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c) {
    const bool upper = c / 3 >= mesh.faces.size() / 2;
    uv.values.insert(uv.values.end(), {upper ? 2.0 : 1.0, 0.5});
  }
  mesh.attributes = {color};
  mesh.corners = {uv};
  mesh.remarks = {{"comment", "painted"}};
  return mesh;
}

TEST(Unsaved, WhatIsSavedHasColoursTextureAndComments) {
  const aomd::test::TemporaryFolder folder;
  const std::string in = (folder / "in.ply").string(), out = (folder / "out.ply").string();
  const MeshData mesh = painted();
  io::write(in, mesh);
  Session s;
  drive(s, {"open " + in, "save " + out});
  const MeshData same = io::read(out).mesh;
  EXPECT_EQ(same.attributes, mesh.attributes);
  EXPECT_EQ(same.corners, mesh.corners);
  EXPECT_EQ(same.remarks, mesh.remarks);
  drive(s, {"step 20", "save " + out});
  const MeshData less = io::read(out).mesh;
  ASSERT_LT(less.faces.size(), mesh.faces.size());
  EXPECT_EQ(less.remarks, mesh.remarks);
  ASSERT_EQ(less.attributes.size(), 1u);
  EXPECT_EQ(less.attributes[0].type, NumberType::UInt8);
  ASSERT_EQ(less.corners.size(), 1u);
  for (std::size_t c = 0; c < less.faces.vertices.size(); c += 3) {
    const double first = less.corners[0].values[2 * c];
    EXPECT_TRUE(first == 1 || first == 2);
    EXPECT_EQ(less.corners[0].values[2 * c + 2], first) << "no face lies on both charts";
    EXPECT_EQ(less.corners[0].values[2 * c + 4], first);
  }
  EXPECT_EQ(s.status.find("left out"), std::string::npos) << s.status;
}

TEST(Unsaved, IsWhatDiffersFromTheMeshAsLoaded) {
  Session s;
  EXPECT_FALSE(s.document().unsaved());
  drive(s, {"sample sphere 12"});
  EXPECT_FALSE(s.document().unsaved());
  drive(s, {"step 3"});
  EXPECT_TRUE(s.document().unsaved());
  drive(s, {"reset"});
  EXPECT_FALSE(s.document().unsaved());
  drive(s, {"redo", "sample sphere 8"});
  EXPECT_FALSE(s.document().unsaved());
}

TEST(Unsaved, SavingEndsItUntilTheMeshMoves) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  drive(s, {"sample sphere 12", "step 5", "save " + (folder / "a.ply").string()});
  EXPECT_FALSE(s.document().unsaved());
  EXPECT_EQ(s.document().saved_file(), folder / "a.ply");
  drive(s, {"step -1"});
  EXPECT_TRUE(s.document().unsaved());
  drive(s, {"step 1"});  // not a redo: what stood there is cut off and made again
  EXPECT_TRUE(s.document().unsaved());
}

TEST(Unsaved, WorkThatIsTakenBackAfterSavingIsNot) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  drive(s, {"sample sphere 12", "step 5", "save " + (folder / "a.ply").string(), "step 2"});
  EXPECT_TRUE(s.document().unsaved());
  drive(s, {"undo"});
  EXPECT_FALSE(s.document().unsaved());
  drive(s, {"swap", "undo"});
  EXPECT_FALSE(s.document().unsaved());
}

TEST(Unsaved, AFailedSaveLeavesItUnsaved) {
  Session s;
  drive(s, {"sample sphere 12", "step 5"});
  EXPECT_ANY_THROW(execute(s, "save /nowhere/at/all.ply"));
  EXPECT_TRUE(s.document().unsaved());
}

/// A mesh of one's own, and the line that opens it.
struct SphereFile {
  SphereFile() { io::write(folder / "sphere.ply", make_sample("sphere", 12)); }
  aomd::test::TemporaryFolder folder;
  std::string open = "open " + (folder / "sphere.ply").string();
};

TEST(AsksFirst, OnlyBeforeWhatLosesTheWork) {
  const SphereFile sphere;
  Session s;
  drive(s, {sphere.open});
  EXPECT_FALSE(asks_first(s, "quit"));
  drive(s, {"step"});
  for (const char* line : {"quit", "open x.ply", " sample torus", "recover", "recover 2"}) {
    s.view.dialog = Dialog::None;
    EXPECT_TRUE(asks_first(s, line)) << line;
    EXPECT_EQ(s.view.dialog, Dialog::Unsaved) << line;
  }
  for (const char* line :
       {"step", "save x.ply", "recover discard", "recover discard all", "reset", "quitter"})
    EXPECT_FALSE(asks_first(s, line)) << line;
}

TEST(AsksFirst, NotForWhatARunMadeOfASample) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  drive(s, {"sample sphere 12", "step", "run"});
  EXPECT_TRUE(s.document().unsaved()) << "it is kept in case the program dies";
  EXPECT_FALSE(asks_first(s, "quit"));
  drive(s, {"reset", "promote edge 3"});
  EXPECT_TRUE(asks_first(s, "quit")) << "somebody chose that by hand";
  drive(s, {"undo"});
  EXPECT_FALSE(asks_first(s, "quit"));
  drive(s, {"save " + (folder / "own.ply").string(), "step"});
  EXPECT_TRUE(asks_first(s, "quit")) << "it is one's own file by now";
}

TEST(AsksFirst, ScriptsAreNotAsked) {
  Session s;
  drive(s, {"sample sphere 12", "step", "sample sphere 8"});
  EXPECT_EQ(s.view.dialog, Dialog::None);
  EXPECT_EQ(s.document().journal().size(), 0u);
  drive(s, {"step", "quit"});
  EXPECT_TRUE(s.quit);
}

TEST(AsksFirst, DiscardGoesOnAndCancelDoesNot) {
  const SphereFile sphere;
  Session s;
  drive(s, {sphere.open, "step"});
  ASSERT_TRUE(asks_first(s, "quit"));
  drive(s, {"unsaved cancel"});
  EXPECT_FALSE(s.next_line);
  EXPECT_TRUE(s.asked.empty());
  ASSERT_TRUE(asks_first(s, "quit"));
  drive(s, {"unsaved discard"});
  EXPECT_EQ(s.next_line, "quit");
  EXPECT_EQ(s.view.dialog, Dialog::None);
}

TEST(AsksFirst, SaveAsksForAFileOnceAndThenGoesOn) {
  const aomd::test::TemporaryFolder folder;
  const SphereFile sphere;
  Session s;
  drive(s, {sphere.open, "step"});
  ASSERT_TRUE(asks_first(s, "quit"));
  drive(s, {"unsaved save"});
  EXPECT_EQ(s.view.dialog, Dialog::Save);
  EXPECT_FALSE(s.next_line);
  drive(s, {"save " + (folder / "a.ply").string()});
  EXPECT_EQ(s.next_line, "quit");
  s.next_line.reset();

  drive(s, {"step"});
  ASSERT_TRUE(asks_first(s, "sample torus"));
  drive(s, {"unsaved save"});  // it has a name by now
  EXPECT_EQ(s.next_line, "sample torus");
  EXPECT_FALSE(s.document().unsaved());
}

TEST(AsksFirst, GivingUpTheSaveDialogGivesUpTheLine) {
  const aomd::test::TemporaryFolder folder;
  const SphereFile sphere;
  Session s;
  drive(s, {sphere.open, "step"});
  ASSERT_TRUE(asks_first(s, "quit"));
  drive(s, {"unsaved save", "dialog none", "save " + (folder / "a.ply").string()});
  EXPECT_FALSE(s.next_line);
}

}  // namespace
}  // namespace aomd::scene::unsaved_test
