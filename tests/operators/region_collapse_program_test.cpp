// Random programs of collapses among tetrahedra: every stratum keeps its Euler number and parts,
// nothing turns inside out, verify stays silent, all back is the start; the same mesh whether faces
// and edges inside are entities or not.

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/journal.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/operators/region_collapse.h"
#include "tests/support/strata.h"
#include "tests/support/tet_zoo.h"
#include "tests/support/zoo.h"

namespace aomd::region_collapse_program_test {
namespace {

using test::strata_of;
using test::wrong_with_tets;

/// What the mesh holds beside regions.
enum class Storage { Listed, Complete, Everything };

class Prepared {
 public:
  Prepared(const MeshData& data, Storage storage, const ClassifyOptions& options) : mesh_(data) {
    classify(mesh_, options);
    mesh_.keep_model_faces_only();
    mesh_.keep_model_edges_only();
    if (storage == Storage::Listed) {
      needs_.push_back(mesh_.request_listed(0, 2));
      needs_.push_back(mesh_.request_listed(0, 1));
      needs_.push_back(mesh_.request(0, 3));
    }
    for (int i = 0; i < 4 && storage != Storage::Listed; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j && (storage == Storage::Everything || i == 0)) mesh_.set(i, j);
    if (storage == Storage::Everything) mesh_.keep_class_lists(true);
  }
  Mesh& mesh() { return mesh_; }

 private:
  Mesh mesh_;
  std::vector<Request> needs_;
};

// By angles there are many model faces; without, one for each pair of materials.
const std::array<ClassifyOptions, 2> ways{ClassifyOptions{},
                                          ClassifyOptions{.feature_angle_deg = {}}};

struct Edit {
  bool accepted = false;
  Reason reason = Reason::None;
  Vertex a, b;
  friend bool operator==(const Edit&, const Edit&) = default;
};

// One random collapse of the edge at two corners of a tetrahedron: it depends on regions and
// numbers alone.
class Program {
 public:
  Program(Mesh& mesh, std::uint32_t seed) : mesh_(mesh), collapser_(mesh), random_(seed) {}

  Edit edit() {
    const Edit edit = look();
    if (edit.accepted) collapser_.apply(mesh_, plan_);
    return edit;
  }

  Edit look() {
    const std::uint32_t id = mesh_.ids(3).next_alive(random_() % mesh_.capacity(3));
    const std::uint32_t from = random_() % 4, to = (from + 1 + random_() % 3) % 4;
    const bool moves = random_() % 3 == 0, strict = random_() % 2 == 0;
    const double along = double(random_() % 100) / 100;
    if (id >= mesh_.capacity(3)) return {};
    const auto t = mesh_.tetrahedron(Region(id));
    const glm::dvec3 a = mesh_.position(t[from]), b = mesh_.position(t[to]);
    VolumeRules rules{
        .faces = {.max_turn = TurnLimit(strict ? 30 : 170), .max_curve_turn = TurnLimit(170)},
        .least_shape = strict ? 0.1 : 0.0};
    const Contraction c{t[from], t[to], moves ? a + along * (b - a) : b};
    const Verdict v = collapser_.judge(mesh_, c, rules, plan_);
    return {v.accepted(), v.reason, t[from], t[to]};
  }

