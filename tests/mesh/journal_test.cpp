#include "core/mesh/journal.h"

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "tests/support/zoo.h"

namespace aomd::journal_test {
namespace {

TEST(JournalTest, UndoesAndRedoesEveryKindOfEdit) {
  Mesh mesh(zoo::square());
  mesh.set(0, 1);
  mesh.set(1, 2);
  mesh.set(2, 1);
  mesh.keep_class_lists(true);
  Journal journal;
  mesh.attach(&journal);
  std::vector<std::string> states{zoo::fingerprint(mesh)};
  const auto note = [&] { states.push_back(zoo::fingerprint(mesh)); };
  mesh.destroy(Face(0)), note();
  const Vertex v = mesh.create_vertex({2, 2, 2}, ModelRef(2, 3));
  note();
  mesh.move(v, {3, 3, 3}), note();
  mesh.set_classification(v, ModelRef(1, 1)), note();
  const Edge e = mesh.create_edge(Vertex(1), v);
  note();
  const Rebinding rebinding{e, 0, Vertex(1), Vertex(3)};
  mesh.rebind(std::span(&rebinding, 1)), note();
  mesh.destroy(e), note();
  mesh.destroy(v), note();
  ASSERT_EQ(journal.size(), 8u);
  for (std::size_t i = states.size(); i-- > 0;) {
    EXPECT_EQ(zoo::fingerprint(mesh), states[i]) << "after undoing to step " << i;
    EXPECT_TRUE(verify(mesh).empty());
    EXPECT_EQ(journal.undo(mesh), i > 0);
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(zoo::fingerprint(mesh), states[i]) << "after redoing to step " << i;
    EXPECT_EQ(journal.redo(mesh), i + 1 < states.size());
  }
}

TEST(JournalTest, AnEditAfterUndoDiscardsTheFuture) {
  Mesh mesh(zoo::square());
  Journal journal;
  mesh.attach(&journal);
  mesh.move(Vertex(0), {1, 2, 3});
  mesh.move(Vertex(0), {4, 5, 6});
  journal.undo(mesh);
  const std::uint64_t epoch = journal.epoch();
  mesh.move(Vertex(1), {7, 8, 9});
  EXPECT_EQ(journal.size(), 2u);
  EXPECT_EQ(journal.cursor(), 2u);
  EXPECT_NE(journal.epoch(), epoch);
  EXPECT_FALSE(journal.redo(mesh));
  EXPECT_EQ(mesh.position(Vertex(0)), glm::dvec3(1, 2, 3));
}

TEST(JournalTest, AnIdThatWasTakenAgainIsFreeAfterUndo) {
  Mesh mesh;
  mesh.create_vertex({0, 0, 0});
  mesh.create_vertex({1, 0, 0});
  mesh.destroy(Vertex(0));
  Journal journal;
  mesh.attach(&journal);
  EXPECT_EQ(mesh.create_vertex({2, 0, 0}), Vertex(0));
  journal.undo(mesh);
  EXPECT_TRUE(verify(mesh).empty());
  EXPECT_EQ(mesh.create_vertex({3, 0, 0}), Vertex(0));
}

TEST(JournalTest, WhatIsCutOffIsNoPartOfTheStepBefore) {
  Mesh mesh(zoo::square());
  Journal journal;
  mesh.attach(&journal);
  journal.keep_cut(true);
  mesh.move(Vertex(0), {1, 2, 3});
  mesh.move(Vertex(1), {4, 5, 6});
  journal.undo(mesh);
  mesh.move(Vertex(2), {7, 8, 9});
  const auto cut = journal.take_cut();
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->steps.size(), 1u);
  journal.seek(mesh, 0);
  journal.redo(mesh);
  EXPECT_EQ(mesh.position(Vertex(0)), glm::dvec3(1, 2, 3));
  EXPECT_EQ(mesh.position(Vertex(1)), glm::dvec3(1, 0, 0));
}

TEST(JournalTest, StepsWithoutEditsLeaveNoTrace) {
  Mesh mesh(zoo::square());
  Journal journal;
  mesh.attach(&journal);
  journal.begin_step(StepKind::Smooth, Vertex(0));
  journal.end_step();
  mesh.set_classification(Face(0), mesh.classification(Face(0)));
  EXPECT_EQ(journal.size(), 0u);
}

TEST(JournalTest, AnEmptyStepLeavesWhatCouldBeRedone) {
  Mesh mesh(zoo::square());
  Journal journal;
  mesh.attach(&journal);
  mesh.move(Vertex(0), {1, 2, 3});
  journal.undo(mesh);
  journal.begin_step(StepKind::Classify, {});
  journal.end_step();
  EXPECT_TRUE(journal.redo(mesh));
  EXPECT_EQ(mesh.position(Vertex(0)), glm::dvec3(1, 2, 3));
}

// One hub with more spokes than 18 bits count: stretching it is one record.
TEST(JournalTest, ARebindOfAnySizeIsUndone) {
  constexpr std::uint32_t n = (1u << 18) + 5;
  MeshData data;
  data.positions.resize(n + 2);
  for (std::uint32_t i = 0; i < n; ++i) data.edges.add(Shape::Line, {0, i + 2});
  Mesh mesh(data);
  Journal journal;
  std::vector<Rebinding> items;
  for (const Edge e : mesh.edges()) items.push_back({e, 0, Vertex(0), Vertex(1)});
  mesh.attach(&journal);
  mesh.rebind(items);
  std::size_t touched = 0;
  journal.touched(0, 1, [&](EntityRef) { ++touched; });
  EXPECT_EQ(touched, items.size());
  journal.undo(mesh);
  EXPECT_EQ(mesh.edge_vertices(Edge(n - 1))[0], Vertex(0));
}

TEST(JournalTest, TouchedNamesTheEntitiesOfACollapse) {
  Mesh mesh(zoo::torus(12, 9));
  classify(mesh);
  Journal journal;
  mesh.attach(&journal);
  Decimation decimation(mesh, {.coarsest = true, .angle_deg = 40});
  ASSERT_TRUE(decimation.step());
  int faces = 0, vertices = 0;
  journal.touched(0, 1,
                  [&](EntityRef e) { faces += e.dimension == 2, vertices += e.dimension == 0; });
  EXPECT_EQ(faces, 6);  // six around the deleted vertex: two destroyed, four rebound
  EXPECT_EQ(vertices, 1);
}

TEST(JournalTest, RefusesHistoriesThatAreNone) {
  Journal journal;
  EXPECT_THROW(journal.restore({1, 2, 3}, {}), std::runtime_error);
  EXPECT_THROW(journal.restore({7}, {JournalStep{}}), std::runtime_error);
  EXPECT_THROW(journal.restore({}, {JournalStep{StepKind::Edit, {}, 5}}), std::runtime_error);
}

// The whole of a decimation, there and back, on everything in the zoo.
TEST(JournalTest, DecimationUndoesToTheStartAndRedoesToTheEnd) {
  for (const zoo::Animal& animal : zoo::all())
    for (const TopologyRule topology : {TopologyRule::Safe, TopologyRule::Paper}) {
      Mesh mesh(animal.data);
      classify(mesh, {.feature_angle_deg = {}});
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      Decimation decimation(mesh, {.coarsest = true, .angle_deg = 60, .topology = topology});
      decimation.run();
      const std::string end = zoo::fingerprint(mesh);
      journal.seek(mesh, 0);
      EXPECT_EQ(zoo::fingerprint(mesh), start) << animal.name;
      EXPECT_TRUE(verify(mesh).empty()) << animal.name;
      journal.seek(mesh, journal.size());
      EXPECT_EQ(zoo::fingerprint(mesh), end) << animal.name;
      EXPECT_TRUE(verify(mesh).empty()) << animal.name;
    }
}

// A long way is gone on the bare mesh: what can be derived comes back, and so do class lists.
TEST(JournalTest, ASeekOverMoreThanTheMeshKeepsWhatIsDerived) {
  Mesh mesh(zoo::square());
  mesh.set(1, 2);
  mesh.keep_class_lists(true);
  Journal journal;
  mesh.attach(&journal);
  for (int k = 1; k <= 100; ++k) mesh.set_classification(Face(0), ModelRef(2, k));
  journal.seek(mesh, 7);
  ASSERT_NE(mesh.class_lists(), nullptr);
  EXPECT_EQ(mesh.class_lists()->entities(2, ModelRef(2, 7)).size(), 1u);
  EXPECT_TRUE(mesh.class_lists()->entities(2, ModelRef(2, 100)).empty());
  EXPECT_TRUE(mesh.stored(1, 2));
  EXPECT_TRUE(verify(mesh).empty());
}

// Attached again, a journal counts the creations that it holds: undoing them touches no value that
// was never kept.
TEST(JournalTest, AJournalMayBeDetachedAndAttachedAgain) {
  Mesh mesh;
  Journal journal;
  auto& heat = mesh.attached<Vertex, double>("heat", 1.0);
  mesh.attach(&journal);
  const Vertex first = mesh.create_vertex({0, 0, 0});
  heat[first] = 5;
  mesh.attach(nullptr);
  mesh.attach(&journal);
  const Vertex second = mesh.create_vertex({1, 0, 0});
  heat[second] = 7;
  while (journal.undo(mesh)) {
  }
  EXPECT_EQ(mesh.count(0), 0u);
  while (journal.redo(mesh)) {
  }
  EXPECT_EQ(heat[first], 1.0);  // kept by the journal's first attachment, and gone with it
  EXPECT_EQ(heat[second], 7.0);
  EXPECT_TRUE(verify(mesh).empty());
}

}  // namespace
}  // namespace aomd::journal_test
