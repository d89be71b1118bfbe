// Arrays of surfaces go along: on vertices and faces, on the right side, in every kind.

#include <gtest/gtest.h>

#include "tests/support/field_helpers.h"

namespace aomd::test::carry_surface_test {
namespace {

using Place = std::array<double, 3>;

Place place(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// A square of 2 n n triangles in the plane z = `height`, looking up or down.
void add_sheet(MeshData& mesh, std::uint32_t n, double height, bool up,
               const glm::dvec3& by = glm::dvec3(0)) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.positions.push_back(by + glm::dvec3(double(i) / n, double(j) / n, height));
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.faces.add(Shape::Triangle, {a, up ? b : c, up ? c : b});
  };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = first + j * (n + 1) + i;
      add(v, v + 1, v + n + 2);
      add(v, v + n + 2, v + n + 1);
    }
}

double integral(const MeshData& mesh, const char* name, int dim) {
  const Attribute& a = *find(mesh, name, dim);
  return fields::facts_of(a, fields::measures(mesh, dim)).components[0].integral;
}

/// But for how far vertices on model edges of the cube lie off it.
TEST(CarrySurface, LinearFunctionsStayOnPlanes) {
  MeshData sheet;
  add_sheet(sheet, 20, 0, true);
  for (MeshData mesh : {sheet, make_sample("box")}) {
    const double most = mesh.faces.classes.empty() ? 1e-12 : 1e-6;
    mesh.attributes = {field(mesh, "u", 0, slanted)};
    Attribute nine{"nine", 0, 9, false, {}};
    for (const glm::dvec3& p : mesh.positions)
      for (int k = 0; k < 9; ++k) nine.values.push_back(k - slanted(p));
    mesh.attributes.push_back(nine);
    const MeshData result = decimated(mesh, 0.3).mesh;
    ASSERT_LT(result.faces.size(), mesh.faces.size() / 2);
    for (std::size_t i = 0; i < result.positions.size(); ++i) {
      ASSERT_NEAR(find(result, "u", 0)->values[i], slanted(result.positions[i]), most);
      for (std::size_t k = 0; k < 9; ++k)
        ASSERT_NEAR(find(result, "nine", 0)->values[9 * i + k],
                    static_cast<double>(k) - slanted(result.positions[i]), most);
    }
  }
}

TEST(CarrySurface, VerticesThatStayKeepTheirBits) {
  MeshData mesh = make_sample("scan", 3000);
  mesh.attributes = {field(mesh, "u", 0, [](const glm::dvec3& p) { return std::sin(40 * p.x); })};
  Mesh coarse(mesh);
  classify(coarse);
  DecimationOptions options;
  options.strategy = Strategy::Paper;
  options.factor = 1.5;
  options.smooth = false;
  Decimation(coarse, options).run();
  MeshData result = to_data(coarse);
  (void)io::carry_along(mesh, result);
  std::map<Place, double> known;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    known[place(mesh.positions[i])] = mesh.attributes[0].values[i];
  std::size_t same = 0;
  for (std::size_t i = 0; i < result.positions.size(); ++i) {
    const auto at = known.find(place(result.positions[i]));
    if (at == known.end()) continue;
    ++same;
    EXPECT_EQ(result.attributes[0].values[i], at->second);
  }
  EXPECT_GT(same, 100u);
}

/// A vertex without faces has no place but its own, which a writer may have rounded to -0.
TEST(CarrySurface, BothZerosAreOnePlace) {
  MeshData mesh;
  add_sheet(mesh, 4, 0, true);
  mesh.positions.emplace_back(0.0, 7, 0.0);
  mesh.attributes = {field(mesh, "u", 0, [](const glm::dvec3& p) { return 1 + p.y; })};
  MeshData result = mesh;
  result.positions.front().z = 0.1;
  result.positions.back().x = -0.0;
  result.attributes.clear();
  (void)io::carry_along(mesh, result);
  EXPECT_EQ(find(result, "u", 0)->values.back(), 8);
}

