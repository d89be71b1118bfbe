// Surfaces that are hardly any, drawn at random: faces repeated, turned round and fanned out over a
// few edges and vertices. Whatever the options, no operation breaks the mesh, and a safe one keeps
// its topology.

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/base/disjoint_sets.h"
#include "core/decimate/decimation.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::dirty_test {
namespace {

using test::finding;

void add_random_faces(MeshData& data, std::uint32_t count, std::mt19937& random) {
  const auto vertices = static_cast<std::uint32_t>(data.positions.size());
  while (count > 0) {
    const std::uint32_t a = random() % vertices, b = random() % vertices, c = random() % vertices;
    if (a == b || b == c || c == a) continue;
    data.faces.add(Shape::Triangle, {a, b, c}), --count;
    while (random() % 4 == 0) data.faces.add(Shape::Triangle, {b, a, c});
    if (random() % 8 == 0) data.edges.add(Shape::Line, {a, random() % 2 ? (a + 1) % vertices : b});
  }
}

// Few places for many faces, so that they repeat each other, share edges many times and meet in
// single vertices; some vertices coincide.
MeshData random_soup(std::mt19937& random) {
  const std::uint32_t vertices = 4 + random() % 12;
  std::vector<glm::dvec3> positions;
  for (std::uint32_t v = 0; v < vertices; ++v)
    positions.emplace_back(random() % 7, random() % 7, random() % 3);
  MeshData data = zoo::make(positions, {});
  add_random_faces(data, 2 + random() % (3 * vertices), random);
  return data;
}

// A bumpy sheet, or a closed surface, with a few faces too many.
MeshData random_spoilt_surface(std::mt19937& random) {
  MeshData data = random() % 2 ? zoo::grid(3 + random() % 3) : zoo::torus(5, 4);
  for (glm::dvec3& p : data.positions) p.z += 0.01 * double(random() % 20);
  add_random_faces(data, random() % 6, random);
  return data;
}

DecimationOptions random_options(std::mt19937& random) {
  DecimationOptions options;
  options.strategy = random() % 2 ? Strategy::Paper : Strategy::Quality;
  options.topology = random() % 2 ? TopologyRule::Paper : TopologyRule::Safe;
  options.coarsest = random() % 2;
  options.factor = 30;
  options.target_faces = random() % 4;
  options.angle_deg = random() % 2 ? 175 : 40;
  options.swap = random() % 2, options.smooth = random() % 2;
  options.exchange = options.strategy == Strategy::Paper && random() % 2;
  options.no_intersections = random() % 4 == 0;
  if (random() % 4 == 0) options.max_distance = 1;
  return options;
}

// Whether the faces around a vertex form one fan or ring: at no edge more than two of them, all
// connected through edges.
bool one_fan(const Mesh& mesh, Vertex v) {
  std::map<std::uint32_t, int> faces_at;  // by neighbour
  DisjointSets connected(mesh.capacity(0));
  for (const Face f : mesh.row<2>(v)) {
    std::vector<std::uint32_t> others;
    for (const Vertex u : mesh.triangle(f))
      if (u != v) others.push_back(u.index), ++faces_at[u.index];
    connected.unite(others[0], others[1]);
  }
  for (const auto& [neighbour, faces] : faces_at)
    if (faces > 2 || connected.find(neighbour) != connected.find(faces_at.begin()->first))
      return false;
  return true;
}

// The same without regard to how many faces share an edge.
bool connected_around(const Mesh& mesh, Vertex v) {
  DisjointSets connected(mesh.capacity(0));
  std::vector<std::uint32_t> neighbours;
  for (const Face f : mesh.row<2>(v)) {
    const auto t = mesh.triangle(f);
    const std::size_t k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
    connected.unite(t[(k + 1) % 3].index, t[(k + 2) % 3].index);
    neighbours.push_back(t[(k + 1) % 3].index);
  }
  return std::all_of(neighbours.begin(), neighbours.end(), [&](std::uint32_t u) {
    return connected.find(u) == connected.find(neighbours[0]);
  });
}

ClassifyOptions random_rules(std::mt19937& random) {
  ClassifyOptions how;
  if (random() % 2) how.feature_angle_deg = {};
  if (random() % 2) how.corner_angle_deg = 180;
  how.nonmanifold_edges = random() % 2;
  return how;
}

using Holds = bool (*)(const Mesh&, Vertex);

std::vector<Vertex> vertices_without(const Mesh& mesh, Holds holds) {
  std::vector<Vertex> found;
  for (const Vertex v : mesh.vertices())
    if (!holds(mesh, v)) found.push_back(v);
  return found;
}

// A vertex comes to be without only by taking in one that was.
void expect_no_more(const Mesh& mesh, const std::vector<Vertex>& before, Holds holds) {
  const auto gone =
      std::count_if(before.begin(), before.end(), [&](Vertex v) { return !mesh.alive(v); });
  std::ptrdiff_t fresh = 0;
  for (const Vertex v : vertices_without(mesh, holds))
    fresh += std::find(before.begin(), before.end(), v) == before.end();
  ASSERT_LE(fresh, gone);
}

// Runs to the end, looks after each operation and counts them.
void run(Mesh& mesh, const DecimationOptions& options, int& operations) {
  const int euler = zoo::euler(mesh);
  Decimation decimation(mesh, options);
  const Request faces = mesh.request(0, 2);
  while (true) {
    const auto no_fans = vertices_without(mesh, one_fan);
    const auto loose = vertices_without(mesh, connected_around);
    const auto made = decimation.step();
    if (!made) return;
    ++operations;
    SCOPED_TRACE(step_name(made->kind));
    ASSERT_EQ(finding(mesh), "");
    if (options.topology == TopologyRule::Paper) continue;
    ASSERT_EQ(zoo::euler(mesh), euler);
    ASSERT_NO_FATAL_FAILURE(expect_no_more(mesh, no_fans, one_fan));
    ASSERT_NO_FATAL_FAILURE(expect_no_more(mesh, loose, connected_around));
  }
}

TEST(DirtyTest, NoOperationBreaksWhatIsDrawnAtRandom) {
  int operations = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    std::mt19937 random(seed);
    const MeshData data = random() % 2 ? random_soup(random) : random_spoilt_surface(random);
    const DecimationOptions options = random_options(random);
    Mesh mesh(data);
    classify(mesh, random_rules(random));
    if (!options.exchange && random() % 2) keep_edges_for_quality(mesh);
    SCOPED_TRACE(seed);
    ASSERT_NO_FATAL_FAILURE(run(mesh, options, operations));
  }
  EXPECT_GT(operations, 1000);
}

}  // namespace
}  // namespace aomd::dirty_test