 private:
  Mesh& mesh_;
  RegionCollapser collapser_;
  VolumeCollapsePlan plan_;
  std::mt19937 random_;
};

std::string findings(const Mesh& mesh) {
  const auto all = verify(mesh);
  return all.empty() ? "" : all[0].name + ": " + all[0].text;
}

// Regions and model faces with their ids and the order of their corners, model edges, vertices.
std::string on_model(const Mesh& mesh) {
  std::string s;
  const auto add = [&](auto x) { s += std::to_string(x) + ' '; };
  const auto add_entity = [&](EntityRef e) {
    VertexBuffer buffer;
    add(e.index), add(mesh.classification(e).bits());
    for (const std::uint32_t v : mesh.vertices_of(e, buffer)) add(v);
  };
  for (const Region r : mesh.regions()) add_entity(r);
  for (const Face f : mesh.faces())
    if (mesh.classification(f).dimension() <= 2) add_entity(f);
  std::set<std::array<std::uint32_t, 3>> edges;
  for (const Edge e : mesh.edges()) {
    const auto ends = mesh.edge_vertices(e);
    const auto [a, b] = std::minmax(ends[0].index, ends[1].index);
    if (mesh.classification(e).dimension() <= 1)
      edges.insert({a, b, mesh.classification(e).bits()});
  }
  for (const auto& e : edges) add(e[0]), add(e[1]), add(e[2]);
  for (const Vertex v : mesh.vertices()) {
    add_entity(v);
    for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(mesh.position(v)[k]));
  }
  return s;
}

// With sanitizers, which make it 20 times slower, half of the programs, and each an eighth as long.
#ifdef __SANITIZE_ADDRESS__
constexpr std::uint32_t programs = 2;
constexpr int edits_each = 90, least_accepted = 3;
#else
constexpr std::uint32_t programs = 4;
constexpr int edits_each = 700, least_accepted = 15;
#endif

TEST(RegionCollapseProgramTest, KeepsEveryStratum) {
  for (const zoo::TetAnimal& animal : zoo::tets()) {
    int accepted = 0;
    for (std::uint32_t seed = 0; seed < programs; ++seed) {
      Prepared prepared(animal.data, Storage::Listed, ways[seed % 2]);
      Mesh& mesh = prepared.mesh();
      ASSERT_EQ(wrong_with_tets(mesh), "") << animal.name;
      std::string strata = strata_of(mesh);
      Program program(mesh, seed);
      for (int i = 0; i < edits_each; ++i) {
        const Edit edit = program.edit();
        if (!edit.accepted) continue;
        ++accepted;
        const std::string where = animal.name + " seed " + std::to_string(seed) + " edit " +
                                  std::to_string(i) + ": " + std::to_string(edit.a.index) +
                                  " into " + std::to_string(edit.b.index);
        ASSERT_EQ(strata_of(mesh), strata) << where;
        ASSERT_EQ(wrong_with_tets(mesh), "") << where;
        ASSERT_EQ(findings(mesh), "") << where;
      }
    }
    EXPECT_GT(2 * accepted, least_accepted * int(programs)) << animal.name;
  }
}

// The simplices that a complex has around some of its vertices, without these.
std::set<test::Corners> link(const std::vector<test::Corners>& all, const test::Corners& of) {
  std::set<test::Corners> found;
  for (const test::Corners& top : all) {
    test::Corners rest;
    std::set_difference(top.begin(), top.end(), of.begin(), of.end(), std::back_inserter(rest));
    if (rest.size() + of.size() != top.size()) continue;
    for (unsigned some = 1; some < 1u << rest.size(); ++some) {
      test::Corners side;
      for (std::size_t k = 0; k < rest.size(); ++k)
        if (some >> k & 1u) side.push_back(rest[k]);
      found.insert(side);
    }
  }
  return found;
}

bool links_meet_in_that_of_the_edge(const Mesh& mesh, int dim, Vertex a, Vertex b) {
  std::vector<test::Corners> all;
  VertexBuffer buffer;
  for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id) {
    if (!mesh.alive(EntityRef(dim, id))) continue;
    const auto v = mesh.vertices_of(EntityRef(dim, id), buffer);
    all.emplace_back(v.begin(), v.end());
    std::sort(all.back().begin(), all.back().end());
  }
  const auto [low, high] = std::minmax(a.index, b.index);
  const auto of_a = link(all, {a.index}), of_b = link(all, {b.index});
  std::set<test::Corners> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                        std::inserter(common, common.end()));
  return common == link(all, {low, high});
}