/// What a vertex gets is the value at the nearest point of the original, to what the function and
/// the surface bend between two vertices.
TEST(CarrySurface, ValuesAreThoseOfTheNearestPlace) {
  MeshData mesh = make_sample("sphere", 32);
  const auto wave = [](const glm::dvec3& p) {
    const glm::dvec3 u = glm::normalize(p);
    return std::sin(5 * u.x) + u.y * u.z;
  };
  mesh.attributes = {field(mesh, "u", 0, wave)};
  const MeshData result = decimated(mesh, 0.05).mesh;
  for (std::size_t i = 0; i < result.positions.size(); ++i)
    ASSERT_NEAR(result.attributes[0].values[i], wave(result.positions[i]), 6e-3) << i;
}

/// Two sheets as far apart as a hundredth of an edge, that look away from each other; and two that
/// look the same way, one above the other.
TEST(CarrySurface, SheetsThatLieCloseKeepTheirOwnValues) {
  for (const bool up : {false, true}) {
    MeshData mesh;
    add_sheet(mesh, 20, 0, up);
    const std::size_t n = mesh.positions.size(), m = mesh.faces.size();
    add_sheet(mesh, 20, 5e-4, true);
    mesh.attributes = {{"v", 0, 1, false, std::vector<double>(n, -1)},
                       {"f", 2, 1, false, std::vector<double>(m, -1)},
                       {"label", 2, 1, true, std::vector<double>(m, 4)}};
    for (std::size_t k = 0; k < 3; ++k)
      mesh.attributes[k].values.resize(2 * (k == 0 ? n : m), k == 2 ? 9 : 1);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)  // so that nothing is where it was
      mesh.positions[i].z += 1e-4 * std::sin(7.0 * static_cast<double>(i));
    const MeshData result = decimated(mesh, 0.2).mesh;
    const fields::Cells faces(result, 2);
    const auto upper = [&](std::uint32_t f) { return faces.centre(f).z > 2.5e-4; };
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      ASSERT_NEAR(find(result, "f", 2)->values[f], upper(f) ? 1 : -1, 1e-2);
      ASSERT_EQ(find(result, "label", 2)->values[f], upper(f) ? 9 : 4);
      for (const std::uint32_t v : faces.vertices(f))
        ASSERT_EQ(find(result, "v", 0)->values[v], upper(f) ? 1 : -1);
    }
  }
}

/// Patches that touch along vertices of their own, as files have them at the seams of textures.
TEST(CarrySurface, PatchesThatTouchKeepTheirOwnValues) {
  MeshData mesh;
  add_sheet(mesh, 16, 0, true);
  const std::size_t n = mesh.positions.size();
  add_sheet(mesh, 16, 0, true, {1, 0, 0});
  mesh.attributes = {{"jump", 0, 1, false, std::vector<double>(n, -1)}};
  mesh.attributes[0].values.resize(2 * n, 1);
  EXPECT_GT(uses_at_contact(decimated(mesh, 0.1).mesh, 2), 2u);
}

/// Both lips of a slit are one piece: a vertex on one of them is told by the way into its faces.
TEST(CarrySurface, LipsOfASlitKeepTheirOwnValues) {
  const int n = 40, rows = 10;
  MeshData mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= n; ++i) {  // the last column lies on the first one
      const double angle = i == n ? 0 : 2 * M_PI * i / n;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.2 * j);
    }
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      mesh.faces.add(Shape::Triangle, {v, v + 1, v + n + 2});
      mesh.faces.add(Shape::Triangle, {v, v + n + 2, v + n + 1});
    }
  Attribute turn{"turn", 0, 1, false, {}};
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    turn.values.push_back(static_cast<double>(v % (n + 1)) / n);
  mesh.attributes = {turn};
  const MeshData result = decimated(mesh, 0.3).mesh;
  const fields::Cells faces(result, 2);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const glm::dvec3 c = faces.centre(f);
    const double angle = std::atan2(c.y, c.x), own = angle / (2 * M_PI) + (angle < 0);
    for (const std::uint32_t v : faces.vertices(f))
      ASSERT_NEAR(result.attributes[0].values[v], own, 0.4) << f;
  }
}

