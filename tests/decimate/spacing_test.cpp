#include "core/decimate/spacing/spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glm/geometric.hpp>

#include "core/decimate/spacing/vertex_neighbours.h"
#include "core/model/classify.h"
#include "tests/support/io_helpers.h"
#include "tests/support/message.h"
#include "tests/support/zoo.h"

namespace aomd::spacing_test {
namespace {

using test::message;

constexpr double inf = std::numeric_limits<double>::infinity();

std::vector<double> values(const Mesh& mesh, const Column<Vertex, double>& column) {
  std::vector<double> list;
  for (const Vertex v : mesh.vertices()) list.push_back(column[v]);
  return list;
}

std::vector<double> spacing_of(const MeshData& data, const SpacingSource& source) {
  const Mesh mesh(data);
  return values(mesh, evaluate_spacing(mesh, source));
}

double length(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return glm::length(mesh.position(Vertex(a)) - mesh.position(Vertex(b)));
}

// Each edge once, from the template of whatever has it: slow and plain.
std::set<std::array<std::uint32_t, 2>> edges_of(const Mesh& mesh) {
  std::set<std::array<std::uint32_t, 2>> edges;
  VertexBuffer buffer;
  for (int dim = 1; dim <= 3; ++dim)
    for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
      const EntityRef e(dim, id);
      if (!mesh.alive(e)) continue;
      const auto v = mesh.vertices_of(e, buffer);
      if (dim == 1) edges.insert({std::min(v[0], v[1]), std::max(v[0], v[1])});
      const ShapeTemplate& shape = shape_template(mesh.shape(e));
      for (int k = 0; dim > 1 && k < shape.edge_count; ++k) {
        const std::uint32_t a = v[shape.sub(1, k).vertices[0]], b = v[shape.sub(1, k).vertices[1]];
        edges.insert({std::min(a, b), std::max(a, b)});
      }
    }
  return edges;
}

// Neighbours and factors
// -----------------------------------------------------------------------------------

//  3--2    sides are 1 long, the diagonal from 0 to 2 is sqrt(2)
//  | /|
//  |/ |
//  0--1
TEST(SpacingTest, AFactorCountsEachEdgeOnceAlsoAtTheBorder) {
  const double at_diagonal = (2 + std::sqrt(2.0)) / 3;
  const auto spacing = spacing_of(zoo::square(), {SpacingByFactor{3}, {}});
  ASSERT_EQ(spacing.size(), 4u);
  EXPECT_DOUBLE_EQ(spacing[0], 3 * at_diagonal);
  EXPECT_DOUBLE_EQ(spacing[1], 3);
  EXPECT_DOUBLE_EQ(spacing[2], 3 * at_diagonal);
  EXPECT_DOUBLE_EQ(spacing[3], 3);
}

TEST(SpacingTest, NeighboursAreThoseOfTheEdgesWhetherTheyAreThereOrNot) {
  std::vector<zoo::Animal> animals = zoo::all();
  for (const zoo::Animal& animal : zoo::volumes()) animals.push_back(animal);
  for (const zoo::Animal& animal : animals) {
    Mesh mesh(animal.data);
    const auto edges = edges_of(mesh);
    for (const bool complete : {false, true}) {
      if (complete) mesh.set(0, 1);
      const VertexNeighbours neighbours(mesh);
      std::multiset<std::array<std::uint32_t, 2>> found;
      for (const Vertex v : mesh.vertices())
        for (const std::uint32_t u : neighbours.of(v))
          if (v.index < u) found.insert({v.index, u});
      EXPECT_TRUE(std::equal(edges.begin(), edges.end(), found.begin(), found.end()))
          << animal.name;
    }
  }
}

TEST(SpacingTest, EvaluatingChangesNothing) {
  Mesh mesh(zoo::torus(12, 9));
  const std::string before = zoo::fingerprint(mesh);
  (void)evaluate_spacing(mesh, {SpacingByCurvature{}, default_spacing_growth});
  EXPECT_EQ(zoo::fingerprint(mesh), before);
  EXPECT_EQ(mesh.count(1), 0u);
  EXPECT_FALSE(mesh.stored(0, 1) || mesh.stored(0, 2));
}

TEST(SpacingTest, VerticesWithoutEdgesHaveNone) {
  for (const SpacingSource& source :
       {SpacingSource{SpacingByFactor{}, {}}, SpacingSource{SpacingFormula{"1"}, {}},
        SpacingSource{SpacingByCurvature{}, {}}}) {
    const auto spacing = spacing_of(zoo::bow_tie(), source);
    EXPECT_EQ(spacing[5], 0);
    EXPECT_GT(spacing[0], 0);
  }
}

TEST(SpacingTest, HolesInTheIdsAreLeftOut) {
  Mesh mesh(zoo::grid(4));
  mesh.destroy_with_users(Vertex(12));
  const auto spacing = evaluate_spacing(mesh, {SpacingFormula{"1 + x + 10 * y"}, {}});
  EXPECT_EQ(spacing[Vertex(12)], 0);
  EXPECT_EQ(spacing[Vertex(13)], 24);
}

TEST(SpacingTest, OptionsMustBePositive) {
  const Mesh mesh(zoo::square());
  const auto said = [&](const SpacingSource& source) {
    return message([&] { (void)evaluate_spacing(mesh, source); });
  };
  EXPECT_EQ(said({SpacingByFactor{0}, {}}),
            "the factor of a spacing must be positive and finite, not 0");
  EXPECT_EQ(said({SpacingByCurvature{.chord_error = -1}, {}}),
            "the chord error of a spacing must be positive and finite, not -1");
  EXPECT_EQ(said({SpacingByCurvature{.largest = inf}, {}}),
            "the largest spacing must be positive and finite, not inf");
  EXPECT_EQ(said({SpacingByFactor{}, -0.5}),
            "spacings cannot grow by less than 0 per unit of length");
}

// Files
// ------------------------------------------------------------------------------------------------

struct SpacingFileTest : testing::Test {
  std::filesystem::path write(const std::string& text) {
    std::ofstream(path) << text;
    return path;
  }
  std::string error(const std::string& text, const MeshData& data = zoo::square()) {
    write(text);
    const std::string said = message([&] { (void)spacing_of(data, {SpacingFile{path}, {}}); });
    const std::string start = path.string() + ":";
    return said.starts_with(start) ? said.substr(start.size()) : said;
  }
  test::TemporaryFolder folder;
  std::filesystem::path path = folder / "sizes.txt";
};

TEST_F(SpacingFileTest, OneNumberForEachVertex) {
  write("# lengths in mm\n0.5\n\n  1.25 # the corner\r\n3e-2 7");
  const SpacingSource source = parse_spacing(path.string());
  EXPECT_EQ(source, (SpacingSource{SpacingFile{path}, {}}));
  EXPECT_EQ(spacing_of(zoo::square(), source), (std::vector<double>{0.5, 1.25, 0.03, 7}));
}

TEST_F(SpacingFileTest, UnusedVerticesCountAndIdsThatAreFreeDoNot) {
  write("1 2 3 4 5 6");
  EXPECT_EQ(spacing_of(zoo::bow_tie(), {SpacingFile{path}, {}}),
            (std::vector<double>{1, 2, 3, 4, 5, 6}));
  Mesh mesh(zoo::grid(2));
  mesh.destroy_with_users(Vertex(4));
  write("1 2 3 4 6 7 8 9");
  EXPECT_EQ(values(mesh, evaluate_spacing(mesh, {SpacingFile{path}, {}})),
            (std::vector<double>{1, 2, 3, 4, 6, 7, 8, 9}));
}

TEST_F(SpacingFileTest, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error("1\n2\n-3\n4\n"), "3: a spacing must be positive, not -3");
  EXPECT_EQ(error("1\n0\n3\n4\n"), "2: a spacing must be positive, not 0");
  EXPECT_EQ(error("nan\n2\n3\n4\n"), "1: a spacing is not a finite number: \"nan\"");
  EXPECT_EQ(error("1\n# so\n2\ninf\n4\n"), "4: a spacing is not a finite number: \"inf\"");
  EXPECT_EQ(error("1\n2\nlong\n4\n"), "3: expected a number for a spacing, found \"long\"");
  EXPECT_EQ(error("1\n2\n3"), "3: the file ends after 3 spacings; the mesh has 4 vertices");
  EXPECT_EQ(error("# none\n"), "2: the file ends after 0 spacings; the mesh has 4 vertices");
  EXPECT_EQ(error("1\n2\n3\n4\n\n5\n"), "6: more spacings than the mesh has vertices (4)");
  EXPECT_EQ(error(""), " is empty");
}

