// Edits of several parts at once against the same edits one after the other.

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/mesh/journal.h"
#include "core/mesh/shared_edits.h"
#include "core/operators/collapse.h"
#include "core/operators/swap.h"
#include "core/parts/partition.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::shared_edits_test {
namespace {

constexpr std::size_t part_count = 6;

Mesh surface() {
  Mesh mesh = test::classified(zoo::torus(120, 90), test::Edges::OnModelEdges);
  mesh.set(2, 0), mesh.set(0, 2);
  return mesh;
}

// Every third vertex that lies inside a part goes to a neighbour that does; edges between such are
// swapped. What is made depends on the part alone.
class Worker {
 public:
  Worker(Mesh& mesh, const Partition& parts, std::size_t part)
      : mesh_(mesh), parts_(parts), collapser_(mesh), part_(part) {}

  /// With `edits`, else on the mesh itself, to the end or until there is no room any more. False
  /// then.
  bool work(SharedEdits* edits) {
    for (; next_ < mesh_.capacity(0); ++next_) {
      if (edits && !edits->has_room()) return false;
      const Vertex v(next_);
      if (parts_.part_of(v) != part_ || parts_.on_seam(v)) continue;
      if (mesh_.row<2>(v).empty()) continue;
      const auto t = mesh_.triangle(mesh_.row<2>(v)[0]);
      const Vertex w = t[0] == v ? t[1] : t[0];
      if (parts_.on_seam(w)) continue;
      next_ % 3 == 0 ? collapse(v, w, edits) : swap(v, w, edits);
    }
    return true;
  }

 private:
  void collapse(Vertex v, Vertex w, SharedEdits* edits) {
    const glm::dvec3 middle = (mesh_.position(v) + mesh_.position(w)) / 2.0;
    const CollapseRules rules{.max_turn = TurnLimit(60)};
    if (!collapser_.judge(mesh_, Contraction{v, w, middle}, rules, plan_).accepted()) return;
    edits ? collapser_.apply(mesh_, *edits, plan_) : collapser_.apply(mesh_, plan_);
  }
  void swap(Vertex v, Vertex w, SharedEdits* edits) {
    EdgePair pair;
    if (!find_pair(mesh_, v, w, pair).accepted() || joined(mesh_, pair.c, pair.d)) return;
    edits ? apply_swap(*edits, mesh_, pair) : apply_swap(mesh_, pair);
  }

  Mesh& mesh_;
  const Partition& parts_;
  Collapser collapser_;
  CollapsePlan plan_;
  std::size_t part_;
  std::uint32_t next_ = 0;
};

std::vector<Worker> workers(Mesh& mesh, const Partition& parts) {
  std::vector<Worker> all;
  for (std::size_t part = 0; part < part_count; ++part) all.emplace_back(mesh, parts, part);
  return all;
}

std::string one_after_the_other(int rounds) {
  Mesh mesh = surface();
  for (int i = 0; i < rounds; ++i) {
    const Partition parts(mesh, part_count, i);
    for (Worker& w : workers(mesh, parts)) EXPECT_TRUE(w.work(nullptr));
  }
  return zoo::fingerprint(mesh);
}

TEST(SharedEditsThreadsTest, AsOneAfterTheOther) {
  for (const int threads : {1, 2, 5}) {
    Mesh mesh = surface();
    ASSERT_TRUE(SharedEdits::possible(mesh));
    std::vector<SharedEdits> edits;
    int pauses = 0;
    for (int i = 0; i < 4; ++i) {
      const Partition parts(mesh, part_count, i);
      std::vector<Worker> all = workers(mesh, parts);
      for (std::atomic<bool> done = false; !done; ++pauses) {
        done = true;
        SharedEdits::begin(mesh, part_count, edits);
        parallel_for(part_count, threads, 1, [&](std::size_t begin, std::size_t end) {
          for (std::size_t p = begin; p < end; ++p)
            if (!all[p].work(&edits[p])) done = false;
        });
      }
      SharedEdits::settle(mesh, edits);
    }
    EXPECT_EQ(zoo::fingerprint(mesh), one_after_the_other(4)) << threads;
    EXPECT_EQ(test::finding(mesh), "");
    EXPECT_LT(mesh.count(2), 2u * 120 * 90 * 3 / 4);
    EXPECT_GT(pauses, 4);  // parts ran out of room and went on
  }
}

TEST(SharedEditsTest, WhereMoreWouldHaveToFollowTheyAreNotPossible) {
  Mesh mesh = surface();
  EXPECT_TRUE(SharedEdits::possible(mesh));
  Journal journal;
  mesh.attach(&journal);
  EXPECT_FALSE(SharedEdits::possible(mesh));
  mesh.attach(nullptr);
  mesh.keep_class_lists(true);
  EXPECT_FALSE(SharedEdits::possible(mesh));
  mesh.keep_class_lists(false);
  mesh.build_hash(2);
  EXPECT_FALSE(SharedEdits::possible(mesh));
  mesh.drop_hash(2);
  EXPECT_TRUE(SharedEdits::possible(mesh));
  mesh.set(0, 1);
  EXPECT_FALSE(SharedEdits::possible(mesh));
}

}  // namespace
}  // namespace aomd::shared_edits_test