/// The border has values of its own.
TEST(CarrySurface, OnRimsValuesAreThoseOfTheRim) {
  const int n = 60;
  MeshData mesh;
  mesh.positions.emplace_back(0, 0, 0);
  for (int ring = 1; ring <= 8; ++ring)
    for (int i = 0; i < n; ++i)
      mesh.positions.emplace_back(ring * std::cos(2 * M_PI * i / n),
                                  ring * std::sin(2 * M_PI * i / n), 0);
  const auto at = [](std::uint32_t ring, std::uint32_t i) { return 1 + (ring - 1) * n + i % n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.faces.add(Shape::Triangle, {0, at(1, i), at(1, i + 1)});
    for (std::uint32_t ring = 1; ring < 8; ++ring) {
      mesh.faces.add(Shape::Triangle, {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.faces.add(Shape::Triangle, {at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  mesh.attributes = {
      field(mesh, "rim", 0, [](const glm::dvec3& p) { return glm::length(p) > 7.5 ? 1.0 : 0.0; })};
  const MeshData result = decimated(mesh, 0.1).mesh;
  std::size_t on_rim = 0;
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    if (glm::length(result.positions[v]) < 7.7) continue;
    ++on_rim;
    EXPECT_NEAR(result.attributes[0].values[v], 1, 1e-12);
  }
  EXPECT_GT(on_rim, 6u);
}

TEST(CarrySurface, IntegralsOverFacesStayByClass) {
  MeshData mesh = make_sample("box");
  ASSERT_FALSE(mesh.faces.classes.empty());
  mesh.attributes = {field(mesh, "w", 2, [](const glm::dvec3& p) { return 2 + std::sin(4 * p.x); }),
                     field(mesh, "w", 1, slanted)};
  const MeshData result = decimated(mesh, 0.2).mesh;
  ASSERT_LT(result.faces.size(), mesh.faces.size() / 2);
  double size = 0, other = 0;
  const auto was = integrals(mesh, *find(mesh, "w", 2), 0, size);
  const auto is = integrals(result, *find(result, "w", 2), 0, other);
  ASSERT_EQ(was.size(), is.size());
  for (const auto& [model, sum] : was) EXPECT_NEAR(is.at(model), sum, 1e-12 * size);
}

TEST(CarrySurface, WithoutClassesTheWholeIsOne) {
  MeshData mesh = make_sample("scan", 4000);
  mesh.attributes = {field(mesh, "w", 2, [](const glm::dvec3& p) { return 3 + std::sin(p.x); })};
  const MeshData result = decimated(mesh, 0.1).mesh;
  EXPECT_NEAR(integral(result, "w", 2), integral(mesh, "w", 2), 1e-12 * integral(mesh, "w", 2));
}

TEST(CarrySurface, NormalsStayUnitVectorsAndColoursWhole) {
  MeshData mesh = make_sample("sphere", 16);
  Attribute normal{"normal", 0, 3, false, {}}, color{"color", 0, 4, true, {}};
  normal.meaning = Meaning::Normal;
  normal.type = NumberType::Float32;
  color.meaning = Meaning::Colour;
  color.type = NumberType::UInt8;
  for (const glm::dvec3& p : mesh.positions) {
    const glm::dvec3 u = glm::normalize(p);
    for (int k = 0; k < 3; ++k) normal.values.push_back(u[k]);
    for (int k = 0; k < 3; ++k) color.values.push_back(std::round(127.5 * (1 + u[k])));
    color.values.push_back(255);
  }
  mesh.attributes = {normal, color};
  const Carried result = decimated(mesh, 0.1);
  const Attribute &n = *find(result.mesh, "normal", 0), &c = *find(result.mesh, "color", 0);
  EXPECT_EQ(n.type, NumberType::Float32);
  EXPECT_EQ(c.type, NumberType::UInt8);
  EXPECT_TRUE(c.integer);
  EXPECT_EQ(result.along.fields[0].kind, fields::FieldKind::Unit);
  EXPECT_EQ(result.along.fields[1].kind, fields::FieldKind::Colour);
  for (std::size_t i = 0; i < result.mesh.positions.size(); ++i) {
    const glm::dvec3 u = glm::normalize(result.mesh.positions[i]),
                     m(n.values[3 * i], n.values[3 * i + 1], n.values[3 * i + 2]);
    ASSERT_NEAR(glm::length(m), 1, 1e-12);
    ASSERT_GT(glm::dot(u, m), 0.99);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(c.values[4 * i + k], std::round(c.values[4 * i + k]));
      ASSERT_NEAR(c.values[4 * i + k], 127.5 * (1 + u[static_cast<int>(k)]), 4);
    }
    ASSERT_EQ(c.values[4 * i + 3], 255);
  }
}

TEST(CarrySurface, WhatIsNoNumberHasNoSay) {
  MeshData mesh = make_sample("scan", 2000);
  mesh.attributes = {field(mesh, "u", 0, [](const glm::dvec3&) { return 5.0; })};
  for (std::size_t i = 0; i < mesh.positions.size(); i += 9)
    mesh.attributes[0].values[i] = std::nan("");
  const Carried result = decimated(mesh, 0.3);
  std::size_t missing = 0;
  for (const double x : result.mesh.attributes[0].values) {
    missing += std::isnan(x);
    EXPECT_TRUE(std::isnan(x) || std::abs(x - 5) < 1e-12) << x;
  }
  EXPECT_LT(missing, result.mesh.positions.size() / 4);
  ASSERT_EQ(result.along.notes.size(), 1u);
  EXPECT_EQ(result.along.notes[0].find("values that are no numbers: \"u\" on vertices "), 0u);
}

TEST(CarrySurface, TheSameForAnyNumberOfThreads) {
  MeshData mesh = make_sample("scan", 4000);
  const auto wave = [](const glm::dvec3& p) { return std::sin(9 * p.x) * p.y; };
  mesh.attributes = {field(mesh, "u", 0, wave), field(mesh, "f", 2, wave)};
  const MeshData one = decimated(mesh, 0.25, 1).mesh;
  EXPECT_EQ(one.attributes.size(), 2u);
  EXPECT_TRUE(decimated(mesh, 0.25, 3).mesh == one);
}

/// Quads are cut from their first corner; vertices that nothing uses keep what they have.
TEST(CarrySurface, AnyShapesAndVerticesWithoutFaces) {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {9, 9, 9}};
  mesh.faces.add(Shape::Quad, {0, 1, 2, 3});
  mesh.attributes = {field(mesh, "u", 0, slanted)};
  MeshData result;
  result.positions = {{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}, {9, 9, 9}, {7, 7, 7}};
  result.faces.add(Shape::Triangle, {0, 1, 2});
  (void)io::carry_along(mesh, result);
  const std::vector<double>& values = result.attributes.at(0).values;
  EXPECT_EQ(values[0], slanted({0, 0, 0}));
  EXPECT_EQ(values[3], slanted({9, 9, 9}));
  EXPECT_TRUE(std::isnan(values[4]));
}

TEST(CarrySurface, NothingWithoutArrays) {
  const Carried result = decimated(make_sample("scan", 1000), 0.5);
  EXPECT_TRUE(result.along.fields.empty() && result.along.notes.empty());
  EXPECT_TRUE(result.mesh.attributes.empty());
}

}  // namespace
}  // namespace aomd::test::carry_surface_test
