// Arrays on the regions, faces and edges of volumes go along: integrals, constants, cells that
// stay.

#include <gtest/gtest.h>

#include "tests/support/field_helpers.h"

namespace aomd::test::carry_cells_test {
namespace {

double wave(const glm::dvec3& p) { return std::sin(4 * p.x) + p.y * p.z; }

void expect_same_integrals(const MeshData& before, const MeshData& after, const char* name,
                           int dim) {
  const Attribute &a = *find(before, name, dim), &b = *find(after, name, dim);
  for (std::size_t k = 0; k < static_cast<std::size_t>(a.components); ++k) {
    double size = 0, other = 0;
    const auto was = integrals(before, a, k, size), is = integrals(after, b, k, other);
    EXPECT_EQ(was.size(), is.size());
    for (const auto& [model, sum] : was)
      EXPECT_NEAR(is.at(model), sum, 1e-12 * size) << name << ' ' << dim << ' ' << k;
  }
}

TEST(CarryCells, IntegralsOverEachClassStay) {
  for (const char* sample : {"ball-in-box", "layered-beam", "tet-bracket", "tet-drilled"}) {
    MeshData mesh = make_sample(sample);
    mesh.attributes = {field(mesh, "w", 1, wave), field(mesh, "w", 2, wave),
                       field(mesh, "w", 3, wave)};
    Attribute tensor{"t", 3, 9, false, {}};
    const fields::Cells cells(mesh, 3);
    for (std::uint32_t i = 0; i < cells.size(); ++i)
      for (int k = 0; k < 9; ++k) tensor.values.push_back(k == 4 ? 0 : k * wave(cells.centre(i)));
    mesh.attributes.push_back(tensor);
    const MeshData result = decimated(mesh, 0.25).mesh;
    for (int dim = 1; dim <= 3; ++dim) expect_same_integrals(mesh, result, "w", dim);
    expect_same_integrals(mesh, result, "t", 3);
    for (std::size_t i = 4; i < 9 * result.regions.size(); i += 9)
      ASSERT_EQ(find(result, "t", 3)->values[i], 0) << "what is nothing stays so";
  }
}

/// What a cell gets is the mean of the function over it, as far as cells of the original tell.
TEST(CarryCells, ValuesAreMeansOfWhatIsCovered) {
  MeshData mesh = make_sample("tet-box", 12);
  for (int dim = 1; dim <= 3; ++dim) mesh.attributes.push_back(field(mesh, "u", dim, slanted));
  const MeshData result = decimated(mesh, 0.25).mesh;
  for (int dim = 1; dim <= 3; ++dim) {
    const std::vector<double> wanted = values_at(result, dim, slanted);
    const std::vector<double>& found = find(result, "u", dim)->values;
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      ASSERT_NEAR(found[i], wanted[i], 0.25) << dim << ' ' << i;  // a cell spans 5.5 / 12
  }
}

/// The number of a material, also where its volume has changed.
TEST(CarryCells, WhatIsOneNumberOnAClassStaysThat) {
  MeshData mesh = make_sample("ball-in-box");
  mesh.attributes = {{"density", 3, 1, false, {}}};
  for (const ModelRef m : mesh.regions.classes)
    mesh.attributes[0].values.push_back(m.tag() == 1 ? 7850.1 : 0.3);
  Mesh coarse(mesh);
  classify(coarse);
  DecimationOptions options;
  options.factor = 3;
  Decimation(coarse, options).run();
  MeshData result = to_data(coarse);
  (void)io::carry_along(mesh, result);
  ASSERT_LT(result.regions.size(), mesh.regions.size() / 2);
  for (std::size_t i = 0; i < result.regions.size(); ++i)
    EXPECT_EQ(result.attributes[0].values[i], result.regions.classes[i].tag() == 1 ? 7850.1 : 0.3);
}

/// Hexahedra, prisms and pyramids stay, and so does what was said of them.
TEST(CarryCells, CellsThatStayKeepTheirBits) {
  MeshData mesh = make_sample("mixed", 8);
  mesh.attributes = {field(mesh, "w", 3, wave)};
  const MeshData result = decimated(mesh, 0.9).mesh;
  ASSERT_LT(result.regions.size(), mesh.regions.size());
  std::map<std::array<double, 3>, double> others;
  const fields::Cells before(mesh, 3), after(result, 3);
  for (std::uint32_t i = 0; i < before.size(); ++i)
    others[{before.centre(i).x, before.centre(i).y, before.centre(i).z}] =
        mesh.attributes[0].values[i];
  for (std::uint32_t i = 0; i < after.size(); ++i) {
    const glm::dvec3 c = after.centre(i);
    if (after.shape(i) == Shape::Tetrahedron) continue;
    EXPECT_EQ(result.attributes[0].values[i], (others.at({c.x, c.y, c.z})));
  }
  expect_same_integrals(mesh, result, "w", 3);
}

TEST(CarryCells, WhereAllNumbersAreNothingSoAreTheNewOnes) {
  MeshData mesh = make_sample("tet-box", 5);
  mesh.attributes = {field(mesh, "zero", 3, [](const glm::dvec3&) { return 0.0; })};
  const MeshData result = decimated(mesh, 0.5).mesh;
  EXPECT_EQ(result.attributes[0].values, std::vector<double>(result.regions.size(), 0));
}

TEST(CarryCells, NumbersTooLargeToBeAddedUpStayNumbers) {
  MeshData mesh = make_sample("tet-box", 5);
  for (glm::dvec3& p : mesh.positions) p *= 10;
  mesh.attributes = {field(mesh, "huge", 3, [](const glm::dvec3& p) { return 1e307 * p.x; })};
  const MeshData result = decimated(mesh, 0.5).mesh;
  for (const double x : result.attributes[0].values) EXPECT_TRUE(x > 0 && x < 1.1e308);
}

TEST(CarryCells, WithoutClassesTheWholeIsOne) {
  MeshData mesh = make_sample("ball-in-box", 4);
  mesh.attributes = {field(mesh, "w", 3, [](const glm::dvec3& p) { return 3 + wave(p); })};
  const double all =
      fields::facts_of(mesh.attributes[0], fields::measures(mesh, 3)).components[0].integral;
  Carried result = decimated(mesh, 0.25);
  result.mesh.attributes.clear();
  result.mesh.regions.classes.clear();
  mesh.regions.classes.clear();
  (void)io::carry_along(mesh, result.mesh);
  EXPECT_NEAR(fields::facts_of(result.mesh.attributes[0], fields::measures(result.mesh, 3))
                  .components[0]
                  .integral,
              all, 1e-12 * std::abs(all));
}

}  // namespace
}  // namespace aomd::test::carry_cells_test
