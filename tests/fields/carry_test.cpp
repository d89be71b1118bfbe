// Arrays of volumes go along: on vertices, and what holds for all.

#include <gtest/gtest.h>

#include "core/fields/vertex_values.h"
#include "tests/support/field_helpers.h"

namespace aomd::test::carry_test {
namespace {

double largest_error(const MeshData& mesh, const Attribute& a, const Function& f) {
  double worst = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    worst = std::max(worst, std::abs(a.values[i] - f(mesh.positions[i])));
  return worst;
}

// Curved and flat model faces, model edges; what moves off the original is carried on to.
TEST(Carry, LinearFunctionsStay) {
  for (const char* sample : {"ball-in-box", "layered-beam", "tet-bracket", "tet-ball"}) {
    MeshData mesh = make_sample(sample);
    mesh.attributes = {field(mesh, "u", 0, slanted)};
    Attribute six{"six", 0, 6, false, {}};
    for (const glm::dvec3& p : mesh.positions)
      for (int k = 0; k < 6; ++k) six.values.push_back(k - slanted(p));
    mesh.attributes.push_back(six);
    const MeshData result = decimated(mesh, 0.25).mesh;
    ASSERT_LT(result.regions.size(), mesh.regions.size() / 3) << sample;
    EXPECT_LT(largest_error(result, *find(result, "u", 0), slanted), 1e-12) << sample;
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t i = 0; i < result.positions.size(); ++i)
        ASSERT_NEAR(find(result, "six", 0)->values[6 * i + k],
                    static_cast<double>(k) - slanted(result.positions[i]), 1e-12);
  }
}

TEST(Carry, VerticesThatStayKeepTheirBits) {
  MeshData mesh = make_sample("ball-in-box", 4);
  mesh.attributes = {field(mesh, "u", 0, [](const glm::dvec3& p) { return std::sin(40 * p.x); })};
  const MeshData result = decimated(mesh, 0.5).mesh;
  std::map<std::array<double, 3>, double> known;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    known[{mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z}] =
        mesh.attributes[0].values[i];
  std::size_t same = 0;
  for (std::size_t i = 0; i < result.positions.size(); ++i) {
    const glm::dvec3& p = result.positions[i];
    const auto at = known.find({p.x, p.y, p.z});
    if (at == known.end()) continue;
    ++same;
    EXPECT_EQ(result.attributes[0].values[i], at->second);
  }
  EXPECT_GT(same, 8u);
}

TEST(Carry, TheSameForAnyNumberOfThreads) {
  MeshData mesh = make_sample("ball-in-box", 6);
  const auto wave = [](const glm::dvec3& p) { return std::sin(9 * p.x) * p.y; };
  mesh.attributes = {field(mesh, "u", 0, wave), field(mesh, "f", 2, wave),
                     field(mesh, "c", 3, wave)};
  const MeshData one = decimated(mesh, 0.25, 1).mesh;
  EXPECT_EQ(one.attributes.size(), 3u);
  EXPECT_TRUE(decimated(mesh, 0.25, 2).mesh == one);
  EXPECT_TRUE(decimated(mesh, 0.25, 8).mesh == one);
}

TEST(Carry, LabelsAreNeverMixed) {
  MeshData mesh = make_sample("layered-beam", 3);
  mesh.attributes = {{"v", 0, 1, true, {}}, {"c", 3, 2, true, {}}};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.attributes[0].values.push_back(mesh.positions[i].x < 5 ? -1000 : 1000);
  const fields::Cells cells(mesh, 3);
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    mesh.attributes[1].values.push_back(cells.centre(i).x < 5 ? 3 : 8);
    mesh.attributes[1].values.push_back(1e6);
  }
  const MeshData result = decimated(mesh, 0.25).mesh;
  const Attribute &v = *find(result, "v", 0), &c = *find(result, "c", 3);
  EXPECT_TRUE(v.integer && c.integer);
  for (std::size_t i = 0; i < result.positions.size(); ++i)
    if (std::abs(result.positions[i].x - 5) > 1.0 / 3) {
      EXPECT_EQ(v.values[i], result.positions[i].x < 5 ? -1000 : 1000);
    }
  const fields::Cells after(result, 3);
  for (std::uint32_t i = 0; i < after.size(); ++i) {
    EXPECT_TRUE(c.values[2 * i] == 3 || c.values[2 * i] == 8);
    if (std::abs(after.centre(i).x - 5) > 1) {
      EXPECT_EQ(c.values[2 * i], after.centre(i).x < 5 ? 3 : 8);
    }
    EXPECT_EQ(c.values[2 * i + 1], 1e6);
  }
}

