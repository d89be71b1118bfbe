// Random programs of edge removals, face removals and moves: the same mesh whether sides inside
// regions are entities or not; verify stays silent, an oracle counts the same; all back is the
// start, all forward the end.

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/tet_geometry.h"
#include "core/operators/edge_removal.h"
#include "core/operators/face_removal.h"
#include "core/operators/region_move.h"
#include "tests/support/volume_bench.h"
#include "tests/support/volume_oracle.h"

namespace aomd::volume_program_test {
namespace {

using namespace test;

enum class Kind { Edge, Face, Move, Shake, WorseEdge, WorseFace };

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
    const std::uint32_t kind = random_() % 16, i = random_() % 4, k = (i + 1 + random_() % 3) % 4;
    const std::uint32_t id = worst_of_some(6).index;
    const auto t = mesh_.tetrahedron(Region(id));
    glm::dvec3 by;
    for (int axis = 0; axis < 3; ++axis) by[axis] = double(random_() % 2001) / 1000 - 1;
    if (kind >= 14) return {Kind::WorseFace, worsen(Region(id), i), id};
    if (kind >= 12) return {Kind::WorseEdge, worsen(t[i], t[k]), id};
    if (kind >= 8) return {Kind::Shake, shake(t[i], by), id};
    if (kind < 4) return {Kind::Edge, remove_an_edge(t), id};
    if (kind < 7) return {Kind::Face, remove_a_face(Region(id)), id};
    return {Kind::Move, move(t[i]), id};
  }

 private:
  Reason remove_an_edge(const std::array<Vertex, 4>& t) {
    EdgeRemoval plan;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k)
        if (judge(mesh_, t[i], t[k], {.max_turn = TurnLimit(40)}, plan).accepted()) {
          apply(mesh_, plan);
          return Reason::None;
        }
    return plan.verdict.reason;
  }
  Reason remove_a_face(Region r) {
    FaceRemoval plan;
    for (std::uint32_t slot = 0; slot < 4; ++slot)
      if (judge(mesh_, r, slot, {}, plan).accepted()) {
        apply(mesh_, plan);
        return Reason::None;
      }
    return plan.verdict.reason;
  }
  Reason move(Vertex v) {
    RegionMove plan;
    if (mover_.judge(mesh_, v, {.max_turn = TurnLimit(40)}, plan).accepted())
      RegionMover::apply(mesh_, plan);
    return plan.verdict.reason;
  }

  Region worst_of_some(int tries) {
    Region worst;
    double least = 2;
    for (int i = 0; i < tries; ++i) {
      std::uint32_t id = mesh_.ids(3).next_alive(random_() % mesh_.capacity(3));
      if (id >= mesh_.capacity(3)) id = mesh_.ids(3).next_alive(0);
      const double shape = tet_shape(mesh_, Region(id));
      if (shape >= least) continue;
      least = shape;
      worst = Region(id);
    }
    return worst;
  }
  // Removes an edge or a face although that makes shapes worse, so that there is always something
  // to do.
  Reason worsen(Vertex a, Vertex b) {
    EdgeRemoval plan;
    if (judge(mesh_, a, b, {.max_turn = TurnLimit(40)}, plan).reason != Reason::Quality ||
        plan.after < 0.01)
      return Reason::Quality;
    plan.verdict = {};
    apply(mesh_, plan);
    return Reason::None;
  }
  Reason worsen(Region r, std::uint32_t slot) {
    FaceRemoval plan;
    if (judge(mesh_, r, slot, {}, plan).reason != Reason::Quality || plan.after < 0.01)
      return Reason::Quality;
    plan.verdict = {};
    apply(mesh_, plan);
    return Reason::None;
  }
  // Moves a vertex anywhere where nothing turns over.
  Reason shake(Vertex v, const glm::dvec3& by) {
    if (mesh_.classification(v).dimension() != 3) return Reason::Classification;
    Ball ball;
    gather(mesh_, v, ball);
    double edge = 1;
    for_corners(ball, [&](Vertex far) {
      edge = std::min(edge, glm::length(mesh_.position(far) - mesh_.position(v)));
    });
    const glm::dvec3 to = mesh_.position(v) + 0.7 * edge * by;
    for (const BallRegion& r : ball)
      if (!is_upright(to, mesh_.position(r.others[0]), mesh_.position(r.others[1]),
                      mesh_.position(r.others[2])))
        return Reason::Flat;
    mesh_.move(v, to);
    return Reason::None;
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
  return {{"box", shaken("tet-box", 3, 0.1, 1), {}, 1e-12},
          {"flat box", flattened(shaken("tet-box", 3, 0.1, 2)), {}, 1e-12},
          {"box, one model face", shaken("tet-box", 3, 0.1, 2), smooth_skin, 0.2},
          {"flat ball", flattened(shaken("tet-ball", 3, 0.1, 3)), smooth_skin, 0.2},
          {"drilled", shaken("tet-drilled", 3, 0.1, 4), {}, 0.05}};
}

TEST(VolumeProgramTest, SidesInsideRegionsAsEntitiesMakeNoDifference) {
  std::array<int, 6> made{};
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
  EXPECT_GT(made[1] + made[5], 20) << "faces";
  EXPECT_GT(made[2], 30) << "moves";
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
}  // namespace aomd::volume_program_test