TEST_F(SpacingFileTest, AMissingOneIsNamed) {
  EXPECT_EQ(message([&] {
              (void)spacing_of(zoo::square(), {SpacingFile{path}, {}});
            }),
            path.string() + ": cannot be opened: No such file or directory");
}

TEST_F(SpacingFileTest, AFileGoesBeforeAWordAndAFormula) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  std::ofstream("curvature") << "1 1 1 1";
  std::filesystem::create_directory("x");
  const SpacingSource file = parse_spacing("curvature"), formula = parse_spacing("x");
  std::filesystem::remove("curvature");
  const SpacingSource word = parse_spacing("curvature");
  std::filesystem::current_path(before);
  EXPECT_EQ(file, (SpacingSource{SpacingFile{"curvature"}, {}}));
  EXPECT_EQ(formula, (SpacingSource{SpacingFormula{"x"}, {}})) << "a folder is no file";
  EXPECT_EQ(word, (SpacingSource{SpacingByCurvature{}, 0.3}));
}

// Formulas
// ------------------------------------------------------------------------------------------------

//  6--7--8     x and y run from 0 to 2, z is 0; so the diagonal of the box is sqrt(8)
//  |/ |/ |
//  3--4--5
//  |/ |/ |
//  0--1--2
TEST(SpacingFormulaTest, KnowsWhereItIs) {
  const auto spacing = spacing_of(zoo::grid(2), parse_spacing("1 + x + 10 * y + z"));
  EXPECT_EQ(spacing, (std::vector<double>{1, 2, 3, 11, 12, 13, 21, 22, 23}));
  EXPECT_DOUBLE_EQ(spacing_of(zoo::grid(2), parse_spacing("diag"))[4], std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(spacing_of(zoo::bow_tie(), parse_spacing("diag"))[0], std::sqrt(8.0))
      << "a vertex that nothing uses is not in the box";
  EXPECT_EQ(
      spacing_of(zoo::grid(2), parse_spacing("x <= 0 ? 4 : x >= 2 ? 6 : y != 7 && x == 1 ? 5 : 1")),
      (std::vector<double>{4, 5, 6, 4, 5, 6, 4, 5, 6}));
  EXPECT_EQ(spacing_of(zoo::grid(2), parse_spacing("2.5 * h")),
            spacing_of(zoo::grid(2), {SpacingByFactor{2.5}, {}}));
}

TEST(SpacingFormulaTest, CanSayWhatCurvatureSays) {
  const MeshData data = zoo::torus(24, 18);
  const auto formula =
      spacing_of(data, parse_spacing("max(h, min(sqrt(8 * 0.001 * diag / k), 0.1 * diag))"));
  EXPECT_EQ(formula, spacing_of(data, {SpacingByCurvature{}, {}}));
}

TEST(SpacingFormulaTest, SaysWhatIsWrongAndWhere) {
  const auto error = [](const std::string& text) {
    const std::string said = message([&] { (void)parse_spacing(text); });
    const std::string start = "spacing \"" + text + "\", character ",
                      end = " (and there is no such file)";
    return said.starts_with(start) && said.ends_with(end)
               ? said.substr(start.size(), said.size() - start.size() - end.size())
               : said;
  };
  const std::string names = " here; there are x, y, z, h, k, diag, numbers and functions";
  EXPECT_EQ(error(""), "1: there is nothing");
  EXPECT_EQ(error("1 +"), "4: something is missing at the end");
  EXPECT_EQ(error("2 * (x"), "7: a parenthesis is not closed");
  EXPECT_EQ(error("x)"), "2: \")\" cannot stand here");
  EXPECT_EQ(error("2 ** x"), "4: \"*\" cannot stand here");
  EXPECT_EQ(error("3 x"), "3: \"x\" cannot stand here");
  EXPECT_EQ(error("1 2"), "3: \"2\" cannot stand here");
  EXPECT_EQ(error("2 * sizes"), "5: nothing is called \"sizes\"" + names);
  EXPECT_EQ(error("sqrt(x, y)"), "10: \"sqrt\" takes fewer values");
  EXPECT_EQ(error("min()"), "6: \"min\" takes more values");
  EXPECT_EQ(error("1, 2"), "2: a comma can only stand between what a function is given");
  EXPECT_EQ(error("h = 3"), "3: nothing can be assigned; equality is ==");
  EXPECT_EQ(error("x >= 1 ? (h = 3) : 2"), "13: nothing can be assigned; equality is ==");
}

TEST(SpacingFormulaTest, OddTextIsAnErrorNotACrash) {
  for (const std::string& text :
       {std::string(19000, '('), std::string(100000, '1'), std::string(3000, '-') + "1",
        std::string("\xc3\xa9 + 1"), std::string("1\n+\n"), std::string("\"x\""), std::string("?:"),
        std::string("x ? 1")}) {
    const std::string said = message([&] { (void)parse_spacing(text); });
    EXPECT_NE(said, "") << text.substr(0, 20);
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    EXPECT_LT(said.size(), 250u);
  }
}

TEST(SpacingFormulaTest, ResultsMustBePositiveAndFinite) {
  const auto error = [](const std::string& text) {
    return message([&] { (void)spacing_of(zoo::grid(2), parse_spacing(text)); });
  };
  EXPECT_EQ(error("1.5 - x"),
            "spacing \"1.5 - x\" is -0.5 at vertex 2 (2, 0, 0); it must be positive and finite");
  EXPECT_EQ(error("1 / (1 - y)"),
            "spacing \"1 / (1 - y)\" is inf at vertex 3 (0, 1, 0); it must be positive and finite");
  EXPECT_EQ(error("0 * x"),
            "spacing \"0 * x\" is 0 at vertex 0 (0, 0, 0); it must be positive and finite");
  EXPECT_TRUE(error("1 + sqrt(0.25 - x)").find("nan at vertex 1 (1, 0, 0)") != std::string::npos);
}

// Growth
// ------------------------------------------------------------------------------------------------

void expect_limited(const Mesh& mesh, double growth, const Column<Vertex, double>& before,
                    const Column<Vertex, double>& after) {
  for (const auto& [a, b] : edges_of(mesh)) {
    const double step = growth * length(mesh, a, b);
    EXPECT_LE(after[Vertex(a)], after[Vertex(b)] + step);
    EXPECT_LE(after[Vertex(b)], after[Vertex(a)] + step);
  }
  for (const Vertex v : mesh.vertices()) EXPECT_LE(after[v], before[v]);
}

//  6--7--8     all edges along x and y are 1 long; only vertex 0 is small
//  |/ |/ |
//  3--4--5
//  |/ |/ |
//  0--1--2
TEST(SpacingGrowthTest, GoesAlongTheShortestWay) {
  const auto spacing = spacing_of(zoo::grid(2), {SpacingFormula{"x + y == 0 ? 1 : 2.2"}, 0.5});
  const std::vector<double> expected{1, 1.5, 2, 1.5, 1 + 0.5 * std::sqrt(2.0), 2.2, 2, 2.2, 2.2};
  for (std::size_t v = 0; v < 9; ++v) EXPECT_DOUBLE_EQ(spacing[v], expected[v]) << v;
}

TEST(SpacingGrowthTest, ZeroLeavesTheSmallestEverywhere) {
  EXPECT_EQ(spacing_of(zoo::grid(2), {SpacingFormula{"1 + x + y"}, 0.0}),
            std::vector<double>(9, 1.0));
}

TEST(SpacingGrowthTest, WhatNothingReachesStays) {
  MeshData data = zoo::square();
  const MeshData other = zoo::square();
  for (const auto& p : other.positions) data.positions.push_back(p + glm::dvec3(9, 0, 0));
  data.faces.add(Shape::Triangle, {4, 5, 6});
  data.faces.add(Shape::Triangle, {4, 6, 7});
  const Mesh mesh(data);
  Column<Vertex, double> spacing(8, inf);
  spacing[Vertex(1)] = 1;
  limit_growth(mesh, VertexNeighbours(mesh), 1, spacing);
  EXPECT_EQ(values(mesh, spacing), (std::vector<double>{2, 1, 2, 3, inf, inf, inf, inf}));
}

// The largest field that the limit allows, by going on until nothing changes.
Column<Vertex, double> limited_plainly(const Mesh& mesh, double growth,
                                       Column<Vertex, double> field) {
  const auto edges = edges_of(mesh);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : edges)
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        const double most = field[Vertex(from)] + growth * length(mesh, from, to);
        if (field[Vertex(to)] <= most) continue;
        field[Vertex(to)] = most;
        changed = true;
      }
  }
  return field;
}

