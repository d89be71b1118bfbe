// Decimation with the quality strategy: what it keeps on the zoo and on samples, how far it gets,
// and that its result depends on mesh and options alone.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/decimate/decimation.h"
#include "core/measure/normals.h"
#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::quality_test {
namespace {

using test::classified;
using test::Edges;
using test::finding;
using test::quality;
using test::without_edges;

struct Job {
  Job(const MeshData& data, const DecimationOptions& options, Edges edges = Edges::All)
      : mesh(classified(data, edges)) {
    decimation.emplace(mesh, options);
  }
  Mesh mesh;
  std::optional<Decimation> decimation;
};

bool all_finite(const Mesh& mesh) {
  for (const Vertex v : mesh.vertices())
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(mesh.position(v)[k])) return false;
  return true;
}

// What no decimation may touch.
struct Kept {
  explicit Kept(const Mesh& mesh) : euler(zoo::euler(mesh)) {
    for (const Vertex v : mesh.vertices()) {
      classes[v.index] = mesh.classification(v);
      if (mesh.classification(v).dimension() == 0) corners[v.index] = mesh.position(v);
    }
    ends = curve_ends(mesh);
  }
  // Of each model edge, the number of its mesh edges at each vertex, where that is not two: how it
  // ends and branches.
  static std::multiset<std::pair<std::int32_t, int>> curve_ends(const Mesh& mesh) {
    std::map<std::pair<std::int32_t, std::uint32_t>, int> at;
    for (const Edge e : mesh.edges())
      if (mesh.classification(e).dimension() == 1)
        for (const Vertex v : mesh.edge_vertices(e)) ++at[{mesh.classification(e).tag(), v.index}];
    std::multiset<std::pair<std::int32_t, int>> all;
    for (const auto& [where, n] : at)
      if (n != 2) all.insert({where.first, n});
    return all;
  }
  void expect_in(const Mesh& mesh, const std::string& what, bool curves = true) const {
    ASSERT_EQ(finding(mesh), "") << what;
    ASSERT_EQ(zoo::euler(mesh), euler) << what;
    ASSERT_TRUE(all_finite(mesh)) << what;
    for (const auto& [v, at] : corners) {
      ASSERT_TRUE(mesh.alive(Vertex(v))) << what << ", model vertex " << v;
      EXPECT_EQ(mesh.position(Vertex(v)), at) << what << ", model vertex " << v;
    }
    for (const Vertex v : mesh.vertices())
      ASSERT_EQ(mesh.classification(v), classes.at(v.index)) << what << ", vertex " << v.index;
    if (curves) {
      ASSERT_EQ(curve_ends(mesh), ends) << what;
    }
  }
  int euler;
  std::map<std::uint32_t, ModelRef> classes;
  std::map<std::uint32_t, glm::dvec3> corners;
  std::multiset<std::pair<std::int32_t, int>> ends;
};

std::vector<zoo::Animal> small_samples() {
  return test::samples({{"scan", 3000},
                        {"bracket", 2},
                        {"plane-hole", 12},
                        {"box", 4},
                        {"cylinder", 5},
                        {"sphere", 6},
                        {"torus", 24},
                        {"terrain", 20},
                        {"nonmanifold", 6}});
}

void expect_kept(const zoo::Animal& animal, const DecimationOptions& options) {
  if (testing::Test::HasFailure()) return;
  for (const Edges edges : {Edges::All, Edges::OnModelEdges}) {
    Mesh mesh(animal.data);
    classify(mesh);
    if (edges == Edges::OnModelEdges) mesh.keep_model_edges_only();
    const Kept kept(mesh);
    Decimation decimation(mesh, options);
    decimation.run();
    EXPECT_TRUE(decimation.done());
    kept.expect_in(
        mesh,
        animal.name + " to " + std::to_string(options.target_faces) + ", regularity " +
            std::to_string(options.regularity),
        animal.name != "dirty");  // two model edges beside one face of it may fall together
  }
}

TEST(QualityTest, KeepsWhatTheModelIsInTheZoo) {
  for (const zoo::Animal& animal : zoo::all())
    for (const double regularity : {0.0, 0.5, 1.0})
      for (const std::uint32_t target : {0u, 1u, std::uint32_t(animal.data.faces.size() / 2)})
        for (const double angle : {10.0, 150.0}) {
          DecimationOptions options = quality(target, regularity);
          options.angle_deg = angle;
          expect_kept(animal, options);
        }
}

TEST(QualityTest, KeepsWhatTheModelIsInSamples) {
  for (const zoo::Animal& sample : small_samples())
    for (const double regularity : {0.0, 0.5, 1.0})
      expect_kept(sample,
                  quality(static_cast<std::uint32_t>(sample.data.faces.size() / 5), regularity));
  for (const zoo::Animal& sample : small_samples()) {
    expect_kept(sample, quality(0));
    expect_kept(sample, {.strategy = Strategy::Quality, .factor = 3, .angle_deg = 30});
  }
}

