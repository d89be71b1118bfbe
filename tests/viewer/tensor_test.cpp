// Hash sets and id stacks as they are shown, who holds relations, and the two strategies of the
// paper.

#include <gtest/gtest.h>

#include <numeric>

#include "core/samples/samples.h"
#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"
#include "viewer/document/adjacency.h"
#include "viewer/explain/id_facts.h"

namespace aomd::scene::tensor_test {
namespace {

using test::drive;
using Ids = std::vector<std::uint32_t>;

std::uint64_t buckets_of(const HashFacts& facts) {
  return std::accumulate(facts.buckets.begin(), facts.buckets.end(), std::uint64_t{0});
}

TEST(HashFacts, OfASquareWithoutAndWithASet) {
  Mesh mesh(zoo::square());
  mesh.set(1, 0);
  EXPECT_FALSE(hash_facts(mesh, 1).built);
  mesh.build_hash(1);
  const HashFacts facts = hash_facts(mesh, 1);
  EXPECT_TRUE(facts.built);
  EXPECT_EQ(facts.entities, 5u);
  EXPECT_EQ(facts.statistics.buckets, 61u);
  EXPECT_EQ(buckets_of(facts), 61u);
  EXPECT_EQ(facts.buckets[0], 61u - facts.statistics.used);
  EXPECT_EQ(facts.statistics.crowded, 0u);
  EXPECT_TRUE(facts.rehashes.empty());
}

/// Keys that fall into chosen buckets of a set of 61.
TEST(HashFacts, CrowdedBucketsAndGrowthAreCountedExactly) {
  EntityHash hash;
  hash.build(61);
  std::uint32_t id = 0;
  for (std::uint64_t bucket = 0; bucket < 10; ++bucket) hash.insert(bucket, id++);
  for (std::uint64_t k = 1; k < 10; ++k) hash.insert(61 * k, id++);  // bucket 0 gets its tenth
  EXPECT_EQ(hash.statistics().crowded, 1u) << "one of ten: not more than 10 %";
  EXPECT_EQ(hash.statistics().worst, 10u);
  EXPECT_TRUE(hash.rehashes().empty());
  EXPECT_EQ(hash.lengths(), (Ids{51, 9, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  for (std::uint64_t k = 1; k < 10; ++k) hash.insert(61 * k + 1, id++);  // and bucket 1: two of ten
  ASSERT_EQ(hash.rehashes().size(), 1u);
  EXPECT_EQ(hash.rehashes()[0], (EntityHash::Rehash{28, 61, 611}));
  EXPECT_EQ(hash.statistics().buckets, 611u);
  const Ids lengths = hash.lengths();
  std::uint32_t entities = 0;
  for (std::uint32_t n = 0; n < lengths.size(); ++n) entities += n * lengths[n];
  EXPECT_EQ(entities, 28u);
}

TEST(HashFacts, BuiltSmallItGrowsAndTheBarsSumToTheEntities) {
  Session s;
  drive(s, {"sample sphere 8", "hash-sets build edge 61", "expect hash-entities = 1920"});
  const HashFacts facts = hash_facts(s.document().mesh(), 1);
  EXPECT_GE(facts.rehashes.size(), 1u);
  EXPECT_EQ(facts.rehashes[0].before, 61u);
  EXPECT_EQ(facts.rehashes[0].after, 611u);
  EXPECT_EQ(buckets_of(facts), facts.statistics.buckets);
  EXPECT_LE(facts.crowded_share(), 0.1);
  drive(s, {"hash-sets build edge", "expect hash-rehashes = 0", "expect hash-buckets = 1921",
            "coarsest on", "angle 60", "step", "expect hash-entities = 1917", "undo",
            "expect hash-entities = 1920", "hash-sets release edge", "expect hash-entities = 0"});
  EXPECT_THROW(execute(s, "hash-sets build vertex"), CommandError);
  EXPECT_THROW(execute(s, "hash-sets build edge 0"), CommandError);
  EXPECT_THROW(execute(s, "hash-sets maybe"), CommandError);
}

TEST(HashFacts, TheLastBarIsThatOfTheCrowdedBuckets) {
  Mesh mesh(make_sample("sphere", 3));
  mesh.set(1, 0);
  mesh.build_hash(1, 61);
  const HashFacts facts = hash_facts(mesh, 1);
  EXPECT_EQ(facts.entities, 270u);
  EXPECT_TRUE(facts.rehashes.empty());
  ASSERT_GT(facts.statistics.crowded, 0u);
  EXPECT_EQ(facts.buckets[10], facts.statistics.crowded);
  EXPECT_DOUBLE_EQ(facts.crowded_share(),
                   static_cast<double>(facts.buckets[10]) / facts.statistics.used);
}

TEST(IdFacts, ACollapsePushesIdsAndUndoTakesThemBack) {
  Session s;
  drive(s, {"sample sphere 8"});
  const Mesh& mesh = s.document().mesh();
  EXPECT_EQ(id_facts(mesh, 2).next, mesh.count(2)) << "an empty stack: the next id is fresh";
  drive(s, {"coarsest on", "angle 60", "step", "expect free-vertices = 1", "expect free-edges = 3",
            "expect free-faces = 2"});
  const IdFacts edges = id_facts(mesh, 1);
  EXPECT_EQ(edges.alive, mesh.count(1));
  EXPECT_EQ(edges.capacity, edges.alive + 3);
  ASSERT_EQ(edges.top.size(), 3u);
  EXPECT_EQ(edges.next, edges.top[0]);
  EXPECT_EQ(Ids(edges.top.rbegin(), edges.top.rend()), mesh.ids(1).free_ids());
  drive(s, {"step -1", "expect free-edges = 0"});
  drive(s, {"sweep"});
  EXPECT_EQ(id_facts(mesh, 2).top.size(), IdFacts::most_shown);
}

TEST(Askers, AreNamedWhileTheyHoldARelation) {
  Session s;
  drive(s, {"sample sphere 8"});
  const Mesh& mesh = s.document().mesh();
  EXPECT_EQ(askers(mesh, 0, 2), "drawing");
  EXPECT_EQ(askers(mesh, 1, 2), "");
  drive(s, {"step"});
  EXPECT_EQ(askers(mesh, 0, 2), "drawing, the paper's loop");
  drive(s, {"adjacency 0 2 on", "strategy quality", "step"});
  EXPECT_EQ(askers(mesh, 0, 2), "you or its source, drawing, the quality loop");
}

TEST(Askers, TheOneThatLetsGoIsGone) {
  Mesh mesh(zoo::square());
  Request first = mesh.request(0, 2, "first");
  const Request second = mesh.request(0, 2, "second");
  EXPECT_EQ(askers(mesh, 0, 2), "first, second");
  first.release();
  EXPECT_EQ(askers(mesh, 0, 2), "second");
  EXPECT_TRUE(mesh.stored(0, 2));
}

TEST(Strategies, BothLeadToTheSameMeshAndFreeWhatTheyDoNotHold) {
  for (const char* sample : {"sphere", "bracket", "scan"}) {
    DecimationOptions options;
    options.angle_deg = 30;
    const MeshData data = make_sample(sample, sample[1] == 'c' ? 2000 : 0);
    const StorageComparison result = compare_storage(data, options);
    EXPECT_TRUE(result.same) << sample;
    EXPECT_EQ(result.ways[0].counts, result.ways[1].counts) << sample;
    EXPECT_EQ(result.ways[0].exchanges, 0u);
    EXPECT_GT(result.ways[1].exchanges, 0u) << sample;
    EXPECT_GT(result.ways[1].collapses.peak, 0u);
    EXPECT_NE(result.ways[0].improvement.bytes, result.ways[1].improvement.bytes);
  }
}

TEST(Strategies, WiresWithoutFacesGuardsAndThePrintedTopologyToo) {
  MeshData wired = make_sample("sphere", 8);
  wired.edges.add(Shape::Line, {0, 50});
  DecimationOptions options;
  options.angle_deg = 40;
  EXPECT_TRUE(compare_storage(wired, options).same);
  options.topology = TopologyRule::Paper;
  EXPECT_TRUE(compare_storage(make_sample("nonmanifold", 0), options).same);
  options.topology = TopologyRule::Safe;
  options.no_intersections = true;
  options.max_distance = 0.05;
  EXPECT_TRUE(compare_storage(make_sample("torus", 0), options).same);
}

TEST(Strategies, WhileItSwapsNothingIsHeldThatSwapsDoNotRead) {
  Mesh mesh(make_sample("sphere", 8));
  DecimationOptions options;
  options.exchange = true;
  {
    Decimation decimation(mesh, options);
    static_cast<void>(decimation.run_phase());
    EXPECT_TRUE(mesh.stored(0, 2) && mesh.hash(1).built());
    EXPECT_FALSE(mesh.stored(0, 1) || mesh.stored(1, 2));
    ASSERT_EQ(decimation.phase(), Phase::Swap);
    static_cast<void>(decimation.run_phase());
    EXPECT_TRUE(mesh.stored(0, 1) && mesh.stored(1, 2));
    EXPECT_FALSE(mesh.stored(0, 2) || mesh.hash(1).built());
    static_cast<void>(decimation.run());
  }
  EXPECT_FALSE(mesh.stored(0, 1) || mesh.stored(0, 2) || mesh.stored(1, 2) || mesh.hash(1).built());
}

TEST(Strategies, RunInTheBackgroundOfASessionAndCanBeCancelled) {
  Session s;
  drive(s, {"sample torus", "sweep", "strategies run", "expect same-result = 1", "strategies on"});
  ASSERT_NE(s.sheet().storage(), nullptr);
  EXPECT_TRUE(s.view.panels.side && s.view.panels.page == Page::Adjacency &&
              s.view.sections.strategies);
  EXPECT_EQ(s.document().journal().size(), s.document().journal().cursor())
      << "the present mesh is left alone";
  drive(s, {"copy strategies"});
  EXPECT_EQ(s.clipboard.get().rfind(
                "Way\tPart\tMs\tBytes after it\tBytes at most\nKeep T(0,2)\tcollapses\t", 0),
            0u);
  execute(s, "strategies run");
  EXPECT_FALSE(s.idle());
  execute(s, "cancel");
  EXPECT_TRUE(s.idle());
  EXPECT_EQ(s.sheet().storage(), nullptr);
  drive(s, {"sample tet-box"});
  EXPECT_THROW(execute(s, "strategies run"), CommandError);
}

}  // namespace
}  // namespace aomd::scene::tensor_test
