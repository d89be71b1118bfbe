// Volumes are decimated, taken back, kept and compared as surfaces are, and the drawing follows.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/io/io.h"
#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/view_helpers.h"
#include "viewer/base/entity_text.h"
#include "viewer/drawing/skin_keeper.h"

namespace aomd::scene::volume_decimation_test {
namespace {

using aomd::test::TemporaryFolder;
using test::drive;
using test::labels;

io::MeshFingerprint print_of(const Session& s) { return io::fingerprint(s.document().mesh()); }

/// Triangles without the places that are free, in one order for all: corners, colour and flags.
std::vector<std::array<std::uint32_t, 11>> triangles_of(const Patched<Corner>& corners) {
  std::vector<std::array<std::uint32_t, 11>> triangles;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (corners[i].position == corners[i + 1].position) continue;
    std::array<std::uint32_t, 11> t{};
    for (std::size_t k = 0; k < 3; ++k)
      std::memcpy(&t[3 * k], &corners[i + k].position, sizeof(glm::vec3));
    t[9] = corners[i].color;
    t[10] = corners[i].flags;
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<std::array<std::uint32_t, 8>> segments_of(const Patched<Segment>& lines) {
  std::vector<std::array<std::uint32_t, 8>> segments;
  for (const Segment& s : lines.values()) {
    if (s.width_px <= 0) continue;
    // A line is the same from both ends.
    std::array<std::array<std::uint32_t, 3>, 2> ends;
    std::memcpy(&ends[0], &s.a, sizeof s.a);
    std::memcpy(&ends[1], &s.b, sizeof s.b);
    std::sort(ends.begin(), ends.end());
    std::array<std::uint32_t, 8> each{};
    std::memcpy(each.data(), ends.data(), sizeof ends);
    each[6] = s.color;
    std::memcpy(&each[7], &s.width_px, sizeof(float));
    segments.push_back(each);
  }
  std::sort(segments.begin(), segments.end());
  return segments;
}

/// The normals at each corner's place, those of equal corners one after the other.
std::vector<std::pair<std::array<std::uint32_t, 5>, glm::vec3>> normals_of(
    const Patched<Corner>& corners) {
  std::vector<std::pair<std::array<std::uint32_t, 5>, glm::vec3>> normals;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (corners[i].position == corners[i + 1].position) continue;
    const glm::vec3 middle =
        corners[i].position + corners[i + 1].position + corners[i + 2].position;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<std::uint32_t, 5> key{};
      std::memcpy(&key[0], &middle, sizeof middle);
      key[3] = static_cast<std::uint32_t>(k);
      key[4] = corners[i].color;
      normals.emplace_back(key, unpack_normal(corners[i + k].normal));
    }
  }
  std::sort(normals.begin(), normals.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return normals;
}

/// Sums in another order may differ in the last of ten bits.
bool equal_normals(const Patched<Corner>& a, const Patched<Corner>& b) {
  const auto left = normals_of(a), right = normals_of(b);
  constexpr float two_bits = 2.1f / 511;
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const auto& p, const auto& q) {
                      const glm::vec3 d = glm::abs(p.second - q.second);
                      return p.first == q.first && std::max({d.x, d.y, d.z}) < two_bits;
                    });
}

/// What is shown is what somebody shows who sees the mesh for the first time.
void expect_as_from_scratch(Session& s) {
  s.refresh();
  const Document& document = s.document();
  const Skin skin(document.mesh());
  const SkinSource source{
      document.mesh(), [&]() -> const Skin& { return skin; }, document.content().bounds, {}};
  SkinKeeper keeper;
  SurfaceDrawing fresh;
  fresh.set_bounds(document.content().bounds);
  fresh.set_whole_faces(false);
  const SurfaceChanges everything = keeper.update(source, s.view, {}, fresh).surface;
  ASSERT_TRUE(everything.everything);
  fresh.update(keeper.surface()->mesh, s.view, everything);
  const Drawable &shown = s.sheet().drawing().drawable(), &made = fresh.drawable();
  EXPECT_EQ(triangles_of(shown.corners), triangles_of(made.corners));
  EXPECT_TRUE(equal_normals(shown.corners, made.corners));
  EXPECT_EQ(triangles_of(shown.cells), triangles_of(made.cells));
  EXPECT_EQ(segments_of(shown.interior_edges), segments_of(made.interior_edges));
  EXPECT_EQ(segments_of(shown.model_edges), segments_of(made.model_edges));
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

/// Random operations, seeks and branches under random cuts.
void follow_a_random_program(const std::string& sample, unsigned seed) {
  SCOPED_TRACE(sample + ", program " + std::to_string(seed));
  Session s;
  drive(s, {"sample " + sample, "factor 3"});
  std::mt19937 random(seed);
  const std::vector<std::string> looks = {
      "clip off",   "clip x 0.5",        "clip z 0.4 cells",           "clip y 0.6 cells flip",
      "shrink 0.2", "shrink 0",          "show interior-edges toggle", "hide region:1",
      "hide",       "highlight region:1"};
  const std::vector<std::string> works = {"step",    "step 3",           "step",          "step 7",
                                          "step -1", "step -5",          "undo",          "redo",
                                          "swap",    "smooth",           "seek end",      "reset",
                                          "step 20", "strategy quality", "strategy paper"};
  const auto any = [&](const auto& lines) { return lines[random() % lines.size()]; };
  for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i) {
    const std::string line = any(random() % 3 == 0 ? looks : works);
    SCOPED_TRACE(line);
    drive(s, {line});
    expect_as_from_scratch(s);
  }
}

TEST(VolumeDecimation, PatchesLeadToWhatIsMadeFromScratch) {
  for (const char* sample : {"ball-in-box 3", "tet-bracket 3", "layered-beam 3", "mixed"})
    for (unsigned seed = 1; seed <= 3; ++seed) follow_a_random_program(sample, seed);
}

TEST(VolumeDecimation, AStepUnderACutUploadsAFewKilobytes) {
  Session s;
  drive(s, {"sample ball-in-box 3", "clip x 0.5 cells", "show interior-edges on", "step 2"});
  Drawable& drawable = s.sheet().drawing().drawable();
  const auto dirty = [](const auto& array) {
    std::size_t sum = 0;
    for (const ElementRange& r : array.dirty()) sum += r.size();
    return sum;
  };
  for (int i = 0; i < 5; ++i) {
    drawable.corners.clean();
    drawable.interior_edges.clean();
    drive(s, {"step"});
    EXPECT_LT(dirty(drawable.corners), drawable.corners.size() / 4);
    EXPECT_LT(dirty(drawable.interior_edges), drawable.interior_edges.size() / 4);
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
                     {"stress", 3, 6, false, std::vector<double>(6 * mesh.regions.size())},
                     {"five", 3, 5, false, std::vector<double>(5 * mesh.regions.size())}};
  io::write(folder / "a.vtu", mesh);
  Session s;
  drive(s, {"open " + (folder / "a.vtu").string()});
  EXPECT_EQ(s.document().content().notes, std::vector<std::string>{"left out: attribute \"five\""});
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
}  // namespace aomd::scene::volume_decimation_test
