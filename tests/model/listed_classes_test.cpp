// Classifying a volume without making entities of all its sides ends in the mesh that is left when
// all are made, and those that lie inside regions and model faces let go of again.

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/mesh/names.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/random_volume_classes.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/volume_helpers.h"

namespace aomd::listed_classes_test {
namespace {

Mesh classified(const MeshData& data, bool complete) {
  Mesh mesh(data);
  classify(mesh, {.complete = complete});
  mesh.keep_model_faces_only();
  keep_edges_for_quality(mesh);
  return mesh;
}

// Ids, directions and classes are the same.
void expect_same_either_way(const MeshData& data) {
  Mesh all = classified(data, true), listed = classified(data, false);
  ASSERT_TRUE(verify(listed).empty()) << verify(listed).front().text;
  for (int dim = 0; dim < 4; ++dim) {
    ASSERT_EQ(all.capacity(dim), listed.capacity(dim)) << "dimension " << dim;
    for (std::uint32_t id = 0; id < all.capacity(dim); ++id) {
      const EntityRef e(dim, id);
      SCOPED_TRACE(name_of(e));
      ASSERT_EQ(all.classification(e), listed.classification(e));
      VertexBuffer first, second;
      const auto expected = all.vertices_of(e, first), found = listed.vertices_of(e, second);
      ASSERT_TRUE(std::equal(expected.begin(), expected.end(), found.begin(), found.end()));
    }
  }
}

TEST(ListedClassesTest, OnlyWhatLiesOnModelFacesAndEdgesIsMade) {
  MeshData data = zoo::tet_grid({2, 1, 1}, [](const zoo::Cell& c) { return c.x + 1; });
  Mesh mesh(data);
  const ClassifyResult found = classify(mesh, {.complete = false});
  EXPECT_EQ(found.model_faces, 11);  // a wall between two cubes
  EXPECT_EQ(mesh.count(2), 22u);
  EXPECT_EQ(mesh.count(1), 20u);
  EXPECT_FALSE(mesh.complete(1));
  EXPECT_FALSE(mesh.complete(2));
}

TEST(ListedClassesTest, SamplesEndTheSameEitherWay) {
  for (const SampleInfo& sample : samples()) {
    if (sample.dimension != 3) continue;
    SCOPED_TRACE(sample.name);
    expect_same_either_way(make_sample(sample.name, 4));
  }
  SCOPED_TRACE("one of each");
  MeshData mixed = test::one_of_each();
  expect_same_either_way(mixed);
  mixed.edges = mixed.faces = {};
  expect_same_either_way(mixed);
}

TEST(ListedClassesTest, AnythingThatAFileListsEndsTheSameEitherWay) {
  for (const auto& [name, data] : zoo::tets())
    for (unsigned seed = 0; seed < 30; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      expect_same_either_way(test::with_random_classes_of_volumes(data, seed));
      if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace aomd::listed_classes_test
