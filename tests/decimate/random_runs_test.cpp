// Decimation of whatever a file may hold, with whatever options it may be given: the database stays
// consistent, what `safe` promises holds, and the history leads back and forth to the same bits.
// AOMD_FUZZ_ROUNDS in the environment asks for more rounds than the usual 400, AOMD_FUZZ_SEED for
// others: the first of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <sstream>
#include <utility>

#include <glm/geometric.hpp>

#include "core/decimate/decimation.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "tests/support/random_classes.h"
#include "tests/support/zoo.h"

namespace aomd::random_runs_test {
namespace {

unsigned from_environment(const char* name, unsigned usual) {
  const char* wanted = std::getenv(name);
  return wanted ? static_cast<unsigned>(std::atoi(wanted)) : usual;
}

// One drawn mesh, drawn options, and how they are to be printed where something fails.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  MeshData surface() {
    std::vector<zoo::Animal> animals = zoo::all();
    animals.push_back({"fine torus", zoo::torus(20, 14)});
    const zoo::Animal& animal = animals[pick(animals.size())];
    text_ << animal.name;
    MeshData data = animal.data;
    if (chance(2)) add_dirt(data);
    if (chance(2)) return data;
    text_ << ", classified";
    return test::with_random_classes(std::move(data), static_cast<unsigned>(random_()));
  }

  DecimationOptions options(const Mesh& mesh) {
    DecimationOptions o;
    o.strategy = chance(2) ? Strategy::Paper : Strategy::Quality;
    o.coarsest = chance(4);
    o.factor = 1 + static_cast<double>(pick(80)) / 10;
    o.angle_deg = 5 + static_cast<double>(pick(170));
    if (chance(2)) o.target_faces = 1 + static_cast<std::uint32_t>(pick(mesh.count(2) + 10));
    if (chance(3)) o.min_angle_deg = static_cast<double>(pick(40));
    if (chance(4)) o.max_distance = static_cast<double>(1 + pick(100)) / 200;
    o.no_intersections = chance(4);
    o.regularity = static_cast<double>(pick(5)) / 4;
    if (chance(4)) o.without = static_cast<std::uint32_t>(pick(64));
    if (chance(3)) o.topology = TopologyRule::Paper;
    o.improve_passes = static_cast<int>(pick(6));
    o.exchange = o.strategy == Strategy::Paper && chance(4);
    o.swap = !chance(5);
    o.smooth = !chance(5);
    if (chance(5)) o.keep = kept(mesh);
    if (chance(5)) o.spacing = spacing(mesh);
    text_ << ", strategy " << static_cast<int>(o.strategy) << ", topology "
          << static_cast<int>(o.topology) << ", factor " << o.factor << ", angle " << o.angle_deg
          << ", target " << o.target_faces << ", max distance " << o.max_distance
          << (o.coarsest ? ", coarsest" : "") << (o.exchange ? ", exchange" : "")
          << (o.no_intersections ? ", no intersections" : "");
    return o;
  }

  bool chance(std::size_t one_in) { return pick(one_in) == 0; }
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::size_t pick(std::size_t n) { return random_() % n; }

  // Repeated and turned faces, coincident vertices, faces without area, wings, far vertices.
  void add_dirt(MeshData& data) {
    for (std::size_t times = 1 + pick(8); times-- > 0;) {
      const std::size_t face = pick(data.faces.size());
      std::uint32_t* v = &data.faces.vertices[3 * face];
      const std::uint32_t a = v[0], b = v[1], c = v[2];
      const auto any = static_cast<std::uint32_t>(pick(data.positions.size()));
      switch (pick(6)) {
        case 0:
          data.faces.add(Shape::Triangle, {a, b, c});
          break;
        case 1:
          std::swap(v[0], v[1]);
          break;
        case 2:
          data.positions[a] = data.positions[b];
          break;
        case 3:
          data.positions[a] = 0.5 * (data.positions[b] + data.positions[c]);
          break;
        case 4:
          if (any != a && any != b) data.faces.add(Shape::Triangle, {a, b, any});
          break;
        default:
          if (glm::length(data.positions[any]) < 1e9) data.positions[any] *= 1e6;
      }
    }
    text_ << ", dirty";
  }

  std::shared_ptr<Column<Vertex, std::uint8_t>> kept(const Mesh& mesh) {
    auto column = std::make_shared<Column<Vertex, std::uint8_t>>(mesh.capacity(0));
    for (const Vertex v : mesh.vertices()) (*column)[v] = chance(3);
    return column;
  }

  std::shared_ptr<Column<Vertex, double>> spacing(const Mesh& mesh) {
    auto column = std::make_shared<Column<Vertex, double>>(mesh.capacity(0));
    for (const Vertex v : mesh.vertices()) (*column)[v] = static_cast<double>(pick(40)) / 10;
    return column;
  }

  std::mt19937 random_;
  std::ostringstream text_;
};

// Vertices whose faces do not form one fan: what `safe` must not add to.
std::size_t split_vertices(Mesh& mesh) {
  const Request edges_of = mesh.request(0, 1), faces_of = mesh.request(1, 2);
  const Request around = mesh.request(0, 2);
  std::size_t split = 0;
  for (const Vertex v : mesh.vertices()) {
    std::vector<Face> todo, seen;
    if (mesh.row<2>(v).empty()) continue;
    todo.push_back(mesh.row<2>(v)[0]);
    while (!todo.empty()) {
      const Face f = todo.back();
      todo.pop_back();
      if (std::find(seen.begin(), seen.end(), f) != seen.end()) continue;
      seen.push_back(f);
      for (const Edge e : mesh.row<1>(v))
        if (const Row<2> faces = mesh.row<2>(e);
            std::find(faces.begin(), faces.end(), f) != faces.end())
          todo.insert(todo.end(), faces.begin(), faces.end());
    }
    split += seen.size() != mesh.row<2>(v).size();
  }
  return split;
}

TEST(RandomRunsTest, WhateverIsDecimatedStaysConsistentAndLeadsBack) {
  const unsigned first = from_environment("AOMD_FUZZ_SEED", 0);
  for (unsigned seed = first; seed < first + from_environment("AOMD_FUZZ_ROUNDS", 400); ++seed) {
    Draw draw(seed);
    Mesh mesh(draw.surface());
    classify(mesh, {.nonmanifold_edges = !draw.chance(4)});
    const bool snapped = draw.chance(6);
    const DiscreteModel model(mesh);
    DecimationOptions options = draw.options(mesh);
    if (snapped) options.model = &model;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + draw.text());
    const int euler = zoo::euler(mesh);
    const std::size_t split = split_vertices(mesh);
    mesh.set(1, 0);
    const std::string start = zoo::fingerprint(mesh);
    Journal journal;
    mesh.attach(&journal);
    {
      Decimation decimation(mesh, options);
      decimation.run();
    }
    const auto findings = verify(mesh);
    ASSERT_TRUE(findings.empty()) << findings.front().text;
    if (options.topology == TopologyRule::Safe) {
      ASSERT_EQ(zoo::euler(mesh), euler);
      ASSERT_LE(split_vertices(mesh), split);
    }
    const std::string end = zoo::fingerprint(mesh);
    journal.seek(mesh, 0);
    ASSERT_EQ(zoo::fingerprint(mesh), start);
    journal.seek(mesh, journal.size());
    ASSERT_EQ(zoo::fingerprint(mesh), end);
  }
}

}  // namespace
}  // namespace aomd::random_runs_test