TEST(QualityTest, ReachesTheTargetWhereNothingStandsAgainstIt) {
  for (const auto& [name, size] :
       {std::pair{"scan", 8000}, {"sphere", 12}, {"torus", 50}, {"terrain", 40}})
    for (const double regularity : {0.0, 0.5, 1.0})
      for (const int part : {4, 10}) {
        const MeshData data = make_sample(name, size);
        const auto target =
            static_cast<std::uint32_t>(data.faces.size()) / static_cast<std::uint32_t>(part);
        Job job(data, quality(target, regularity), Edges::OnModelEdges);
        job.decimation->run();
        EXPECT_LE(job.mesh.count(2), target) << name << ' ' << regularity;
        EXPECT_GE(job.mesh.count(2), target * 0.99) << name << ' ' << regularity;
      }
}

TEST(QualityTest, AFlatSheetBecomesTwoTriangles) {
  Job job(zoo::grid(12), quality(0));
  EXPECT_EQ(job.decimation->run(), Decimation::Stop::Done);
  EXPECT_EQ(job.mesh.count(2), 2u);
  EXPECT_EQ(job.mesh.count(0), 4u);
}

TEST(QualityTest, StepSweepAndRunGiveTheSameMesh) {
  for (const MeshData& data : {zoo::torus(40, 30), make_sample("bracket", 2)}) {
    const DecimationOptions options = quality(400);
    Job whole(data, options), steps(data, options), slices(data, options), sweeps(data, options);
    whole.decimation->run();
    std::uint32_t made = 0, counted = 0;
    while (steps.decimation->step()) ++made;
    while (slices.decimation->run(std::chrono::microseconds(1)) != Decimation::Stop::Done) {
    }
    while (!sweeps.decimation->done()) sweeps.decimation->sweep();
    const std::string expected = zoo::fingerprint(whole.mesh);
    EXPECT_EQ(zoo::fingerprint(steps.mesh), expected);
    EXPECT_EQ(zoo::fingerprint(slices.mesh), expected);
    EXPECT_EQ(zoo::fingerprint(sweeps.mesh), expected);
    for (const SweepStatistics& s : whole.decimation->sweeps())
      counted += s.collapses + s.swaps + s.smooths;
    EXPECT_EQ(counted, made);
    EXPECT_EQ(whole.decimation->sweeps().back().faces, whole.mesh.count(2));
    EXPECT_EQ(whole.decimation->sweeps(), steps.decimation->sweeps());
  }
}

TEST(QualityTest, TwiceTheSameIsTheSame) {
  for (const zoo::Animal& sample : small_samples()) {
    Job a(sample.data, quality(200)), b(sample.data, quality(200));
    a.decimation->run(), b.decimation->run();
    EXPECT_EQ(zoo::fingerprint(a.mesh), zoo::fingerprint(b.mesh)) << sample.name;
  }
}

TEST(QualityTest, EdgesAsEntitiesMakeNoDifference) {
  std::vector<zoo::Animal> all = zoo::all();
  for (zoo::Animal& sample : small_samples()) all.push_back(std::move(sample));
  for (const zoo::Animal& animal : all)
    for (const TopologyRule topology : {TopologyRule::Safe, TopologyRule::Paper}) {
      DecimationOptions options = quality(static_cast<std::uint32_t>(animal.data.faces.size() / 6));
      options.topology = topology;
      Job with(animal.data, options), without(animal.data, options, Edges::OnModelEdges);
      with.decimation->run(), without.decimation->run();
      EXPECT_TRUE(with.mesh.complete(1));
      EXPECT_FALSE(without.mesh.complete(1));
      EXPECT_EQ(without_edges(with.mesh), without_edges(without.mesh)) << animal.name;
      EXPECT_EQ(finding(with.mesh), "") << animal.name;
      EXPECT_EQ(finding(without.mesh), "") << animal.name;
      with.decimation.reset();
      with.mesh.keep_model_edges_only();
      EXPECT_EQ(with.mesh.count(1), without.mesh.count(1)) << animal.name;
    }
}

TEST(QualityTest, CancelLeavesAValidMeshAndCanGoOn) {
  const MeshData data = zoo::torus(40, 30);
  Job whole(data, quality(300));
  whole.decimation->run();
  for (const int when : {1, 3, 20, 60}) {
    Job job(data, quality(300));
    int asked = 0;
    EXPECT_EQ(job.decimation->run({}, [&] { return ++asked == when; }),
              Decimation::Stop::Cancelled);
    EXPECT_FALSE(job.decimation->done());
    EXPECT_EQ(finding(job.mesh), "");
    EXPECT_GE(job.decimation->progress(), 0);
    EXPECT_LE(job.decimation->progress(), 1);
    job.decimation->run();
    EXPECT_EQ(zoo::fingerprint(job.mesh), zoo::fingerprint(whole.mesh));
    EXPECT_EQ(job.decimation->progress(), 1);
  }
}

