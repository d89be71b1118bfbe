// Random edit programs: whatever T stores, the same edits give the same mesh; all back is the
// start, all forward the end; verify stays silent.

#include <gtest/gtest.h>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/operators/collapse.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"
#include "tests/support/zoo.h"

namespace aomd::random_edits_test {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint32_t operator()(std::uint32_t below) {
    return below ? static_cast<std::uint32_t>(
                       EntityHash::mix(static_cast<std::uint32_t>(++state_)) % below)
                 : 0;
  }

 private:
  std::uint64_t state_;
};

// One random edit; what it does depends on the mesh and the numbers alone, never on T.
class Program {
 public:
  Program(Mesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {}

  void edit() {
    switch (random_(8)) {
      case 0:
      case 1:
        return collapse();
      case 2:
        return swap();
      case 3:
        return smooth();
      case 4:
        return destroy_face();
      case 5:
        return create_face();
      case 6:
        return reclassify();
      case 7:
        mesh_.create_vertex({double(random_(100)), double(random_(100)), double(random_(100))});
        return;
    }
  }

 private:
  template <int Dim>
  Handle<Dim> any() {
    if (mesh_.count(Dim) == 0) return {};
    return Handle<Dim>(mesh_.ids(Dim).next_alive(random_(mesh_.capacity(Dim))));
  }

  // Operators need T(0,1), T(0,2), T(2,0): requested for the one edit where the present T lacks
  // them.
  template <typename Edit>
  void with_needs(Edit&& edit) {
    const Request needs[] = {mesh_.request(0, 1), mesh_.request(0, 2), mesh_.request(2, 0)};
    edit();
  }

  void collapse() {
    const Edge e = any<1>();
    if (!e.valid() || !mesh_.alive(e)) return;
    with_needs([&] {
      const Vertex v = mesh_.edge_vertices(e)[random_(2)];
      Collapser collapser(mesh_);
      const CollapseRules rules{TurnLimit(175),
                                random_(2) ? TopologyRule::Safe : TopologyRule::Paper};
      CollapsePlan plan;
      if (collapser.judge(mesh_, e, v, rules, plan).accepted()) collapser.apply(mesh_, plan);
    });
  }

  void swap() {
    const Edge e = any<1>();
    if (!e.valid() || !mesh_.alive(e)) return;
    with_needs([&] {
      EdgePair pair;
      if (judge_swap(mesh_, e, TurnLimit(175), pair).accepted()) apply_swap(mesh_, e, pair);
    });
  }

  void smooth() {
    const Vertex v = any<0>();
    if (!v.valid() || !mesh_.alive(v)) return;
    with_needs([&] {
      glm::dvec3 target;
      if (judge_smooth(mesh_, v, TurnLimit(175), target).accepted()) apply_smooth(mesh_, v, target);
    });
  }

  void destroy_face() {
    const Face f = any<2>();
    if (f.valid() && mesh_.alive(f) && mesh_.count(2) > 3) mesh_.destroy(f);
  }

  void create_face() {
    const Vertex a = any<0>(), b = any<0>(), c = any<0>();
    if (!a.valid() || !b.valid() || !c.valid() || a == b || b == c || c == a) return;
    if (mesh_.alive(a) && mesh_.alive(b) && mesh_.alive(c)) mesh_.create_face(std::array{a, b, c});
  }

  void reclassify() {
    const Face f = any<2>();
    if (f.valid() && mesh_.alive(f))
      mesh_.set_classification(f, ModelRef(2, static_cast<int>(random_(5))));
  }

  Mesh& mesh_;
  Random random_;
};

struct Cells {
  bool t01, t02, t12, t21, only_edges;
};

Mesh with_representation(const MeshData& data, const Cells& cells) {
  Mesh mesh(data);
  mesh.set(1, 0);
  if (cells.t01) mesh.set(0, 1);
  if (cells.t02) mesh.set(0, 2);
  if (cells.t12) mesh.set(1, 2);
  if (cells.t21) mesh.set(2, 1);
  if (cells.t21 && cells.only_edges) mesh.unset(2, 0);
  return mesh;
}

/// Which relations are stored, and how often each was built or freed for somebody.
std::string stored_relations(const Mesh& mesh) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      const Representation::Record& record = mesh.representation().record(i, j);
      text += mesh.stored(i, j) ? "stored " : "- ";
      text += std::to_string(record.builds) + " " + std::to_string(record.frees) + " ";
    }
  return text;
}