// Inside a region the judgement on topology is the link condition, no more and no less; on model
// faces and edges it is that in their union too, at least.
TEST(RegionCollapseProgramTest, TopologyIsTheLinkCondition) {
  int refused_inside = 0, refused_on_faces = 0, refused_on_edges = 0;
  for (const zoo::TetAnimal& animal : zoo::tets()) {
    Prepared prepared(animal.data, Storage::Listed, ways[1]);
    Program program(prepared.mesh(), 3);
    for (int i = 0; i < 700; ++i) {
      const Edit edit = program.look();
      if (!edit.a.valid() || edit.reason == Reason::Classification) continue;
      const int on = prepared.mesh().classification(edit.a).dimension();
      const auto fits = [&](int dim) {
        return links_meet_in_that_of_the_edge(prepared.mesh(), dim, edit.a, edit.b);
      };
      const bool refused = edit.reason == Reason::Topology;
      if (on == 3) {
        ASSERT_EQ(refused, !fits(3)) << animal.name << " edit " << i;
      }
      const bool tears = (on <= 2 && !(fits(3) && fits(2))) || (on == 1 && !fits(1));
      ASSERT_TRUE(refused || !tears) << animal.name << " edit " << i;
      refused_inside += refused && on == 3;
      refused_on_faces += refused && on == 2;
      refused_on_edges += refused && on == 1;
      program.edit();
    }
  }
  EXPECT_GT(refused_inside, 0);
  EXPECT_GT(refused_on_faces, 0);
  EXPECT_GT(refused_on_edges, 0);
}

TEST(RegionCollapseProgramTest, EntitiesInsideMakeNoDifference) {
  for (const zoo::TetAnimal& animal : zoo::tets()) {
    const ClassifyOptions& way = ways[animal.data.regions.size() % 2];
    Prepared listed(animal.data, Storage::Listed, way),
        complete(animal.data, Storage::Complete, way),
        everything(animal.data, Storage::Everything, way);
    Program first(listed.mesh(), 5), second(complete.mesh(), 5), third(everything.mesh(), 5);
    for (int i = 0; i < 600; ++i) {
      const Edit a = first.edit(), b = second.edit(), c = third.edit();
      const std::string where = animal.name + " edit " + std::to_string(i);
      ASSERT_EQ(a, b) << where;
      ASSERT_EQ(a, c) << where;
      if (!a.accepted) continue;
      ASSERT_EQ(on_model(listed.mesh()), on_model(complete.mesh())) << where;
      ASSERT_EQ(on_model(listed.mesh()), on_model(everything.mesh())) << where;
      ASSERT_EQ(findings(everything.mesh()), "") << where;
    }
    EXPECT_EQ(findings(complete.mesh()), "") << animal.name;
    EXPECT_EQ(strata_of(listed.mesh()), strata_of(everything.mesh())) << animal.name;
  }
}

TEST(RegionCollapseProgramTest, AllBackIsTheStartAndAllForwardTheEnd) {
  for (const zoo::TetAnimal& animal : zoo::tets())
    for (const Storage storage : {Storage::Listed, Storage::Everything}) {
      Prepared prepared(animal.data, storage, ways[1]);
      Mesh& mesh = prepared.mesh();
      const std::string start = zoo::fingerprint(mesh);
      Journal journal;
      mesh.attach(&journal);
      Program program(mesh, 7);
      std::size_t edits = 0;
      for (int i = 0; i < 400; ++i) edits += program.edit().accepted;
      EXPECT_EQ(journal.size(), edits) << "one step each";
      const std::string end = zoo::fingerprint(mesh);
      while (journal.cursor() > 0) journal.undo(mesh);
      ASSERT_EQ(zoo::fingerprint(mesh), start) << animal.name;
      ASSERT_EQ(findings(mesh), "") << animal.name;
      journal.seek(mesh, journal.size());
      ASSERT_EQ(zoo::fingerprint(mesh), end) << animal.name;
      ASSERT_EQ(findings(mesh), "") << animal.name;
      journal.seek(mesh, journal.size() / 2);
      ASSERT_EQ(findings(mesh), "") << animal.name;
      mesh.attach(nullptr);
    }
}

}  // namespace
}  // namespace aomd::region_collapse_program_test