TEST(QualityTest, HistoriesGoBackAndForth) {
  std::vector<zoo::Animal> all = zoo::all();
  all.push_back({"bracket", make_sample("bracket", 2)});
  for (const zoo::Animal& animal : all)
    for (const Edges edges : {Edges::All, Edges::OnModelEdges}) {
      Mesh mesh(animal.data);
      classify(mesh);
      if (edges == Edges::OnModelEdges) mesh.keep_model_edges_only();
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      Decimation decimation(mesh,
                            quality(static_cast<std::uint32_t>(animal.data.faces.size() / 4)));
      decimation.run();
      const std::string end = zoo::fingerprint(mesh);
      journal.seek(mesh, 0);
      ASSERT_EQ(zoo::fingerprint(mesh), start) << animal.name;
      EXPECT_EQ(finding(mesh), "") << animal.name;
      journal.seek(mesh, journal.size());
      ASSERT_EQ(zoo::fingerprint(mesh), end) << animal.name;
      EXPECT_EQ(finding(mesh), "") << animal.name;
    }
}

TEST(QualityTest, GoesOnFromAnUndoneHalf) {
  for (const Edges edges : {Edges::All, Edges::OnModelEdges})
    for (const char* name : {"torus", "bracket", "scan"}) {
      Mesh mesh(make_sample(name, name[0] == 's' ? 3000 : name[0] == 't' ? 50 : 2));
      classify(mesh);
      if (edges == Edges::OnModelEdges) mesh.keep_model_edges_only();
      const Kept kept(mesh);
      const std::uint32_t target = mesh.count(2) / 4;
      Journal journal;
      mesh.attach(&journal);
      Decimation decimation(mesh, quality(target));
      decimation.run();
      const std::uint32_t reached = mesh.count(2);
      for (const int part : {2, 3}) {
        journal.seek(mesh, journal.size() / static_cast<std::size_t>(part));
        decimation.invalidate();
        EXPECT_FALSE(decimation.done());
        decimation.run();
        kept.expect_in(mesh, name);
        EXPECT_LE(mesh.count(2), std::max(reached, target)) << name;
      }
    }
}

TEST(QualityTest, NewOptionsMidWay) {
  const MeshData data = make_sample("torus", 60);
  for (const int steps : {10, 700, 2000}) {
    Job job(data, quality(600));
    const Kept kept(job.mesh);
    for (int i = 0; i < steps; ++i) job.decimation->step();
    job.decimation->set_options(quality(200, 1));
    job.decimation->run();
    EXPECT_LE(job.mesh.count(2), 200u) << steps;
    EXPECT_GE(job.mesh.count(2), 198u) << steps;
    kept.expect_in(job.mesh, "torus");
  }
}

TEST(QualityTest, AnotherStrategyMidWay) {
  for (const Edges edges : {Edges::All, Edges::OnModelEdges})
    for (const bool quality_first : {true, false}) {
      DecimationOptions options = quality(300);
      options.strategy = quality_first ? Strategy::Quality : Strategy::Paper;
      Job job(make_sample("bracket", 3), options, edges);
      const Kept kept(job.mesh);
      for (int i = 0; i < 100; ++i) job.decimation->step();
      options.strategy = quality_first ? Strategy::Paper : Strategy::Quality;
      job.decimation->set_options(options);
      EXPECT_EQ(job.decimation->options().strategy, options.strategy);
      for (int i = 0; i < 100; ++i) job.decimation->step();
      options.strategy = quality_first ? Strategy::Quality : Strategy::Paper;
      job.decimation->set_options(options);
      job.decimation->run();
      kept.expect_in(job.mesh, quality_first ? "quality, paper, quality" : "paper, quality, paper");
    }
}

// Beside the sharp edges of its bores and rims the surface looks two ways; none of its faces may
// follow the mean of them.
TEST(QualityTest, ABracketOfAHundredFacesHasNoneThatLooksAway) {
  const MeshData original = make_sample("bracket");
  Job job(original, quality(100));
  job.decimation->run();
  EXPECT_EQ(job.mesh.count(2), 100u);
  const TriangleTree tree(triangles_of(original).corners);
  EXPECT_EQ(measure::measure_normals(tree, job.mesh).flips, 0u);
}

}  // namespace
}  // namespace aomd::quality_test
