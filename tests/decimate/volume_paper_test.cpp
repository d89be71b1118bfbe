// The printed strategy among tetrahedra.

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/decimate/explain/explanation.h"
#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "tests/support/message.h"
#include "tests/support/strata.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/zoo.h"

namespace aomd::volume_paper_test {
namespace {

using test::strata_of;
using test::wrong_with_tets;

Mesh classified(const MeshData& data) {
  Mesh mesh(data);
  classify(mesh);
  mesh.keep_model_faces_only();
  return mesh;
}

MeshData box(int n) {
  return zoo::tet_grid(
      {n, n, n}, [](const zoo::Cell&) { return 1; }, 0.1);
}

TEST(VolumePaperTest, KeepsEveryStratumAtAnyLength) {
  for (const zoo::TetAnimal& animal : zoo::tets())
    for (const bool coarsest : {false, true}) {
      Mesh mesh = classified(animal.data);
      const std::string strata = strata_of(mesh);
      const std::uint32_t before = mesh.count(3);
      Decimation decimation(mesh, {.factor = 3, .coarsest = coarsest});
      decimation.run();
      EXPECT_EQ(strata_of(mesh), strata) << animal.name;
      EXPECT_EQ(wrong_with_tets(mesh), "") << animal.name;
      EXPECT_TRUE(verify(mesh).empty()) << animal.name;
      EXPECT_LE(mesh.count(3), before) << animal.name;
      EXPECT_TRUE(animal.name != "box" || mesh.count(3) < before / 2) << mesh.count(3);
      EXPECT_EQ(decimation.sweeps().back().regions, mesh.count(3));
    }
}

TEST(VolumePaperTest, StopsAtATarget) {
  Mesh mesh = classified(box(6));
  ASSERT_EQ(mesh.count(3), 1296u);
  Decimation decimation(mesh, {.target_faces = 400});
  decimation.run();
  EXPECT_LE(mesh.count(3), 400u);
  EXPECT_GT(mesh.count(3), 380u);
  EXPECT_EQ(wrong_with_tets(mesh), "");
}

TEST(VolumePaperTest, FacesInsideAsEntitiesMakeNoDifference) {
  Mesh listed = classified(box(4)), complete = classified(box(4));
  complete.set(3, 2);
  for (Mesh* mesh : {&listed, &complete}) Decimation(*mesh, {.factor = 3}).run();
  ASSERT_EQ(listed.count(3), complete.count(3));
  for (const Region r : listed.regions()) EXPECT_EQ(listed.tetrahedron(r), complete.tetrahedron(r));
  EXPECT_TRUE(verify(complete).empty());
}

TEST(VolumePaperTest, UndoingAllIsTheStart) {
  Mesh mesh = classified(box(4));
  mesh.set(0, 1);
  const std::string start = zoo::fingerprint(mesh);
  Journal journal;
  mesh.attach(&journal);
  Decimation(mesh, {.factor = 3}).run();
  ASSERT_GT(journal.size(), 50u);
  journal.seek(mesh, 0);
  EXPECT_EQ(zoo::fingerprint(mesh), start);
  mesh.attach(nullptr);
}

TEST(VolumePaperTest, KeptVerticesStay) {
  Mesh mesh = classified(box(4));
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(mesh.capacity(0), std::uint8_t{0});
  std::vector<std::pair<Vertex, glm::dvec3>> kept;
  for (const Vertex v : mesh.vertices())
    if (v.index % 5 == 0) {
      (*keep)[v] = 1;
      kept.emplace_back(v, mesh.position(v));
    }
  Decimation(mesh, {.factor = 4, .keep = keep}).run();
  for (const auto& [v, position] : kept) {
    ASSERT_TRUE(mesh.alive(v));
    EXPECT_EQ(mesh.position(v), position);
  }
}

// A row of tetrahedra's cells with a pyramid on top of the first vertices of one side.
MeshData box_with_a_pyramid_and_a_flag() {
  MeshData data = box(3);
  const auto n = static_cast<std::uint32_t>(data.positions.size());
  const auto at = [&](const glm::dvec3& p) {
    return static_cast<std::uint32_t>(std::find(data.positions.begin(), data.positions.end(), p) -
                                      data.positions.begin());
  };
  const std::uint32_t a = at({3, 1, 1}), b = at({3, 2, 1}), c = at({3, 2, 2}), d = at({3, 1, 2});
  data.positions.emplace_back(4, 1, 1);
  data.positions.emplace_back(4, 2, 1);
  data.positions.emplace_back(4, 2, 2);
  data.positions.emplace_back(4, 1, 2);
  data.regions.add(Shape::Hexahedron, {a, b, c, d, n, n + 1, n + 2, n + 3}, ModelRef(3, 2));
  data.positions.emplace_back(-1, 0, 0);
  data.faces.add(Shape::Triangle, {at({0, 0, 0}), at({0, 1, 0}), n + 4}, ModelRef(2, 99));
  return data;
}

TEST(VolumePaperTest, OtherRegionsAndWhatHangsOnThemStay) {
  Mesh mesh(box_with_a_pyramid_and_a_flag());
  classify(mesh);
  mesh.keep_model_faces_only();
  std::uint32_t hexahedra = 0;
  Decimation decimation(mesh, {.coarsest = true});
  decimation.run();
  VertexBuffer buffer;
  for (const Region r : mesh.regions()) {
    if (mesh.shape(r) != Shape::Hexahedron) continue;
    ++hexahedra;
    EXPECT_EQ(mesh.vertices_of(r, buffer).size(), 8u);
  }
  EXPECT_EQ(hexahedra, 1u);
  std::uint32_t flags = 0;
  for (const Face f : mesh.faces()) flags += mesh.classification(f) == ModelRef(2, 99);
  EXPECT_EQ(flags, 1u);
  EXPECT_TRUE(verify(mesh).empty());
  EXPECT_LT(mesh.count(3), 100u);
}

TEST(VolumePaperTest, EveryRefusalHasWords) {
  std::set<Reason> reasons;
  for (const zoo::TetAnimal& animal : zoo::tets()) {
    Mesh mesh(animal.data);
    classify(mesh, {.feature_angle_deg = {}});
    mesh.keep_model_faces_only();
    Decimation decimation(mesh, {.factor = 6, .angle_deg = 80});
    for (int round = 0; round < 2; ++round) {
      for (const Edge e : mesh.edges())
        for (const CollapseOutlook& o : decimation.outlook(e)) {
          const std::string words = explain_collapse(mesh, o, decimation.options());
          ASSERT_FALSE(words.empty());
          EXPECT_EQ(words.find("surface"), std::string::npos) << words;
          reasons.insert(o.verdict.reason);
        }
      decimation.run();
    }
  }
  for (const Reason r : {Reason::Spacing, Reason::Classification, Reason::Topology,
                         Reason::Inverted, Reason::Shape, Reason::Angle})
    EXPECT_TRUE(reasons.contains(r)) << reason_name(r);
}

TEST(VolumePaperTest, RefusesWhatItCannotDo) {
  Mesh hexahedron(zoo::make_volume(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{Shape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}}));
  EXPECT_FALSE(has_tetrahedra(hexahedron));
  EXPECT_STREQ(decimation_obstacle(hexahedron),
               "Of volumes only tetrahedra can be decimated, and there are none: --split-to-tets "
               "makes some.");
  Mesh mesh = classified(box(2));
  EXPECT_EQ(decimation_obstacle(mesh), nullptr);
  EXPECT_EQ(test::message([&] { Decimation(mesh, {.topology = TopologyRule::Paper}); }),
            "collapses among tetrahedra always keep the topology");
}

}  // namespace
}  // namespace aomd::volume_paper_test
