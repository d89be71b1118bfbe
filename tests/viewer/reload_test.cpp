// A file that is read again: its camera, and who notices that it has changed.

#include <gtest/gtest.h>

#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::reload_test {
namespace {

using namespace std::chrono_literals;
using test::drive;

/// A folder with one mesh, and a clock that goes on by itself.
class Reload : public testing::Test {
 protected:
  Reload() { write(12); }
  void write(int size, double larger = 1) {
    MeshData mesh = make_sample("sphere", size);
    for (glm::dvec3& p : mesh.positions) p *= larger;
    io::write(file_, mesh);
    std::filesystem::last_write_time(file_, time_ += 1s);  // clocks of disks are coarse
  }
  FileWatch::Clock::time_point later() { return now_ += FileWatch::between_looks; }
  /// What a window would carry out after some looks.
  std::string noticed(Session& s) {
    std::string line;
    for (int i = 0; i < 3 && line.empty(); ++i) line = s.look_at_file(later());
    return line;
  }

  aomd::test::TemporaryFolder folder_;
  std::string file_ = (folder_ / "a.ply").string();
  std::filesystem::file_time_type time_ = std::filesystem::file_time_type::clock::now();
  FileWatch::Clock::time_point now_{1h};
};

TEST_F(Reload, KeepsCameraClippingAndReadsWhatIsThereNow) {
  Session s;
  drive(s, {"open " + file_, "camera azimuth=10 elevation=20 zoom=2", "clip x 0.4", "shrink 0.2"});
  const Camera camera = s.view.camera;
  const auto before = s.document().mesh().count(2);
  write(16);
  drive(s, {"reload"});
  EXPECT_GT(s.document().mesh().count(2), before);
  EXPECT_TRUE(s.view.camera == camera);
  ASSERT_TRUE(s.view.clip);
  EXPECT_EQ(s.view.clip->position, 0.4);
  EXPECT_EQ(s.view.shrink, 0.2);
}

TEST_F(Reload, AFileThatIsOpenedAgainLaterHasItsCameraButNotItsClipping) {
  const std::string other = (folder_ / "b.ply").string();
  io::write(other, make_sample("torus", 8));
  Session s;
  drive(s, {"open " + file_, "camera azimuth=10 zoom=2", "clip x 0.4"});
  const Camera camera = s.view.camera;
  drive(s, {"open " + other});
  EXPECT_FALSE(s.view.camera == camera);
  drive(s, {"open " + file_});
  EXPECT_TRUE(s.view.camera == camera);
  EXPECT_FALSE(s.view.clip);
}

TEST_F(Reload, WhatWouldBeOutOfSightIsShownAnew) {
  Session s, fresh;
  drive(s, {"open " + file_, "camera azimuth=10 zoom=2"});
  write(12, 10);
  drive(s, {"reload"});
  drive(fresh, {"open " + file_});
  EXPECT_TRUE(s.view.camera == fresh.view.camera);
}

TEST_F(Reload, LeavingALessonLooksFromWhereOneLooked) {
  Session s;
  drive(s, {"open " + file_, "camera azimuth=10 zoom=2"});
  const Camera camera = s.view.camera;
  drive(s, {"lesson stored", "lesson next", "lesson off"});
  EXPECT_TRUE(s.view.camera == camera);
}

TEST_F(Reload, NeedsAFile) {
  Session s;
  drive(s, {"reload", "sample sphere 8", "step", "reload"});
  EXPECT_EQ(s.document().journal().cursor(), 1u);
  EXPECT_EQ(s.status, "The present mesh was not read from a file");
  EXPECT_THROW(execute(s, "watch on"), CommandError);
}

TEST_F(Reload, AWatchedFileIsReadOnceItHasChangedAndCameToRest) {
  Session s;
  drive(s, {"open " + file_, "watch on"});
  EXPECT_EQ(noticed(s), "");
  write(16);
  EXPECT_EQ(s.look_at_file(later()), "") << "somebody may still be writing";
  write(20);
  EXPECT_EQ(s.look_at_file(later()), "");
  EXPECT_EQ(s.look_at_file(now_), "") << "one look at a time";
  EXPECT_EQ(s.look_at_file(later()), "reload");
  drive(s, {"reload"});
  EXPECT_EQ(noticed(s), "");
  drive(s, {"watch off"});
  write(12);
  EXPECT_EQ(noticed(s), "");
  drive(s, {"watch on"});
  EXPECT_EQ(noticed(s), "reload") << "it is another one than that which was read";
}

TEST_F(Reload, UnsavedWorkIsNotLostByWatching) {
  Session s;
  drive(s, {"open " + file_, "watch on", "step 3"});
  write(16);
  EXPECT_EQ(noticed(s), "");
  ASSERT_EQ(s.warnings.size(), 1u);
  EXPECT_NE(s.warnings[0].find("a.ply has changed on disk"), std::string::npos) << s.warnings[0];
  EXPECT_EQ(noticed(s), "");
  EXPECT_EQ(s.warnings.size(), 1u);
  EXPECT_TRUE(asks_first(s, "reload"));
}

TEST_F(Reload, WhatTheProgramWritesItselfIsNoNews) {
  Session s;
  drive(s, {"open " + file_, "watch on", "step 3", "save " + file_});
  EXPECT_EQ(noticed(s), "");
  std::filesystem::remove(file_);
  EXPECT_EQ(noticed(s), "");
  write(16);
  EXPECT_EQ(noticed(s), "reload");
}

}  // namespace
}  // namespace aomd::scene::reload_test
