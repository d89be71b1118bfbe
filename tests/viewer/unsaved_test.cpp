// What counts as unsaved work, who is asked about it, and how the answers go on.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene {
namespace {

using test::drive;

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

TEST(AsksFirst, OnlyBeforeWhatLosesTheWork) {
  Session s;
  drive(s, {"sample sphere 12"});
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

TEST(AsksFirst, ScriptsAreNotAsked) {
  Session s;
  drive(s, {"sample sphere 12", "step", "sample sphere 8"});
  EXPECT_EQ(s.view.dialog, Dialog::None);
  EXPECT_EQ(s.document().journal().size(), 0u);
  drive(s, {"step", "quit"});
  EXPECT_TRUE(s.quit);
}

TEST(AsksFirst, DiscardGoesOnAndCancelDoesNot) {
  Session s;
  drive(s, {"sample sphere 12", "step"});
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
  Session s;
  drive(s, {"sample sphere 12", "step"});
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
  Session s;
  drive(s, {"sample sphere 12", "step"});
  ASSERT_TRUE(asks_first(s, "quit"));
  drive(s, {"unsaved save", "dialog none", "save " + (folder / "a.ply").string()});
  EXPECT_FALSE(s.next_line);
}

}  // namespace
}  // namespace aomd::scene
