// Random programs of edge removals, face removals and moves: the same mesh whether sides inside
// regions are entities or not; verify stays silent, an oracle counts the same; all back is the
// start, all forward the end.

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/journal.h"
#include "core/operators/edge_removal.h"
#include "core/operators/face_removal.h"
#include "core/operators/region_move.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd {
namespace {

using namespace test;

enum class Kind { Edge, Face, Move };

struct Edit {
  Kind kind = Kind::Move;
  Reason reason = Reason::None;
  std::uint32_t region = 0;
  friend bool operator==(const Edit&, const Edit&) = default;
};

// One random edit around a region: it depends on regions and numbers alone.
class Program {
 public:
  Program(Mesh& mesh, std::uint32_t seed) : mesh_(mesh), mover_(mesh), random_(seed) {}

  Edit edit() {
    const std::uint32_t start = random_() % mesh_.capacity(3), kind = random_() % 8;
    const std::uint32_t i = random_() % 4, k = (i + 1 + random_() % 3) % 4;
    std::uint32_t id = mesh_.ids(3).next_alive(start);
    if (id >= mesh_.capacity(3)) id = mesh_.ids(3).next_alive(0);
    const auto t = mesh_.tetrahedron(Region(id));
    if (kind < 4) return {Kind::Edge, remove_edge(t[i], t[k]), id};
    if (kind < 6) return {Kind::Face, remove_face(Region(id), i), id};
    return {Kind::Move, move(t[i]), id};
  }

 private:
  Reason remove_edge(Vertex a, Vertex b) {
    EdgeRemoval plan;
    if (judge(mesh_, a, b, {.max_turn = TurnLimit(40)}, plan).accepted()) apply(mesh_, plan);
    return plan.verdict.reason;
  }
  Reason remove_face(Region r, std::uint32_t slot) {
    FaceRemoval plan;
    if (judge(mesh_, r, slot, plan).accepted()) apply(mesh_, plan);
    return plan.verdict.reason;
  }
  Reason move(Vertex v) {
    RegionMove plan;
    if (mover_.judge(mesh_, v, {.max_turn = TurnLimit(40)}, plan).accepted())
      RegionMover::apply(mesh_, plan);
    return plan.verdict.reason;
  }

  Mesh& mesh_;
  RegionMover mover_;
  std::mt19937 random_;
};

struct Start {
  const char* name;
  MeshData data;
  ClassifyOptions options;
  double volume_share;  ///< that a region may gain or lose to another by swapped diagonals
};

MeshData flattened(MeshData data) {
  for (glm::dvec3& p : data.positions) p.z *= 0.3;
  return data;
}

std::vector<Start> starts() {
  return {{"box", shaken("tet-box", 3, 0.15, 1), {}, 1e-12},
          {"flat box", flattened(shaken("tet-box", 3, 0.1, 2)), {}, 1e-12},
          {"box, one model face", shaken("tet-box", 3, 0.1, 2), smooth_skin, 0.2},
          {"flat ball", flattened(shaken("tet-ball", 3, 0.1, 3)), smooth_skin, 0.2},
          {"drilled", shaken("tet-drilled", 3, 0.1, 4), {}, 0.05}};
}

TEST(VolumeProgramTest, SidesInsideRegionsAsEntitiesMakeNoDifference) {
  std::array<int, 3> made{};
  for (const Start& start : starts())
    for (std::uint32_t seed = 0; seed < 2; ++seed) {
      VolumeBench listed(start.data, Levels::Listed, start.options),
          complete(start.data, Levels::Complete, start.options);
      const VolumeOracle before = volume_oracle(to_data(listed.mesh));
      Program some(listed.mesh, seed), all(complete.mesh, seed);
      for (int i = 0; i < 400; ++i) {
        const Edit a = some.edit(), b = all.edit();
        ASSERT_EQ(a, b) << start.name << " seed " << seed << " edit " << i << ": "
                        << reason_name(a.reason) << ' ' << reason_name(b.reason);
        if (a.reason != Reason::None) continue;
        ++made[static_cast<std::size_t>(a.kind)];
        ASSERT_EQ(complete.finding(), "") << start.name << " seed " << seed << " edit " << i;
        ASSERT_EQ(listed.finding(), "") << start.name << " seed " << seed << " edit " << i;
        ASSERT_EQ(to_data(listed.mesh), to_data(complete.mesh)) << start.name << " edit " << i;
      }
      expect_kept(before, volume_oracle(to_data(listed.mesh)), start.volume_share);
      ASSERT_FALSE(testing::Test::HasFailure()) << start.name << " seed " << seed;
    }
  EXPECT_GT(made[0], 100) << "edges";
  EXPECT_GT(made[1], 10) << "faces";
  EXPECT_GT(made[2], 100) << "moves";
}

TEST(VolumeProgramTest, AllBackIsTheStartAndAllForwardTheEnd) {
  for (const Start& start : starts())
    for (const Levels levels : both_levels) {
      VolumeBench b(start.data, levels, start.options);
      const std::string first = zoo::fingerprint(b.mesh);
      Journal journal;
      b.mesh.attach(&journal);
      Program program(b.mesh, 7);
      std::size_t edits = 0;
      for (int i = 0; i < 400; ++i) edits += program.edit().reason == Reason::None;
      EXPECT_EQ(journal.size(), edits) << "one step each";
      const std::string end = zoo::fingerprint(b.mesh);
      journal.seek(b.mesh, edits / 2);
      ASSERT_EQ(b.finding(), "") << start.name;
      journal.seek(b.mesh, 0);
      ASSERT_EQ(zoo::fingerprint(b.mesh), first) << start.name;
      ASSERT_EQ(b.finding(), "") << start.name;
      while (journal.redo(b.mesh)) {
      }
      ASSERT_EQ(zoo::fingerprint(b.mesh), end) << start.name;
      ASSERT_EQ(b.finding(), "") << start.name;
      b.mesh.attach(nullptr);
    }
}

}  // namespace
}  // namespace aomd
