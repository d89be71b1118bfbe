// A mesh that is shown again without being read again.

#include <gtest/gtest.h>

#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::spare_mesh_test {
namespace {

using test::drive;

class Spare : public testing::Test {
 protected:
  Spare() {
    io::write(file_, make_sample("bracket", 4));
    io::write(volume_, make_sample("tet-box", 3));
    io::write(plain_, make_sample("bracket", 4));
  }
  /// What is left of a session that opened a file and went through these lines.
  [[nodiscard]] static std::unique_ptr<LoadedMesh> left_by(
      const std::string& file, std::initializer_list<std::string_view> lines) {
    Session s;
    drive(s, {"open " + file});
    drive(s, lines);
    return s.document().take_untouched();
  }

  aomd::test::TemporaryFolder folder_;
  std::string file_ = (folder_ / "a.ply").string(), volume_ = (folder_ / "b.msh").string(),
              plain_ = (folder_ / "c.off").string();  // says nothing of what it lies on
  SpareMesh spare_;
};

TEST_F(Spare, IsTakenWhereTheSameFileIsOpened) {
  spare_.keep(left_by(file_, {"color quality", "clip x 0.5", "theme dark", "factor 3"}));
  Session s;
  s.spare = &spare_;
  LoadRequest request;
  request.file = file_;
  std::unique_ptr<LoadedMesh> taken = spare_.take(request);
  ASSERT_TRUE(taken);
  const LoadedMesh* const same = taken.get();
  spare_.keep(std::move(taken));
  drive(s, {"open " + file_});
  EXPECT_EQ(&s.document().content(), same);
  EXPECT_EQ(s.document().content().file, file_);
  EXPECT_FALSE(spare_.take(request)) << "it is there once";
  drive(s, {"run"});
  Session fresh;
  drive(fresh, {"open " + file_, "run"});
  EXPECT_EQ(s.document().mesh().count(2), fresh.document().mesh().count(2));
  EXPECT_EQ(s.document().journal().size(), fresh.document().journal().size());
}

TEST_F(Spare, IsNotTakenForAnotherFileOrAnotherStateOfIt) {
  LoadRequest request;
  request.file = volume_;
  spare_.keep(left_by(file_, {}));
  EXPECT_FALSE(spare_.take(request));
  request.file = file_;
  request.classify.feature_angle_deg = 70;
  EXPECT_FALSE(spare_.take(request)) << "it would be classified otherwise";
  request.classify = {};
  io::write(file_, make_sample("bracket", 5));
  EXPECT_FALSE(spare_.take(request)) << "the file has changed";
}

TEST_F(Spare, IsOnlyWhatNothingHasBeenDoneTo) {
  EXPECT_TRUE(left_by(file_, {}));
  EXPECT_TRUE(left_by(file_, {"color spacing", "color none"})) << "looking is no harm";
  EXPECT_TRUE(left_by(volume_, {"clip x 0.5 cells"}));
  for (const char* line : {"step", "swap", "color verdict", "select edge 0", "adjacency 1 2 on",
                           "hash-sets build edge 61"})
    EXPECT_FALSE(left_by(file_, {line})) << line;
  EXPECT_FALSE(left_by(plain_, {"feature-preview 18"})) << "the trial looks at it";
  EXPECT_FALSE(left_by(plain_, {"feature-angle 70"}));
  EXPECT_FALSE(left_by(file_, {"sample bracket 4"})) << "it is no file's";
  EXPECT_FALSE(left_by(file_, {"step", "undo"})) << "ids may be other ones";
  EXPECT_FALSE(left_by(volume_, {"select edge 0"})) << "its edges and faces are entities now";
  EXPECT_FALSE(left_by(volume_, {"adjacency 0 3 on"}));
}

}  // namespace
}  // namespace aomd::scene::spare_mesh_test
