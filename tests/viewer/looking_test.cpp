// Looking at a mesh changes no run: what is said of edges, colours, and what the mouse points at.

#include <gtest/gtest.h>

#include "core/io/journal_file.h"
#include "tests/support/session_helpers.h"

namespace aomd::scene::looking_test {
namespace {

using test::drive;

void set_limits(Session& s) {
  drive(s, {"strategy quality", "max-distance 0.2", "target-faces 100"});
}

/// What a run made, with which steps.
struct Made {
  std::uint64_t vertices = 0, faces = 0, steps = 0, words = 0;
  io::MeshFingerprint mesh;
  friend bool operator==(const Made&, const Made&) = default;
};

Made made_of(const Session& s) {
  const Document& document = s.document();
  return {document.mesh().count(0), document.mesh().count(2), document.journal().size(),
          document.journal().words().size(), io::fingerprint(document.mesh())};
}

Made run_alone() {
  Session s;
  drive(s, {"sample bracket"});
  set_limits(s);
  drive(s, {"run"});
  return made_of(s);
}

/// As a window goes through a run: a little at a time, with everything brought up to date and the
/// mouse somewhere else in between.
void run_in_slices(Session& s) {
  execute(s, "run");
  double x = -0.9;
  for (int i = 0; i < 100'000 && !s.idle(); ++i) {
    s.tick(std::chrono::microseconds(300), 0.01);
    s.refresh();
    s.hover(glm::dvec2(x, 0.1));
    x = x > 0.9 ? -0.9 : x + 0.07;
  }
  s.finish();
  s.refresh();
}

TEST(Looking, BeforeARunChangesNothingOfIt) {
  const Made alone = run_alone();
  EXPECT_EQ(alone.faces, 224u);
  for (const char* look : {"color verdict", "select edge 7", "panel histograms on"}) {
    for (const bool later : {false, true}) {
      Session s;
      drive(s, {"sample bracket"});
      if (later) set_limits(s);
      drive(s, {look, "select vertex 3"});
      if (!later) set_limits(s);
      drive(s, {"run"});
      EXPECT_EQ(made_of(s), alone) << look << (later ? " with the limits" : " before the limits");
    }
  }
}

TEST(Looking, WhileARunGoesOnChangesNothingOfIt) {
  const Made alone = run_alone();
  for (const char* look : {"color verdict", "select edge 7"}) {
    Session s;
    drive(s, {"sample bracket", look});
    set_limits(s);
    run_in_slices(s);
    EXPECT_EQ(made_of(s), alone) << look;
  }
}

TEST(Looking, AtOtherLimitsOrAtTheEndChangesNothingOfTheNextRun) {
  const Made alone = run_alone();
  Session s;
  drive(s, {"sample bracket", "strategy quality", "max-distance 1", "target-faces 50",
            "color verdict", "run", "select edge 182", "reset", "select edge 7"});
  set_limits(s);
  run_in_slices(s);
  EXPECT_EQ(made_of(s), alone);
  drive(s, {"undo", "select edge 300", "color verdict"});
  run_in_slices(s);
  EXPECT_EQ(made_of(s), alone);
}

}  // namespace
}  // namespace aomd::scene::looking_test
