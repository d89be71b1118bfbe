// A surface made coarser in blocks is the same surface: its topology, its place, and what the
// decimation knows of the original.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <cmath>
#include <mutex>
#include <thread>

#include "core/base/box.h"
#include "core/blocks/coarse_surface.h"
#include "core/decimate/decimation.h"
#include "core/io/io.h"
#include "core/measure/distance.h"
#include "core/mesh/geometry.h"
#include "core/model/triangle_tree.h"
#include "tests/support/io_helpers.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/surface_facts.h"

namespace aomd::coarse_surface_test {
namespace {

using Triangle = std::array<std::array<double, 3>, 3>;

BlockRules rules(std::uint32_t target, int threads = 1) {
  BlockRules rules;
  rules.decimation = test::quality(target);
  rules.decimation.threads = threads;
  rules.target = [target](std::uint32_t) { return target; };
  return rules;
}

class Blocks : public testing::Test {
 protected:
  CoarseSurface coarse(const MeshData& mesh, std::size_t blocks, const BlockRules& how) const {
    NoExchange alone;
    return *coarsen_in_blocks(file_of(mesh), blocks, how, alone, [](double) {});
  }

  std::filesystem::path file_of(const MeshData& mesh) const {
    io::write(folder_ / "a.ply", mesh);
    return folder_ / "a.ply";
  }

