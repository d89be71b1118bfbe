// Tables and cameras as text, through the clipboard of a session without a window.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"
#include "viewer/commands/tables.h"

namespace aomd::scene::tables_test {
namespace {

using test::drive;

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == '\t')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    rows.push_back(cells);
  }
  return rows;
}

std::string cell(const std::vector<std::vector<std::string>>& rows, const std::string& name,
                 std::size_t column) {
  for (const auto& row : rows)
    if (row.at(0) == name) return row.at(column);
  return "no row " + name;
}

TEST(Tables, EveryOneHasTitlesAndRowsAsWideAsThem) {
  Session s;
  drive(s, {"sample bracket 6", "sweep", "runs keep", "select class face:1"});
  for (const std::string_view name : table_names()) {
    const auto rows = rows_of(table_text(s, name));
    ASSERT_GT(rows.size(), 1u) << name;
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size()) << name << ": " << row[0];
  }
}

TEST(Tables, CountsAreThoseOfThePanelNowAndAsLoaded) {
  Session s;
  drive(s, {"sample sphere 8", "step 4", "copy counts"});
  const auto rows = rows_of(s.clipboard.get());
  EXPECT_EQ(cell(rows, "Faces", 1), std::to_string(s.sheet().facts().faces));
  EXPECT_EQ(cell(rows, "Faces", 2), std::to_string(s.sheet().loaded_facts().faces));
  EXPECT_EQ(cell(rows, "Euler number", 1), "2");
}

TEST(Tables, CountsOfAVolumeHaveItsRegions) {
  Session s;
  drive(s, {"sample tet-box 2", "copy counts"});
  EXPECT_EQ(cell(rows_of(s.clipboard.get()), "Regions", 1),
            std::to_string(s.sheet().facts().regions));
}

TEST(Tables, TheLegendSaysWhatIsHidden) {
  Session s;
  drive(s, {"sample bracket 6", "hide face:2", "copy legend"});
  const auto rows = rows_of(s.clipboard.get());
  EXPECT_EQ(cell(rows, "face:2", 2), "yes");
  EXPECT_EQ(cell(rows, "face:1", 2), "no");
  const auto faces = s.document().mesh().class_lists()->entities(2, ModelRef(2, 1)).size();
  EXPECT_EQ(cell(rows, "face:1", 1), std::to_string(faces));
}

TEST(Tables, AdjacencyHasTwelveRelations) {
  Session s;
  drive(s, {"sample sphere 8", "adjacency 1 2 on", "copy adjacency"});
  const auto rows = rows_of(s.clipboard.get());
  EXPECT_EQ(rows.size(), 13u);
  EXPECT_EQ(cell(rows, "T(1,2)", 1), "yes");
  EXPECT_EQ(cell(rows, "T(1,2)", 5), "2");  // each edge of a closed surface has two faces
  EXPECT_EQ(cell(rows, "T(2,1)", 1), "no");
}

TEST(Tables, RefusalsAndSweepsAreTitlesAloneBeforeTheFirstSweep) {
  Session s;
  drive(s, {"sample sphere 8"});
  EXPECT_EQ(rows_of(table_text(s, "refusals")).size(), 1u);
  EXPECT_EQ(rows_of(table_text(s, "sweeps")).size(), 1u);
  drive(s, {"sweep 2"});
  EXPECT_EQ(rows_of(table_text(s, "sweeps")).size(),
            1 + s.document().decimation()->sweeps().size());
}

TEST(Tables, CopyWritesAFileWhereOneIsNamed) {
  const aomd::test::TemporaryFolder folder;
  Session s;
  drive(s, {"sample sphere 8", "copy counts " + (folder / "a table.tsv").string()});
  EXPECT_EQ(aomd::test::bytes_of(folder / "a table.tsv"), table_text(s, "counts"));
  EXPECT_TRUE(s.clipboard.get().empty());
  EXPECT_THROW(execute(s, "copy everything"), CommandError);
}

TEST(CameraText, WhatIsCopiedIsPasted) {
  Session s;
  drive(s, {"sample sphere 8", "camera azimuth=12.5 elevation=-20 zoom=3 orthographic",
            "camera copy"});
  const Camera copied = s.view.camera;
  EXPECT_EQ(s.clipboard.get(), copied.to_text());
  drive(s, {"camera top perspective"});
  EXPECT_FALSE(s.view.camera == copied);
  drive(s, {"camera paste"});
  EXPECT_TRUE(s.view.camera == copied);
}

TEST(CameraText, OtherTextIsAnErrorThatKeepsTheCamera) {
  Session s;
  drive(s, {"sample sphere 8"});
  const Camera before = s.view.camera;
  for (const std::string& text :
       {std::string("a recipe for pancakes"), std::string(), std::string(100'000, 'x')}) {
    s.clipboard.set(text);
    try {
      execute(s, "camera paste");
      FAIL() << text.substr(0, 20);
    } catch (const CommandError& error) {
      EXPECT_LT(std::string(error.what()).size(), 1200u);
    }
    EXPECT_TRUE(s.view.camera == before);
  }
}

TEST(Clipboard, TheSystemsIsUsedWhereThereIsOne) {
  Session s;
  std::string system = "camera";
  s.clipboard.write_system = [&](const std::string& text) { system = text; };
  s.clipboard.read_system = [&] { return system; };
  drive(s, {"sample sphere 8", "camera front", "camera copy"});
  EXPECT_EQ(system, s.view.camera.to_text());
  system = "back";
  drive(s, {"camera paste"});
  EXPECT_EQ(s.view.camera.azimuth_deg, 180);
}

}  // namespace
}  // namespace aomd::scene::tables_test
