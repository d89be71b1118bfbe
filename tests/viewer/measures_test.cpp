// What a selection is measured to be.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/support/view_helpers.h"
#include "viewer/explain/measures.h"

namespace aomd::scene::measures_test {
namespace {

using test::drive;
using test::load;
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A face of sides 3, 4 and 5, below a tetrahedron of height 6.
MeshData right_tet() {
  MeshData data;
  data.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 6}};
  data.faces.add(Shape::Triangle, {0, 2, 1}, ModelRef(2, 1));
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 3}, ModelRef(3, 1));
  return data;
}

Facts facts(const Session& s) {
  return measure_selection(s.document().mesh(), s.sheet().selection).facts;
}

TEST(Measures, TwoVerticesAreADistanceApart) {
  Session s;
  load(s, right_tet());
  drive(s, {"select vertex 1 2"});
  EXPECT_EQ(
      facts(s),
      (Facts{{"Distance", "5"}, {"    along x", "3"}, {"    along y", "4"}, {"    along z", "0"}}));
  EXPECT_EQ(rulers_of(s.sheet().selection), (std::vector<Ruler>{{Vertex(1), Vertex(2)}}));
  EXPECT_EQ(s.sheet().drawing().drawable().rulers.lines.size(), 2u) << "the line and its rim";
  drive(s, {"expect measured = 5", "select none"});
  EXPECT_EQ(s.sheet().drawing().drawable().rulers.lines.size(), 0u);
}

TEST(Measures, ThreeVerticesHaveAngles) {
  Session s;
  load(s, right_tet());
  drive(s, {"select vertex 0 1 2"});
  EXPECT_EQ(facts(s), (Facts{{"From 0 to 1", "3"},
                             {"From 1 to 2", "5"},
                             {"From 2 to 0", "4"},
                             {"Angle at 0", "90\u00b0"},
                             {"Angle at 1", "53.13\u00b0"},
                             {"Angle at 2", "36.87\u00b0"},
                             {"Area between", "6"}}));
  EXPECT_EQ(rulers_of(s.sheet().selection).size(), 3u);
}

TEST(Measures, WhatIsOfOneKindIsAddedUp) {
  Session s;
  load(s, right_tet());
  drive(s, {"select face 0"});
  EXPECT_EQ(facts(s), (Facts{{"Area", "6"}}));
  drive(s, {"select region 0"});
  EXPECT_EQ(facts(s), (Facts{{"Volume", "12"}}));
  drive(s, {"sample box 1", "select face 0 1 2"});
  EXPECT_EQ(facts(s)[0].first, "Area of all");
  EXPECT_TRUE(rulers_of(s.sheet().selection).empty());
}

TEST(Measures, OtherSelectionsAreNotMeasured) {
  Session s;
  load(s, right_tet());
  for (const char* line : {"select none", "select vertex 0", "select vertex 0 1 2 3"}) {
    drive(s, {line});
    EXPECT_TRUE(facts(s).empty()) << line;
  }
  drive(s, {"select vertex 0 1", "select add face 0"});
  EXPECT_TRUE(facts(s).empty());
  EXPECT_TRUE(rulers_of(s.sheet().selection).empty());
}

TEST(Measures, ARegionSaysHowLargeItIs) {
  Session s;
  load(s, right_tet());
  drive(s, {"select region 0"});
  const auto& listed = s.sheet().inquiry().facts()->facts;
  EXPECT_NE(
      std::find(listed.begin(), listed.end(), std::pair<std::string, std::string>("Volume", "12")),
      listed.end());
}

}  // namespace
}  // namespace aomd::scene::measures_test