TEST(Carry, WhatCornersAreWorth) {
  const double nan = std::nan("");
  const fields::VertexSource most{{0, 1, 2, 3}, {0.1, 0.2, 0.3, 0.4}},
      second{{0, 1, 2, 3}, {0.1, 0.6, 0.2, 0.1}}, none{{0, 1, 2, 3}, {0.5, 0, 0.5, 0}};
  const Attribute label{"l", 0, 1, true, {7, 8, 9, 5}}, real{"u", 0, 1, false, {1, nan, 3, 4}};
  EXPECT_EQ(fields::at_vertices(label, {most, second}).values, (std::vector<double>{5, 8}));
  const std::vector<double> values = fields::at_vertices(real, {most, second, none}).values;
  EXPECT_DOUBLE_EQ(values[0], (0.1 * 1 + 0.3 * 3 + 0.4 * 4) / 0.8) << "what is known decides";
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_DOUBLE_EQ(values[2], 2);
  EXPECT_TRUE(std::isnan(fields::at_vertices(real, {fields::VertexSource()}).values[0]));
}

/// The first mesh and a copy of it beside, whose vertices are its own.
MeshData doubled(const MeshData& mesh, const glm::dvec3& by) {
  MeshData both = mesh;
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3& p : mesh.positions) both.positions.push_back(p + by);
  for (const std::uint32_t v : mesh.regions.vertices) both.regions.vertices.push_back(v + n);
  both.regions.shapes.insert(both.regions.shapes.end(), mesh.regions.shapes.begin(),
                             mesh.regions.shapes.end());
  both.vertex_classes.clear();
  both.edges = both.faces = {};
  both.regions.classes.clear();
  return both;
}

// Two cubes that touch, with a jump from one to the other.
TEST(Carry, PartsThatTouchKeepTheirOwnValues) {
  MeshData mesh = doubled(make_sample("tet-box", 6), {1, 0, 0});
  const std::size_t n = mesh.positions.size() / 2;
  mesh.attributes = {{"jump", 0, 1, false, std::vector<double>(2 * n, 1)}};
  std::fill_n(mesh.attributes[0].values.begin(), n, -1);
  EXPECT_GT(uses_at_contact(decimated(mesh, 0.25).mesh, 3), 10u);
}

TEST(Carry, WhatIsNoNumberSpreadsNoFurtherThanTheCellsAround) {
  MeshData mesh = make_sample("tet-box", 8);
  mesh.attributes = {field(mesh, "u", 0, slanted), field(mesh, "c", 3, slanted)};
  const double nan = std::nan("");
  const auto bad = [](const glm::dvec3& p) { return glm::length(p - glm::dvec3(0.5)) < 0.3; };
  const fields::Cells cells(mesh, 3);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (bad(mesh.positions[i])) mesh.attributes[0].values[i] = nan;
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    if (bad(cells.centre(i))) mesh.attributes[1].values[i] = i % 2 == 0 ? nan : INFINITY;
  const Carried result = decimated(mesh, 0.4);
  const Attribute &u = *find(result.mesh, "u", 0), &c = *find(result.mesh, "c", 3);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < result.mesh.positions.size(); ++i) {
    const double far = glm::length(result.mesh.positions[i] - glm::dvec3(0.5));
    missing += !std::isfinite(u.values[i]);
    if (far > 0.3 + 0.22) {
      EXPECT_NEAR(u.values[i], slanted(result.mesh.positions[i]), 1e-12);
    }
    if (far < 0.15) {
      EXPECT_TRUE(std::isnan(u.values[i]));
    }
  }
  EXPECT_GT(missing, 3u);
  const fields::Cells after(result.mesh, 3);
  for (std::uint32_t i = 0; i < after.size(); ++i)
    if (glm::length(after.centre(i) - glm::dvec3(0.5)) > 0.6) {
      EXPECT_TRUE(std::isfinite(c.values[i]));
    }
  ASSERT_EQ(result.along.notes.size(), 1u);
  const std::size_t before = result.along.fields[0].before.missing;
  EXPECT_EQ(result.along.notes[0].find("values that are no numbers: \"u\" on vertices " +
                                       std::to_string(before) + " before and " +
                                       std::to_string(missing) + " after, \"c\" on regions "),
            0u)
      << result.along.notes[0];
}

TEST(Carry, WhatMeditSaysAndLinksAreLeftOut) {
  MeshData mesh = make_sample("tet-box", 4);
  mesh.attributes = {{"medit:normal", 0, 3, false, std::vector<double>(3 * mesh.positions.size())},
                     field(mesh, "u", 0, slanted)};
  mesh.periodic = {{{2, 1}, {2, 2}, {}, {{0, 3}}}};
  const Carried result = decimated(mesh, 0.5);
  EXPECT_EQ(result.along.notes,
            std::vector<std::string>{"left out, as it does not follow the operations: periodic "
                                     "links, \"medit:normal\""});
  ASSERT_EQ(result.mesh.attributes.size(), 1u);
  EXPECT_EQ(result.mesh.attributes[0].name, "u");
}

TEST(Carry, NothingWithoutArrays) {
  MeshData mesh = make_sample("tet-box", 4);
  const Carried result = decimated(mesh, 0.5);
  EXPECT_TRUE(result.along.fields.empty() && result.along.notes.empty());
  EXPECT_TRUE(result.mesh.attributes.empty());
}

}  // namespace
}  // namespace aomd::test::carry_test
