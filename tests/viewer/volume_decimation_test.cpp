// Volumes are decimated, taken back, kept and compared as surfaces are, and the drawing follows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/io/io.h"
#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/view_helpers.h"
#include "viewer/base/entity_text.h"
#include "viewer/drawing/skin_keeper.h"

namespace aomd::scene {
namespace {

using aomd::test::TemporaryFolder;
using test::drive;
using test::labels;

io::MeshFingerprint print_of(const Session& s) { return io::fingerprint(s.document().mesh()); }

template <typename T>
bool same(const Patched<T>& a, const Patched<T>& b) {
  return a.size() == b.size() &&
         std::memcmp(a.values().data(), b.values().data(), a.size() * sizeof(T)) == 0;
}

/// What is shown is what somebody shows who sees the mesh for the first time.
void expect_as_from_scratch(Session& s) {
  s.refresh();
  const Document& document = s.document();
  const Skin skin(document.mesh());
  const SkinSource source{document.mesh(), skin, document.content().bounds, {}};
  SkinKeeper keeper;
  keeper.update(source, s.view);
  SurfaceChanges everything;
  everything.everything = true;
  SurfaceDrawing fresh;
  fresh.set_bounds(document.content().bounds);
  fresh.set_face_flags(keeper.surface()->flags);
  keeper.draw_inside(source, fresh);
  fresh.set_whole_faces(false);
  fresh.update(keeper.surface()->mesh, s.view, everything);
  const Drawable &shown = s.sheet().drawing().drawable(), &made = fresh.drawable();
  EXPECT_TRUE(same(shown.corners, made.corners));
  EXPECT_TRUE(same(shown.cells, made.cells));
  EXPECT_TRUE(same(shown.interior_edges, made.interior_edges));
  EXPECT_TRUE(same(shown.model_edges, made.model_edges));
  EXPECT_EQ(s.sheet().facts(), volume_facts(document.mesh(), skin));
}

TEST(VolumeDecimation, DrawingAndFactsFollowEveryOperationAndItsUndoing) {
  Session s;
  drive(s, {"sample ball-in-box 3", "clip x 0.5 cells", "show interior-edges on"});
  const std::size_t listed = s.document().mesh().count(3);
  for (int i = 0; i < 8; ++i) {
    drive(s, {"step"});
    expect_as_from_scratch(s);
  }
  EXPECT_LT(s.document().mesh().count(3), listed);
  for (const char* line : {"sweep", "swap", "smooth", "shrink 0.3", "step -5", "clip x 0.4", "undo",
                           "redo", "seek 3", "seek end", "reset"}) {
    drive(s, {line});
    SCOPED_TRACE(line);
    expect_as_from_scratch(s);
  }
}

TEST(VolumeDecimation, UndoneItIsTheMeshThatItBeganWith) {
  Session s;
  drive(s, {"sample ball-in-box 3", "color verdict"});
  const auto before = print_of(s);
  drive(s, {"step", "sweep", "swap", "smooth", "improve", "run"});
  EXPECT_TRUE(verify(s.document().mesh()).empty());
  const auto after = print_of(s);
  EXPECT_LT(after.counts[3], before.counts[3]);
  drive(s, {"reset"});
  EXPECT_EQ(print_of(s), before);
  drive(s, {"seek end"});
  EXPECT_EQ(print_of(s), after);
  drive(s, {"undo", "redo"});
  EXPECT_EQ(print_of(s), after);
}

TEST(VolumeDecimation, StopsAtANumberOfTetrahedraAndSaysSo) {
  Session s;
  drive(s, {"sample ball-in-box 3"});
  const std::uint32_t aim = s.document().mesh().count(3) * 3 / 4;
  execute(s, "target-faces " + std::to_string(aim));
  drive(s, {"run"});
  EXPECT_LE(s.document().mesh().count(3), aim);
  EXPECT_NE(s.document().stop().find(" tetrahedra."), std::string_view::npos);
  EXPECT_EQ(s.status, "Run finished: " + size_words(s.document().mesh()));
}

TEST(VolumeDecimation, RunsAreKeptOnBranchesAndCompared) {
  Session s;
  drive(s, {"sample ball-in-box 3", "panel runs on", "factor 1.5", "run"});
  const auto first = print_of(s);
  drive(s, {"undo", "factor 3", "run", "expect branches = 1", "expect runs = 2"});
  const KeptRun* run = s.sheet().runs.find(1);
  ASSERT_NE(run, nullptr);
  EXPECT_EQ(run->cells, first.counts[3]);
  drive(s, {"compare with 1", "compare side"});
  EXPECT_TRUE(s.sheet().side_by_side());
  ASSERT_NE(s.sheet().reference_drawing(), nullptr);
  const SurfaceDrawing& reference = *s.sheet().reference_drawing();
  const std::vector<Corner> beside(reference.drawable().corners.values().begin(),
                                   reference.drawable().corners.values().end());
  drive(s, {"runs go 1"});
  EXPECT_EQ(print_of(s), first);
  EXPECT_EQ(beside.size(), test::corners(s).size());
  drive(s, {"runs measure"});
  EXPECT_TRUE(s.sheet().runs.find(1)->distance.has_value());
}

TEST(VolumeDecimation, ComesBackAfterTheProgramDied) {
  const TemporaryFolder folder;
  const std::initializer_list<std::string_view> lines = {"sample ball-in-box 3", "step 5", "sweep",
                                                         "swap", "step -3"};
  {
    Session died;
    died.keep_work(folder / "");
    drive(died, lines);
    died.recovery->write_now(died.document());
  }
  Session expected, s;
  drive(expected, lines);
  s.keep_work(folder / "");
  ASSERT_EQ(s.found_work.works.size(), 1u);
  drive(s, {"recover"});
  EXPECT_EQ(print_of(s), print_of(expected));
  EXPECT_EQ(labels(s.document()), labels(expected.document()));
  expect_as_from_scratch(s);
  drive(s, {"reset"});
  drive(expected, {"reset"});
  EXPECT_EQ(print_of(s), print_of(expected));
}

TEST(VolumeDecimation, EveryEdgeThatIsDrawnHasAVerdict) {
  Session s;
  drive(s, {"sample ball-in-box 3", "clip x 0.5 cells", "color verdict"});
  ASSERT_NE(s.sheet().verdicts(), nullptr);
  EXPECT_EQ(s.sheet().verdicts()->counts()[unjudged], 0);
  const auto coded = [&] {
    for (const Corner& c : test::corners(s))
      for (int side = 0; side < 3; ++side)
        if ((c.flags >> (edge_code_shift + 4 * side) & 15u) == unjudged) return false;
    return true;
  };
  EXPECT_TRUE(coded());
  drive(s, {"select edge 0"});
  ASSERT_NE(s.sheet().inquiry().verdict(), nullptr);
  EXPECT_FALSE(short_words(*s.sheet().inquiry().verdict()).empty());
  drive(s, {"step", "clip x 0.4 cells"});
  EXPECT_TRUE(coded());
}

// The sample's temperature is linear, so that a vertex which has moved shows what became of it.
TEST(VolumeDecimation, WhatIsSavedHasArraysThatBelongToIt) {
  const TemporaryFolder folder;
  const std::string file = (folder / "beam.vtu").string();
  Session s;
  drive(s, {"sample layered-beam 2", "factor 2", "run", "save " + file});
  EXPECT_EQ(s.status.find("left out"), std::string::npos) << s.status;
  const MeshData saved = io::read(file).mesh;
  ASSERT_LT(saved.regions.size(), make_sample("layered-beam", 2).regions.size());
  ASSERT_EQ(saved.attributes.size(), 2u);
  for (std::size_t i = 0; i < saved.positions.size(); ++i)
    EXPECT_NEAR(saved.attributes[0].values[i],
                400 - 8 * saved.positions[i].x - 5 * saved.positions[i].z, 1e-10);
  drive(s, {"undo", "save " + file});
  EXPECT_EQ(io::read(file).mesh.attributes, make_sample("layered-beam", 2).attributes);
}

TEST(VolumeDecimation, ArraysThatAMeshDoesNotHoldAreNamed) {
  const TemporaryFolder folder;
  MeshData mesh = make_sample("tet-box", 2);
  mesh.attributes = {{"u", 0, 1, false, std::vector<double>(mesh.positions.size())},
                     {"stress", 3, 6, false, std::vector<double>(6 * mesh.regions.size())}};
  io::write(folder / "a.vtu", mesh);
  Session s;
  drive(s, {"open " + (folder / "a.vtu").string()});
  EXPECT_EQ(s.document().content().notes,
            std::vector<std::string>{"left out: attribute \"stress\""});
}

TEST(VolumeDecimation, WhatIsForSurfacesAloneIsRefusedWithASentence) {
  Session s;
  drive(s, {"sample ball-in-box 3"});
  for (const char* line : {"topology paper", "strategies run"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  Session other;
  drive(other, {"sample sphere 8", "topology paper", "sample ball-in-box 3", "step"});
  EXPECT_EQ(other.document().journal().size(), 1u)
      << "among tetrahedra topology paper does not hold";
}

}  // namespace
}  // namespace aomd::scene