TEST(SpacingGrowthTest, HoldsAtEachEdgeToTheLastBitAndTakesNoMoreThanItMust) {
  for (const MeshData& data :
       {zoo::torus(40, 30), zoo::dirty(), zoo::hybrid(), make_sample("terrain", 20)})
    for (const double growth : {0.05, 0.3, 2.0}) {
      const Mesh mesh(data);
      Column<Vertex, double> before(mesh.capacity(0), 0.0);
      std::uint32_t state = 1;
      for (const Vertex v : mesh.vertices())
        before[v] = 1e-3 + 1e-3 * ((state = state * 1664525u + 1013904223u) >> 16) * (v.index % 7);
      Column<Vertex, double> after = before;
      limit_growth(mesh, VertexNeighbours(mesh), growth, after);
      expect_limited(mesh, growth, before, after);
      EXPECT_EQ(values(mesh, after), values(mesh, limited_plainly(mesh, growth, before)));
    }
}

TEST(SpacingGrowthTest, HoldsOnTheBunny) {
  const std::filesystem::path bunny = std::filesystem::path(AOMD_SHARED_DATA) / "bunny.ply";
  if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "shared data is not here";
  const Mesh mesh(io::read(bunny).mesh);
  const auto free = evaluate_spacing(mesh, {SpacingByCurvature{}, {}});
  const auto limited = evaluate_spacing(mesh, {SpacingByCurvature{}, 0.3});
  expect_limited(mesh, 0.3, free, limited);
  const auto lengths = evaluate_spacing(mesh, {SpacingByFactor{1}, {}});
  const VertexNeighbours neighbours(mesh);
  const double largest = 0.1 * box_of_used(mesh, neighbours).diagonal();
  std::vector<double> ears, flank;
  for (const Vertex v : mesh.vertices()) {
    ASSERT_TRUE(std::isfinite(limited[v])) << v.index;
    if (neighbours.of(v).empty()) continue;
    EXPECT_GT(limited[v], 0);
    EXPECT_LE(free[v], std::max(largest, lengths[v]));
    EXPECT_GE(free[v], lengths[v]);
    const glm::dvec3& p = mesh.position(v);
    if (p.y > 0.16) ears.push_back(limited[v]);
    if (p.y > 0.06 && p.y < 0.1 && p.x > -0.01 && p.z > 0.02) flank.push_back(limited[v]);
  }
  ASSERT_TRUE(ears.size() > 500 && flank.size() > 500);
  const auto tenth = [](std::vector<double>& list) {
    std::sort(list.begin(), list.end());
    return list[list.size() / 10];
  };
  EXPECT_LT(tenth(ears), 0.75 * tenth(flank))
      << "the rims of the ears bend more than anything on the flank";
}

