// Whatever classes a file gives, classify() leaves a classification that keeps the rules, and that
// can be decimated.

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/mesh/verify.h"
#include "core/model/class_rules.h"
#include "core/model/classify.h"
#include "tests/support/random_classes.h"
#include "tests/support/zoo.h"

namespace aomd::classify_random_test {
namespace {

using test::with_random_classes;

// The rules of docs/CLASSIFICATION.md, by brute force.
void expect_rules(Mesh& mesh) {
  const Request edges_of = mesh.request(0, 1), faces_of = mesh.request(1, 2);
  for (const Edge e : mesh.edges()) {
    const Row<2> faces = mesh.row<2>(e);
    if (mesh.classification(e).dimension() == 1) continue;
    ASSERT_GT(faces.size(), 1u) << "edge " << e.index;
    for (const Face f : faces) ASSERT_EQ(mesh.classification(e), mesh.classification(f));
  }
  for (const Vertex v : mesh.vertices()) {
    const ModelRef model = mesh.classification(v);
    if (model.dimension() == 0) continue;
    std::size_t on_curves = 0;
    for (const Edge e : mesh.row<1>(v)) {
      on_curves += mesh.classification(e).dimension() == 1;
      if (model.dimension() > 1 || mesh.classification(e).dimension() == 1) {
        ASSERT_EQ(mesh.classification(e), model) << "vertex " << v.index;
      }
    }
    if (!mesh.row<1>(v).empty()) {
      ASSERT_EQ(on_curves, model.dimension() == 1 ? 2u : 0u);
    }
  }
}

TEST(ClassifyRandomTest, AnyClassesOfAFileEndInOnesThatKeepTheRules) {
  for (const auto& [name, data] : zoo::all())
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh(with_random_classes(data, seed));
      classify(mesh);
      ASSERT_TRUE(verify(mesh).empty()) << verify(mesh).front().text;
      expect_rules(mesh);
      if (HasFatalFailure()) return;
    }
}

TEST(ClassifyRandomTest, AnyClassesOfAFileCanBeDecimated) {
  for (const auto& [name, data] : zoo::all())
    for (unsigned seed = 0; seed < 12; ++seed)
      for (const Strategy strategy : {Strategy::Paper, Strategy::Quality}) {
        SCOPED_TRACE(name + ", seed " + std::to_string(seed));
        Mesh mesh(with_random_classes(data, seed));
        classify(mesh);
        Decimation decimation(mesh, {.strategy = strategy, .target_faces = 1, .angle_deg = 60});
        decimation.run();
        ASSERT_TRUE(verify(mesh).empty()) << verify(mesh).front().text;
      }
}

TEST(ClassifyRandomTest, ADecimationRefusesAClassificationThatIsNotClosed) {
  MeshData data = zoo::square();
  data.vertex_classes.assign(4, ModelRef(2, 1));
  data.edges.add(Shape::Line, {0, 1}, ModelRef(1, 1));
  Mesh mesh(data);
  EXPECT_THROW(Decimation{mesh}, std::invalid_argument);
  classify(mesh);
  EXPECT_NO_THROW(Decimation{mesh});
}

}  // namespace
}  // namespace aomd::classify_random_test
