// Random programs of contractions and swaps by vertex pair: the same mesh whether the edges inside
// model faces are entities or not; verify stays silent; all back is the start, all forward the end.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/operators/collapse.h"
#include "core/operators/swap.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::contraction_program_test {
namespace {

using test::without_edges;

using Ends = std::pair<std::uint32_t, std::uint32_t>;

struct Edit {
  bool swap = false, accepted = false;
  Reason reason = Reason::None;
  Vertex a, b;
  friend bool operator==(const Edit&, const Edit&) = default;
};

// One random edit of the pair of vertices at a side of a face: it depends on faces and numbers
// alone.
class Program {
 public:
  Program(Mesh& mesh, std::uint32_t seed) : mesh_(mesh), collapser_(mesh), random_(seed) {}

  Edit edit() {
    const std::uint32_t id =
        mesh_.count(2) == 0 ? 0 : mesh_.ids(2).next_alive(random_() % mesh_.capacity(2));
    const std::uint32_t side = random_() % 3, kind = random_() % 8, place = random_() % 3;
    const bool paper = random_() % 4 == 0;
    const double along = double(random_() % 100) / 100, up = double(random_() % 100) / 1000;
    if (mesh_.count(2) == 0 || id >= mesh_.capacity(2)) return {};
    const auto t = mesh_.triangle(Face(id));
    Edit made{kind < 3, false, Reason::None, t[side], t[(side + 1) % 3]};
    if (random_() % 2) std::swap(made.a, made.b);
    const glm::dvec3 a = mesh_.position(made.a), b = mesh_.position(made.b);
    const glm::dvec3 at =
        place == 0 ? b : a + along * (b - a) + glm::dvec3(0, 0, place == 1 ? up : 0);
    made.swap ? swap(made) : contract(made, at, paper);
    return made;
  }

 private:
  void contract(Edit& made, const glm::dvec3& at, bool paper) {
    const CollapseRules rules{.max_turn = TurnLimit(170),
                              .topology = paper ? TopologyRule::Paper : TopologyRule::Safe,
                              .least_angle = LeastAngle(paper ? 0.0 : 3.0)};
    const Contraction c{made.a, made.b, at};
    const Verdict v = collapser_.judge(mesh_, c, rules, plan_);
    made.reason = v.reason;
    made.accepted = v.accepted();
    if (made.accepted) collapser_.apply(mesh_, plan_);
  }
  void swap(Edit& made) {
    EdgePair pair;
    made.reason = find_pair(mesh_, made.a, made.b, pair).reason;
    made.accepted = made.reason == Reason::None && !joined(mesh_, pair.c, pair.d);
    if (made.accepted) apply_swap(mesh_, pair);
  }

  Mesh& mesh_;
  Collapser collapser_;
  CollapsePlan plan_;
  std::mt19937 random_;
};

Mesh prepared(const MeshData& data, bool all_edges, const ClassifyOptions& options) {
  Mesh mesh(data);
  classify(mesh, options);
  if (all_edges)
    mesh.set(0, 1);
  else
    mesh.keep_model_edges_only();
  mesh.set(0, 2);
  mesh.keep_class_lists(true);
  return mesh;
}

std::string findings(const Mesh& mesh) {
  const auto all = verify(mesh);
  return all.empty() ? "" : all[0].name + ": " + all[0].text;
}

std::map<Ends, ModelRef> model_edges(const Mesh& mesh) {
  std::map<Ends, ModelRef> all;
  for (const Edge e : mesh.edges()) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (mesh.classification(e).dimension() <= 1)
      all[std::minmax(a.index, b.index)] = mesh.classification(e);
  }
  return all;
}

const ClassifyOptions one_face{.feature_angle_deg = {}};

TEST(ContractionProgramTest, EdgesAsEntitiesMakeNoDifference) {
  int accepted = 0;
  for (const zoo::Animal& animal : zoo::all())
    for (const ClassifyOptions& options : {ClassifyOptions{}, one_face})
      for (std::uint32_t seed = 0; seed < 20; ++seed) {
        Mesh all = prepared(animal.data, true, options),
             some = prepared(animal.data, false, options);
        Program with(all, seed), without(some, seed);
        for (int i = 0; i < 120; ++i) {
          const Edit a = with.edit(), b = without.edit();
          const std::string where = animal.name + " seed " + std::to_string(seed) + " edit " +
                                    std::to_string(i) + (a.swap ? " swap " : " contract ") +
                                    std::to_string(a.a.index) + ' ' + std::to_string(a.b.index);
          ASSERT_EQ(reason_name(a.reason), std::string(reason_name(b.reason))) << where;
          ASSERT_EQ(a, b) << where;
          if (!a.accepted) continue;
          ++accepted;
          ASSERT_EQ(findings(all), "") << where << ", all edges";
          ASSERT_EQ(findings(some), "") << where << ", model edges only";
          ASSERT_EQ(without_edges(all), without_edges(some)) << where;
          ASSERT_EQ(model_edges(all), model_edges(some)) << where;
        }
      }
  EXPECT_GT(accepted, 2000);
}

TEST(ContractionProgramTest, AllBackIsTheStartAndAllForwardTheEnd) {
  for (const zoo::Animal& animal : zoo::all())
    for (const bool all_edges : {true, false}) {
      Mesh mesh = prepared(animal.data, all_edges, one_face);
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      Program program(mesh, 7);
      std::size_t edits = 0;
      for (int i = 0; i < 200; ++i) edits += program.edit().accepted;
      EXPECT_EQ(journal.size(), edits) << "one step each";
      const std::string end = zoo::fingerprint(mesh);
      journal.seek(mesh, journal.size() / 2);
      ASSERT_EQ(findings(mesh), "") << animal.name;
      journal.seek(mesh, 0);
      ASSERT_EQ(zoo::fingerprint(mesh), start) << animal.name;
      ASSERT_EQ(findings(mesh), "") << animal.name;
      journal.seek(mesh, journal.size());
      ASSERT_EQ(zoo::fingerprint(mesh), end) << animal.name;
      ASSERT_EQ(findings(mesh), "") << animal.name;
    }
}

}  // namespace
}  // namespace aomd::contraction_program_test
