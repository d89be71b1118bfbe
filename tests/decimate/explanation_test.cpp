// Verdicts in words, exactly, on meshes small enough to work them out.

#include <gtest/gtest.h>

#include "core/decimate/decimation.h"
#include "core/decimate/explain/explanation.h"
#include "core/model/classify.h"
#include "tests/support/zoo.h"

namespace aomd::explanation_test {
namespace {

struct Bench {
  explicit Bench(const MeshData& data, const DecimationOptions& options = {.coarsest = true},
                 bool classified = true)
      : mesh(data) {
    mesh.set(0, 1);
    if (classified) classify(mesh);
    decimation.emplace(mesh, options);
  }
  Edge edge(std::uint32_t a, std::uint32_t b) const { return mesh.find_edge(Vertex(a), Vertex(b)); }
  CollapseOutlook outlook(std::uint32_t deleted, std::uint32_t kept) {
    for (const CollapseOutlook& o : decimation->outlook(edge(deleted, kept)))
      if (o.contraction.deleted == Vertex(deleted)) return o;
    ADD_FAILURE() << "no such way";
    return {};
  }
  std::string collapse(std::uint32_t deleted, std::uint32_t kept) {
    return explain_collapse(mesh, outlook(deleted, kept), decimation->options());
  }
  std::string swap(std::uint32_t a, std::uint32_t b) {
    return explain_swap(mesh, edge(a, b), *decimation->swap_outlook(edge(a, b)));
  }
  std::string move(std::uint32_t v) {
    return explain_move(mesh, *decimation->move_outlook(Vertex(v)));
  }
  /// "Length+ Model! Topology-": passed, failed, not reached.
  std::string checks(std::uint32_t deleted, std::uint32_t kept) {
    std::string text;
    for (const CheckResult& c : collapse_checks(outlook(deleted, kept), decimation->options()))
      text += std::string(text.empty() ? "" : " ") + c.name + "+!-"[static_cast<int>(c.state)];
    return text;
  }
  Mesh mesh;
  std::optional<Decimation> decimation;
};

std::shared_ptr<const Column<Vertex, double>> everywhere(double length) {
  return std::make_shared<const Column<Vertex, double>>(64, length);
}

// The grid of paper figure 5:      12-13-14-15
//                                   8--9-10-11
//                                   4--5--6--7
//                                   0--1--2--3
TEST(Explanation, ClassificationSaysWhatTheVertexLiesOn) {
  Bench b(zoo::grid(3));
  const std::string side = std::to_string(b.mesh.classification(Vertex(1)).tag());
  EXPECT_EQ(b.collapse(0, 1), "Vertex 0 is a model vertex, and these stay.");
  EXPECT_EQ(b.collapse(1, 5),
            "Vertex 1 lies on model edge " + side +
                " and the edge on model face 1: a vertex goes only along what it lies on.");
  EXPECT_EQ(b.collapse(1, 0), "Nothing is against it: vertex 1 would go into vertex 0.");
  EXPECT_EQ(b.checks(0, 1), "Length+ Model! Topology- Faces- Model edge-");
  EXPECT_EQ(b.checks(5, 6), "Length+ Model+ Topology+ Faces+");
}

TEST(Explanation, LengthNamesTheWantedOne) {
  Bench b(zoo::grid(3), {.spacing = everywhere(1.5)});
  EXPECT_EQ(b.collapse(5, 6),
            "Its length is 1, and an edge goes only where it is shorter than 0.75, half the "
            "spacing of 1.5.");
  EXPECT_EQ(b.checks(5, 6), "Length! Model- Topology- Faces-");
  Bench close(zoo::grid(3), {.spacing = everywhere(1.9999)});
  EXPECT_EQ(close.collapse(5, 6),
            "Its length is 1, and an edge goes only where it is shorter than 0.99995, half the "
            "spacing of 2.");
}

//  3---2
//  |\ /|     the apex 4 lies 0.1 above the middle: each face leans by atan(0.2) = 11.31 degrees
//  | 4 |
//  |/ \|
//  0---1
MeshData low_pyramid(double height = 0.1) {
  return zoo::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, height}},
                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

TEST(Explanation, AngleNamesTheFaceTheTurnAndTheLimit) {
  Bench b(low_pyramid());
  EXPECT_EQ(b.collapse(4, 0), "Face 1 would turn by 11.3 degrees; the limit is 10.");
  EXPECT_EQ(b.outlook(4, 0).verdict.entity, EntityRef(Face(1)));
  EXPECT_EQ(b.checks(4, 0), "Length+ Model+ Topology+ Faces!");
  Bench near(low_pyramid(), {.coarsest = true, .angle_deg = 11.3});
  EXPECT_EQ(near.collapse(4, 0), "Face 1 would turn by 11.3099 degrees; the limit is 11.3.");
}

TEST(Explanation, ShapeAndKeptAndTarget) {
  Bench narrow(low_pyramid(), {.coarsest = true, .angle_deg = 90, .min_angle_deg = 46});
  EXPECT_EQ(narrow.collapse(4, 0), "Face 1 would get an angle of 45 degrees; the least is 46.");
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(16, std::uint8_t{0});
  (*keep)[Vertex(5)] = 1;
  Bench kept(zoo::grid(3), {.coarsest = true, .keep = keep});
  EXPECT_EQ(kept.collapse(5, 6), "Vertex 5 is to stay where it is.");
  EXPECT_EQ(kept.checks(5, 6), "Length+ Kept! Model- Topology- Faces-");
  EXPECT_EQ(kept.move(5), "Vertex 5 is to stay where it is.");
  Bench enough(zoo::grid(3), {.coarsest = true, .target_faces = 18});
  EXPECT_EQ(
      enough.collapse(5, 6),
      "Nothing is against it, but the mesh has come down to the 18 faces that were asked for.");
}

TEST(Explanation, TopologySaysWhatWouldBreak) {
  const DecimationOptions any{.coarsest = true, .angle_deg = 170};
  EXPECT_EQ(Bench(zoo::tetrahedron(), any, false).collapse(0, 1), "A face would fall onto face 3.");
  EXPECT_EQ(Bench(zoo::book(), any, false).collapse(0, 1),
            "The edge to vertex 2 would be left without a face.");
  EXPECT_EQ(Bench(zoo::square(), any, false).collapse(0, 2),
            "Both ends lie on the border and the edge does not: the surface would be pinched.");
  // A tube with three sides, open at both ends.
  const MeshData tube =
      zoo::make({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, 0, 3}, {-1, 1, 3}, {-1, -1, 3}},
                {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
  EXPECT_EQ(Bench(tube, any, false).collapse(0, 1),
            "Both ends are joined to vertex 2, which no face of this edge has: the surface would "
            "be pinched "
            "there.");
}

TEST(Explanation, SwapAndSmoothing) {
  Bench b(zoo::grid(3));
  const std::string side = std::to_string(b.mesh.classification(Vertex(1)).tag());
  EXPECT_EQ(b.swap(0, 1), "The edge lies on model edge " + side + ".");
  EXPECT_EQ(b.swap(0, 5),
            "It would not pay: the smallest angle of its two faces would be 45 degrees; it is 45.");
  EXPECT_EQ(b.move(1), "It would stay in place.");
  EXPECT_EQ(b.move(5), "It would stay in place.");
  EXPECT_EQ(b.move(0), "It lies on model vertex " +
                           std::to_string(b.mesh.classification(Vertex(0)).tag()) +
                           ", and is not moved off it.");
  MeshData shifted = zoo::grid(3);
  shifted.positions[5].x += 0.25;
  EXPECT_EQ(Bench(shifted).move(5), "It would move by 0.25.");
}

TEST(Explanation, GuardsNameTheirLimit) {
  // The pyramid may be flattened as far as angles go, but its tip lies 0.1 above.
  Bench b(low_pyramid(), {.coarsest = true, .angle_deg = 90, .max_distance = 0.01});
  const std::string words = b.collapse(4, 0);
  EXPECT_EQ(words.rfind("At face 1 the surface would leave the original by ", 0), 0u) << words;
  EXPECT_NE(words.find("; the limit is 0.01."), std::string::npos) << words;
  EXPECT_EQ(b.checks(4, 0), "Length+ Model+ Topology+ Faces+ Distance!");
}

TEST(Explanation, QualityPlacesTheVertexAndHasACost) {
  Bench b(zoo::grid(3), {.strategy = Strategy::Quality, .coarsest = true, .angle_deg = 60});
  const auto ways = b.decimation->outlook(b.edge(5, 6));
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_TRUE(ways[0].cost.has_value());
  EXPECT_TRUE(ways[0].verdict.accepted());
  EXPECT_FALSE(b.decimation->swap_outlook(b.edge(5, 6)).has_value())
      << "not known while it collapses";
  const auto border = b.decimation->outlook(b.edge(0, 5));
  EXPECT_EQ(border[0].contraction.kept, Vertex(0));
  Bench square(zoo::square(), {.strategy = Strategy::Quality, .coarsest = true});
  const std::string words = explain_collapse(
      square.mesh, square.decimation->outlook(square.edge(0, 1))[0], square.decimation->options());
  EXPECT_EQ(words, "Both ends are model vertices, and these stay.");
}

// Asking must not change what is done afterwards.
TEST(Explanation, AskingChangesNothing) {
  for (const Strategy strategy : {Strategy::Paper, Strategy::Quality}) {
    const DecimationOptions options{.strategy = strategy, .factor = 3, .angle_deg = 30};
    Bench asked(zoo::torus(24, 16), options), silent(zoo::torus(24, 16), options);
    for (int i = 0; asked.decimation->step(); ++i) {
      if (i % 7 != 0) continue;
      for (const Edge e : asked.mesh.edges()) {
        static_cast<void>(asked.decimation->outlook(e));
        static_cast<void>(asked.decimation->swap_outlook(e));
      }
      for (const Vertex v : asked.mesh.vertices())
        static_cast<void>(asked.decimation->move_outlook(v));
    }
    silent.decimation->run();
    ASSERT_EQ(asked.mesh.count(2), silent.mesh.count(2));
    for (const Face f : silent.mesh.faces())
      EXPECT_EQ(asked.mesh.triangle(f), silent.mesh.triangle(f));
    for (const Vertex v : silent.mesh.vertices())
      EXPECT_EQ(asked.mesh.position(v), silent.mesh.position(v));
  }
}

}  // namespace
}  // namespace aomd::explanation_test