std::vector<Cells> representations() {
  std::vector<Cells> all;
  for (int bits = 0; bits < 32; ++bits) {
    const Cells c{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0,
                  (bits & 16) != 0};
    if (c.t21 || !c.only_edges) all.push_back(c);
  }
  return all;  // 24 of them
}

TEST(RandomEditsTest, TheSameEditsGiveTheSameMeshUnderEveryRepresentation) {
  ASSERT_GE(representations().size(), 20u);
  for (const zoo::Animal& animal : zoo::all()) {
    std::string expected;
    for (const Cells& cells : representations()) {
      Mesh mesh = with_representation(animal.data, cells);
      mesh.keep_class_lists(true);
      Program program(mesh, 17);
      for (int i = 0; i < 300; ++i) {
        program.edit();
        if (i % 10 == 0) {
          const auto findings = verify(mesh);
          ASSERT_TRUE(findings.empty()) << animal.name << " edit " << i << ": " << findings[0].name
                                        << ": " << findings[0].text;
        }
      }
      if (expected.empty()) expected = zoo::fingerprint(mesh);
      ASSERT_EQ(zoo::fingerprint(mesh), expected) << animal.name;
    }
  }
}

TEST(RandomEditsTest, AllBackIsTheStartAndAllForwardTheEnd) {
  for (const zoo::Animal& animal : zoo::all())
    for (const Cells& cells : representations()) {
      Mesh mesh = with_representation(animal.data, cells);
      mesh.keep_class_lists(true);
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      Program program(mesh, 99);
      for (int i = 0; i < 200; ++i) program.edit();
      const std::string end = zoo::fingerprint(mesh);
      journal.seek(mesh, journal.size() / 2);
      ASSERT_TRUE(verify(mesh).empty()) << animal.name;
      journal.seek(mesh, 0);
      ASSERT_EQ(zoo::fingerprint(mesh), start) << animal.name;
      ASSERT_TRUE(verify(mesh).empty()) << animal.name;
      journal.seek(mesh, journal.size());
      ASSERT_EQ(zoo::fingerprint(mesh), end) << animal.name;
      ASSERT_TRUE(verify(mesh).empty()) << animal.name;
    }
}

// A far move builds relations anew where single steps keep them up to date.
TEST(RandomEditsTest, AFarMoveLeadsWhereSingleStepsLead) {
  for (const zoo::Animal& animal : zoo::all())
    for (const Cells& cells : representations()) {
      Mesh mesh = with_representation(animal.data, cells);
      mesh.keep_class_lists(true);
      Journal journal;
      mesh.attach(&journal);
      Program program(mesh, 31);
      for (int i = 0; i < 120; ++i) program.edit();
      const std::string stored = stored_relations(mesh);
      Random random(7);
      for (int i = 0; i < 6; ++i) {
        const std::size_t to = random(static_cast<std::uint32_t>(journal.size() + 1)),
                          from = journal.cursor();
        journal.seek(mesh, to);
        const std::string far = zoo::fingerprint(mesh);
        ASSERT_TRUE(verify(mesh).empty()) << animal.name << " to " << to;
        ASSERT_EQ(stored_relations(mesh), stored) << animal.name;
        journal.seek(mesh, from);
        while (journal.cursor() > to) journal.undo(mesh);
        while (journal.cursor() < to) journal.redo(mesh);
        ASSERT_EQ(zoo::fingerprint(mesh), far) << animal.name << " to " << to;
        ASSERT_TRUE(verify(mesh).empty()) << animal.name << " to " << to;
      }
    }
}

TEST(RandomEditsTest, AHistoryReplaysUnderAnotherRepresentation) {
  for (const zoo::Animal& animal : zoo::all()) {
    Mesh mesh = with_representation(animal.data, {true, true, true, true, true});
    Journal journal;
    mesh.attach(&journal);
    Program program(mesh, 5);
    for (int i = 0; i < 200; ++i) program.edit();
    Journal copy;
    copy.restore({journal.words().begin(), journal.words().end()},
                 {journal.steps().begin(), journal.steps().end()});
    Mesh other = with_representation(animal.data, {false, false, false, false, false});
    copy.seek(other, copy.size());
    EXPECT_EQ(zoo::fingerprint(other), zoo::fingerprint(mesh)) << animal.name;
    EXPECT_TRUE(verify(other).empty()) << animal.name;
  }
}

}  // namespace
}  // namespace aomd::random_edits_test