// By surface
// ------------------------------------------------------------------------------------------

// Tetrahedra around the line from 0 over 1 and 2 to 3, inside a triangle 4, 5, 6 at height 3:
//
//     3 (6)         edges on the outside: 5 from 0 and 3 to the triangle, 4 sqrt(3) in it
//     |
//     2 (3)  4,5,6
//     1 (1)
//     0 (0)
MeshData line_of_tets() {
  const double s = 2 * std::sqrt(3.0);
  zoo::Solids cells;
  for (std::uint32_t i = 0; i < 3; ++i)
    for (std::uint32_t j = 0; j < 3; ++j)
      cells.emplace_back(Shape::Tetrahedron,
                         std::vector<std::uint32_t>{i, i + 1, 4 + j, 4 + (j + 1) % 3});
  return zoo::make_volume(
      {{0, 0, 0}, {0, 0, 1}, {0, 0, 3}, {0, 0, 6}, {4, 0, 3}, {-2, s, 3}, {-2, -s, 3}}, cells);
}

TEST(SpacingBySurfaceTest, GrowsInsideFromWhatItIsOnModelFaces) {
  Mesh mesh(line_of_tets());
  classify(mesh);
  const std::vector<double> sizes =
      values(mesh, evaluate_spacing(mesh, {SpacingBySurface{2}, 0.5}));
  const double rim = 2 * (5 + 5 + 2 * 4 * std::sqrt(3.0)) / 4;
  const std::vector<double> wanted = {10, 10.5, 11.5, 10, rim, rim, rim};
  ASSERT_EQ(sizes.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(sizes[i], wanted[i], 1e-14) << i;
  const auto free = evaluate_spacing(mesh, {SpacingBySurface{2}, {}});
  EXPECT_EQ(free[Vertex(1)], inf);
  EXPECT_EQ(free[Vertex(0)], 10);
  EXPECT_EQ(parse_spacing("surface", 3), (SpacingSource{SpacingBySurface{3}, 0.3}));
  EXPECT_EQ(message([] { (void)spacing_of(zoo::grid(2), parse_spacing("surface")); }),
            "surface is for volumes: a surface has nothing inside");
}

}  // namespace
}  // namespace aomd::spacing_test