  test::TemporaryFolder folder_;
};

/// The faces by the places of their corners, each from its least corner on.
std::vector<Triangle> places_of(const MeshData& mesh) {
  std::vector<Triangle> all;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& p = mesh.positions[mesh.faces.vertices[3 * f + k]];
      t[k] = {p.x, p.y, p.z};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}

double area_of(const MeshData& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto* t = &mesh.faces.vertices[3 * f];
    const auto& p = mesh.positions;
    area += glm::length(area_normal(p[t[0]], p[t[1]], p[t[2]])) / 2;
  }
  return area;
}

bool same(const OriginalSample& a, const OriginalSample& b) {
  return a.position == b.position && a.normal == b.normal && a.weight == b.weight &&
         a.face == b.face;
}

void expect_same(const CoarseSurface& a, const CoarseSurface& b) {
  EXPECT_TRUE(a.mesh == b.mesh);
  EXPECT_TRUE(
      std::equal(a.samples->begin(), a.samples->end(), b.samples->begin(), b.samples->end(), same));
}

// Blocks that have nothing to do fit together again.
TEST_F(Blocks, GoThroughWithoutChangeWhereTheTargetIsFarAbove) {
  for (const auto& animal : test::samples({{"torus", 40}, {"terrain", 30}, {"nonmanifold", 20}}))
    for (const std::size_t blocks : {1u, 2u, 7u, 40u}) {
      const CoarseSurface result = coarse(animal.data, blocks, rules(1'000'000));
      EXPECT_EQ(places_of(result.mesh), places_of(animal.data)) << animal.name << ' ' << blocks;
      EXPECT_EQ(result.faces, animal.data.faces.size());
      EXPECT_EQ(result.vertices, animal.data.positions.size());
    }
}

/// A mesh with a colour, the place as a vector, and a label on faces.
MeshData with_arrays(MeshData mesh) {
  Attribute red{.name = "red", .integer = true, .values = {}, .type = NumberType::UInt8};
  Attribute x{.name = "x2", .values = {}},
      label{.name = "label", .dimension = 2, .integer = true, .values = {}};
  for (const glm::dvec3& p : mesh.positions) {
    red.values.push_back(double(red.values.size() % 251));
    x.values.push_back(2 * p.x);
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) label.values.push_back(double(f / 100));
  mesh.attributes = {red, x, label};
  return mesh;
}

/// Values by the places that have them.
std::vector<std::vector<double>> values_by_place(const MeshData& mesh) {
  std::vector<std::vector<double>> all;
  for (const Attribute& a : mesh.attributes)
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      glm::dvec3 p(0.0);
      if (a.dimension == 0) p = mesh.positions[i];
      for (std::size_t k = 0; a.dimension == 2 && k < 3; ++k)
        p += mesh.positions[mesh.faces.vertices[3 * i + k]];
      all.push_back({double(a.dimension), p.x, p.y, p.z, a.values[i]});
    }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_F(Blocks, ArraysGoAlong) {
  const MeshData mesh = with_arrays(make_sample("torus", 80));
  const TriangleTree original(triangles_of(Mesh(mesh)).corners);
  for (const std::size_t blocks : {1u, 2u, 7u}) {
    const CoarseSurface same = coarse(mesh, blocks, rules(1'000'000));
    ASSERT_EQ(same.mesh.attributes.size(), 3u);
    EXPECT_EQ(values_by_place(same.mesh), values_by_place(mesh)) << blocks;
    const CoarseSurface result = coarse(mesh, blocks, rules(800));
    ASSERT_EQ(result.mesh.attributes.size(), 3u);
    for (const Attribute& a : result.mesh.attributes) {
      ASSERT_EQ(a.values.size(),
                a.dimension == 0 ? result.mesh.positions.size() : result.mesh.faces.size());
      for (std::size_t v = 0; a.name == "x2" && v < a.values.size(); ++v)
        EXPECT_NEAR(a.values[v], 2 * original.nearest(result.mesh.positions[v]).point.x, 1e-6)
            << blocks;
    }
  }
}

// Blocks that touch nowhere have no strip between them that could tell what arrays there are.
TEST_F(Blocks, ArraysGoAlongWhereBlocksDoNotTouch) {
  MeshData two = make_sample("sphere", 12);
  const auto n = static_cast<std::uint32_t>(two.positions.size());
  const std::size_t corners = two.faces.vertices.size();
  for (std::uint32_t v = 0; v < n; ++v) two.positions.push_back(two.positions[v] + 100.0);
  for (std::size_t i = 0; i < corners; ++i) two.faces.vertices.push_back(two.faces.vertices[i] + n);
  two.faces.shapes.resize(2 * two.faces.shapes.size(), Shape::Triangle);
  const MeshData mesh = with_arrays(two);
  EXPECT_EQ(values_by_place(coarse(mesh, 2, rules(1'000'000)).mesh), values_by_place(mesh));
}

// In blocks of a few faces each, where the seams run close to each other, too.
TEST_F(Blocks, KeepTheTopology) {
  for (const auto& animal : test::samples(
           {{"scan", 6000}, {"torus", 60}, {"terrain", 40}, {"nonmanifold", 30}, {"bracket", 5}}))
    for (const std::size_t blocks : {2u, 5u, 16u, 150u}) {
      const auto before = test::facts_of(animal.data);
      const CoarseSurface result = coarse(animal.data, blocks, rules(100));
      const auto after = test::facts_of(result.mesh);
      if (blocks < 100) {
        EXPECT_LT(result.mesh.faces.size(), animal.data.faces.size());
      }
      EXPECT_EQ(after.euler, before.euler) << animal.name << ' ' << blocks;
      EXPECT_EQ(after.misoriented, before.misoriented) << animal.name << ' ' << blocks;
      EXPECT_EQ(after.nonmanifold > 0, before.nonmanifold > 0) << animal.name << ' ' << blocks;
      EXPECT_EQ(test::finding(test::classified(result.mesh)), "") << animal.name << ' ' << blocks;
    }
}

// The points stand for all of the area, near the faces that are named with them.
TEST_F(Blocks, PointsStandForTheOriginal) {
  const MeshData mesh = make_sample("scan", 20'000);
  Box box;
  for (const glm::dvec3& p : mesh.positions) box.add(p);
  for (const std::uint32_t target : {50u, 2000u}) {  // thinned out, and all
    const CoarseSurface result = coarse(mesh, 6, rules(target));
    double weights = 0;
    for (const OriginalSample& s : *result.samples) {
      weights += double(s.weight);
      ASSERT_LT(s.face.index, result.mesh.faces.size());
      const auto* t = &result.mesh.faces.vertices[3 * std::size_t{s.face.index}];
      const auto& p = result.mesh.positions;
      EXPECT_LT(glm::distance(s.position, nearest_point({p[t[0]], p[t[1]], p[t[2]]}, s.position)),
                (target == 50 ? 0.1 : 0.005) * box.diagonal());
    }
    EXPECT_NEAR(weights, area_of(mesh), target == 50 ? 0.02 * weights : 1e-5 * weights);
    EXPECT_EQ(result.samples->size() > mesh.positions.size(), target == 2000) << target;
  }
}

double rms_after(const MeshData& start, std::shared_ptr<const OriginalSamples> samples,
                 const MeshData& original, std::uint32_t target) {
  Mesh mesh = test::classified(start, test::Edges::OnModelEdges);
  DecimationOptions options = test::quality(target);
  options.original = std::move(samples);
  Decimation(mesh, options).run();
  EXPECT_EQ(mesh.count(2), target);
  const Mesh first(original);
  const measure::Surface reference(first), result(mesh);
  return measure::mutual_distance(reference, result, 100'000).rms();
}

// As close as in one piece, since what was forgotten would cost a third.
TEST_F(Blocks, AreAsCloseAsOnePiece) {
  const MeshData mesh = make_sample("scan", 30'000);
  const double one = rms_after(mesh, nullptr, mesh, 1500);
  const CoarseSurface in_blocks = coarse(mesh, 6, rules(1500));
  EXPECT_LT(rms_after(in_blocks.mesh, in_blocks.samples, mesh, 1500), 1.03 * one);
  EXPECT_GT(rms_after(in_blocks.mesh, nullptr, mesh, 1500), 1.1 * one);
}

// As many bytes as what a decimation makes of them.
TEST_F(Blocks, PointsAreLetGoOnceTheyAreCopied) {
  const CoarseSurface in_blocks = coarse(make_sample("scan", 3'000), 2, rules(150));
  auto samples = std::make_shared<const OriginalSamples>(*in_blocks.samples);
  const std::weak_ptr<const OriginalSamples> given = samples;
  Mesh mesh = test::classified(in_blocks.mesh, test::Edges::OnModelEdges);
  DecimationOptions options = test::quality(150);
  options.original = std::move(samples);
  Decimation decimation(mesh, std::move(options));
  EXPECT_TRUE(given.expired());
  decimation.run();
  decimation.set_options(decimation.options());
  EXPECT_EQ(decimation.phase(), Phase::Done);
  EXPECT_EQ(mesh.count(2), 150u);
}

TEST_F(Blocks, SameResultForAnyNumberOfThreads) {
  const MeshData mesh = make_sample("scan", 12'000);
  const CoarseSurface one = coarse(mesh, 4, rules(500, 1));
  for (const int threads : {2, 3, 8}) expect_same(coarse(mesh, 4, rules(500, threads)), one);
}

/// What processes hand over, between threads of a test.
struct Meeting {
  explicit Meeting(std::size_t count) : bytes(count), all(static_cast<std::ptrdiff_t>(count)) {}
  std::vector<std::string> bytes;
  bool told = false;
  std::barrier<> all;
};

class ThreadExchange final : public Exchange {
 public:
  ThreadExchange(Meeting& meeting, std::size_t rank) : meeting_(meeting), rank_(rank) {}
  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::size_t ranks() const override { return meeting_.bytes.size(); }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) override {
    meeting_.bytes[rank_] = std::move(bytes);
    meeting_.all.arrive_and_wait();
    std::vector<std::string> all;
    if (rank_ == 0) all = meeting_.bytes;
    meeting_.all.arrive_and_wait();
    return all;
  }
  [[nodiscard]] bool told(bool by_first) override {
    if (rank_ == 0) meeting_.told = by_first;
    meeting_.all.arrive_and_wait();
    const bool said = meeting_.told;
    meeting_.all.arrive_and_wait();
    return said;
  }

 private:
  Meeting& meeting_;
  std::size_t rank_;
};

/// Calls work(exchange) as so many processes would.
template <typename Work>
void as_processes(std::size_t count, const Work& work) {
  Meeting meeting(count);
  std::vector<std::thread> processes;
  for (std::size_t rank = 0; rank < count; ++rank)
    processes.emplace_back([&, rank] {
      ThreadExchange exchange(meeting, rank);
      work(exchange);
    });
  for (std::thread& p : processes) p.join();
}

TEST_F(Blocks, SameResultForAnyNumberOfProcesses) {
  const MeshData mesh = with_arrays(make_sample("scan", 12'000));
  const auto path = file_of(mesh);
  const CoarseSurface alone = coarse(mesh, 5, rules(500));
  for (const std::size_t count : {2u, 3u, 7u})
    as_processes(count, [&](Exchange& exchange) {
      const auto result = coarsen_in_blocks(path, 5, rules(500), exchange, [](double) {});
      EXPECT_EQ(result.has_value(), exchange.rank() == 0);
      if (result) expect_same(*result, alone);
    });
}

// Whoever fails, the first one says so, and nobody waits for ever.
TEST_F(Blocks, TheFirstProcessSaysWhatAnotherCouldNotDo) {
  const auto path = file_of(make_sample("torus", 20));
  as_processes(3, [&](Exchange& exchange) {
    const auto own = exchange.rank() == 2 ? folder_ / "missing.ply" : path;
    const auto run = [&] { return coarsen_in_blocks(own, 1, rules(500), exchange, [](double) {}); };
    if (exchange.rank() != 0) {
      EXPECT_FALSE(run().has_value());
      return;
    }
    try {
      run();
      ADD_FAILURE() << "nobody complained";
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find("process 2: "), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("missing.ply: is no file"), std::string::npos);
    }
  });
}

}  // namespace
}  // namespace aomd::coarse_surface_test
