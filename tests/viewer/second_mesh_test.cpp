// A session in which something was done to one mesh shows another mesh as a new session does.

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"
#include "viewer/commands/tables.h"

namespace aomd::scene::second_mesh_test {
namespace {

using test::drive;
using Lines = std::vector<std::string>;

void drive_all(Session& session, const Lines& lines) {
  for (const std::string& line : lines) drive(session, {line});
}

template <typename T>
void add(std::ostringstream& out, const char* name, const Patched<T>& values) {
  const auto bytes = std::as_bytes(values.values());
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  out << name << ' ' << values.size() << ' ' << std::hash<std::string_view>()(text) << '\n';
}

void add(std::ostringstream& out, const char* name, const Overlay& overlay) {
  add(out, name, overlay.faces);
  add(out, name, overlay.lines);
  add(out, name, overlay.discs);
}

std::string drawn(const Drawable& drawable) {
  std::ostringstream out;
  add(out, "corners", drawable.corners);
  add(out, "cells", drawable.cells);
  add(out, "interior edges", drawable.interior_edges);
  add(out, "model edges", drawable.model_edges);
  add(out, "model vertices", drawable.model_vertices);
  add(out, "highlight lines", drawable.highlight_lines);
  add(out, "highlight discs", drawable.highlight_discs);
  add(out, "before", drawable.before);
  add(out, "selected", drawable.selected);
  add(out, "hovered", drawable.hovered);
  add(out, "preview", drawable.preview);
  return out.str();
}

std::string looked_at(const View& view) {
  std::ostringstream out;
  out << view.camera.to_text() << '\n';
  out << "clip " << view.clip.has_value() << " shrink " << view.shrink << " hidden "
      << view.hidden.size() << " highlighted " << view.highlighted.has_value() << " marked "
      << view.marked.has_value() << " menu " << view.menu.has_value() << " operation "
      << view.operation << " dialog " << static_cast<int>(view.dialog) << '\n';
  return out.str();
}

std::string history(const Document& document) {
  std::ostringstream out;
  for (const std::string& label : test::labels(document)) out << label << ' ';
  out << "cursor " << document.journal().cursor() << " branches "
      << document.tree().branches().size() << " bookmarks " << document.tree().bookmarks().size()
      << " unsaved " << document.unsaved() << " stop " << document.stop() << " spacing "
      << document.spacing_source() << " distance " << document.options().max_distance << " trial "
      << (document.trial() != nullptr) << " sweep " << (document.last_sweep() != nullptr) << '\n';
  return out.str();
}

std::string known(const Sheet& sheet) {
  const Inquiry& inquiry = sheet.inquiry();
  std::ostringstream out;
  out << "hovered " << (inquiry.hovered() != nullptr) << inquiry.hovered_words() << " facts "
      << (inquiry.facts() != nullptr) << " verdict " << (inquiry.verdict() != nullptr)
      << " neighbours " << (inquiry.neighbours() != nullptr) << " model entity "
      << (inquiry.model_entity() != nullptr) << " storage " << (sheet.storage() != nullptr)
      << " reference " << sheet.reference_name() << ' ' << sheet.reference_size() << '\n';
  if (sheet.verdicts() != nullptr)
    for (const std::int64_t count : sheet.verdicts()->counts()) out << count << ' ';
  if (sheet.field() != nullptr)
    out << "scale " << sheet.field()->scale.low << ' ' << sheet.field()->scale.high;
  if (const Histograms* histograms = sheet.histograms())
    for (const HistogramPair& pair : histograms->pairs)
      out << " samples " << pair.samples.size() << ' ' << pair.earlier.size();
  return out.str() + '\n';
}

/// All that a user could see of it, but for how long things took.
std::string seen(Session& s) {
  s.refresh();
  Sheet& sheet = s.sheet();
  std::string text = s.status + '\n' + s.error + '\n' + looked_at(s.view) + history(s.document()) +
                     known(sheet) + selection_text(sheet.selection) + '\n' +
                     drawn(sheet.drawing().drawable());
  for (const char* table : {"counts", "legend", "adjacency", "hashes", "ids", "sweeps"})
    text += table_text(s, table);
  for (const KeptRun& run : sheet.runs.rows())
    text += run.name + ' ' + std::to_string(run.cells) + ' ' +
            std::to_string(run.distance.has_value()) + '\n';
  text += "reference " + std::to_string(sheet.shows_reference()) + '\n';
  if (SurfaceDrawing* reference = sheet.reference_drawing()) text += drawn(reference->drawable());
  return text + std::to_string(s.idle());
}

/// Something that is done to the first mesh. What belongs to the window stays, so that a new
/// session does it too.
struct Case {
  std::string name;
  Lines window;
  Lines first;
  std::string second = "sample torus 24";
  Lines then = {"run", "compare with 1", "compare side", "select edge 3", "color quality"};
};

class SecondMesh : public testing::TestWithParam<Case> {};

TEST_P(SecondMesh, LooksAsInANewSession) {
  const Case& c = GetParam();
  Session used, fresh;
  drive_all(used, c.window);
  drive_all(fresh, c.window);
  drive_all(used, c.first);
  drive(used, {c.second});
  drive(fresh, {c.second});
  EXPECT_EQ(seen(used), seen(fresh));
  drive_all(used, c.then);
  drive_all(fresh, c.then);
  EXPECT_EQ(seen(used), seen(fresh));
}

std::vector<Case> cases() {
  const std::string mesh = "sample bracket 6";
  const Lines of_a_volume = {"clip x 0.4 cells", "select region 2", "highlight region:1"};
  return {
      {"Runs", {"compare side"}, {mesh, "run", "compare with 1"}},
      {"TheSameRun", {"compare side"}, {"sample torus 24", "run", "compare with 1"}},
      {"MeasuredRuns",
       {"panel runs on"},
       {mesh, "run", "undo", "step 9", "runs keep", "runs measure"}},
      {"Glass", {"show original on", "color distance"}, {mesh, "sweep"}},
      {"Selection", {}, {mesh, "select vertex 3 6 9"}},
      {"OneEdge", {"preview 2", "panel selection on"}, {mesh, "select edge 5"}},
      {"Neighbours", {"sample torus 24", "neighbours vertex"}, {mesh, "select vertex 5"}},
      {"Hover", {}, {mesh, "hover 0 0"}},
      {"Menu", {}, {mesh, "menu 0 0"}},
      {"Mark", {"panel histograms on"}, {mesh, "mark valence 6"}},
      {"Histograms", {"panel histograms on"}, {mesh, "step 20"}},
      {"Bookmarks", {}, {mesh, "step 5", "bookmark here", "undo", "step 3"}},
      {"Focus", {"operation both"}, {mesh, "step 5"}},
      {"Clip", {}, {mesh, "clip x 0.5"}},
      {"Cells", {}, {mesh, "clip z 0.4 cells flip"}},
      {"Shrink", {}, {mesh, "shrink 0.3"}},
      {"Hidden", {"panel selection on"}, {mesh, "hide face:1", "highlight face:2"}},
      {"Spacing", {"color spacing"}, {mesh, "spacing 0.5", "step 4"}},
      {"MaxDistance", {}, {mesh, "max-distance 5", "step 4"}},
      {"Quality", {"color quality"}, {mesh, "step 4"}},
      {"Distance", {"color distance"}, {mesh, "step 4"}},
      {"Curvature", {"color curvature"}, {mesh, "step 4"}},
      {"Verdicts", {"color verdict"}, {mesh, "step 4"}},
      {"Storage", {"strategies on"}, {mesh, "strategies run"}},
      {"Trial", {}, {"sample sphere 8", "feature-preview 30"}},
      {"Adjacency", {}, {mesh, "adjacency 3 0 on", "hash-sets build edge"}},
      {"Classes", {}, {"sample sphere 8", "promote edge 5", "step"}},
      {"Camera", {}, {mesh, "orbit 30 20", "pan 0.2 0.1", "zoom 3", "camera up=y"}},
      {"Lesson", {}, {"lesson stored 2"}},
      {"Volume", {}, {"sample mixed", "highlight region:1", "clip x 0.5", "select region 3"}},
      {"Sections", {}, {"sample mixed", "clip x 0.5 cells", "shrink 0.2", "hide region:1"}},
      {"Sections2", {"show interior-edges on"}, {"sample mixed", "mark angle 40"}},
      {"ThenAVolume",
       {},
       {mesh, "run", "reset", "select vertex 3", "clip x 0.5"},
       "sample mixed",
       of_a_volume},
      {"VolumeThenVolume",
       {},
       {"sample mixed", "clip x 0.5", "shrink 0.5", "select region 3"},
       "sample tet-box 3",
       of_a_volume},
  };
}

INSTANTIATE_TEST_SUITE_P(OfEveryKindOfState, SecondMesh, testing::ValuesIn(cases()),
                         [](const auto& each) { return each.param.name; });

/// Loads another mesh while something goes on.
std::string after_interrupting(const Lines& before, const Lines& under_way) {
  Session s;
  drive_all(s, before);
  for (const std::string& line : under_way) execute(s, line);
  execute(s, "sample torus 24");
  s.finish();
  drive(s, {"step 3"});
  return seen(s);
}

TEST(SecondMeshMeanwhile, WhatGoesOnEndsWithItsMesh) {
  const aomd::test::TemporaryFolder folder;
  Session fresh;
  drive(fresh, {"sample torus 24", "step 3"});
  const std::string expected = seen(fresh);
  const Lines mesh = {"sample bracket 6"}, history = {"sample bracket 6", "step 50", "reset"};
  EXPECT_EQ(after_interrupting(mesh, {"run"}), expected);
  EXPECT_EQ(after_interrupting(history, {"play on"}), expected);
  EXPECT_EQ(after_interrupting(mesh, {"strategies run"}), expected);
  EXPECT_EQ(after_interrupting({"sample bracket 6", "run"}, {"runs measure"}), expected);
}

TEST(SecondMeshMeanwhile, ASeriesOfPicturesEndsWithItsMesh) {
  const aomd::test::TemporaryFolder folder;
  Session fresh, s;
  drive(fresh, {"sample torus 24"});
  drive(s, {"sample bracket 6", "step 9"});
  execute(s, "sample torus 24");
  execute(s, "export history " + (folder / "h").string() + " 4");
  s.advance_series();
  s.finish();
  EXPECT_EQ(s.series(), nullptr);
  EXPECT_TRUE(s.screenshots.empty());
  EXPECT_EQ(seen(s), seen(fresh));
}

TEST(Reference, TheStateThatIsComparedWithNeverMakesWay) {
  Session s;
  drive(s, {"sample bracket 6", "run", "compare with 1", "compare side"});
  const std::string before = drawn(s.sheet().reference_drawing()->drawable());
  for (std::size_t i = 0; i < 2 * KeptRuns::most; ++i) drive(s, {"step -1", "runs keep"});
  EXPECT_EQ(s.sheet().runs.size(), KeptRuns::most);
  EXPECT_EQ(s.sheet().reference_name(), "Run 1");
  EXPECT_EQ(s.sheet().runs.rows()[1].number, 2 + KeptRuns::most + 1);
  EXPECT_EQ(drawn(s.sheet().reference_drawing()->drawable()), before);
  drive(s, {"runs remove 1"});
  EXPECT_EQ(s.sheet().reference_name(), "as loaded");
}

}  // namespace
}  // namespace aomd::scene::second_mesh_test
