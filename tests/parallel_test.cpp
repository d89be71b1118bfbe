// Loops on several threads, and colours of vertices.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/decimate/colouring.h"
#include "core/mesh/column.h"
#include "core/mesh/parallel.h"
#include "core/samples/samples.h"
#include "zoo.h"

namespace aomd {
namespace {

TEST(ParallelForTest, EveryItemHasItsTurnOnce) {
  for (const int threads : {-1, 0, 1, 2, 3, 7})
    for (const std::size_t count : {0u, 1u, 2u, 99u, 1000u}) {
      std::vector<int> seen(count, 0);
      parallel_for(count, threads, 10, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++seen.at(i);
      });
      EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count)) << threads;
    }
}

TEST(ParallelForTest, PiecesHaveTheGrainAtLeast) {
  std::atomic<int> pieces = 0;
  parallel_for(1000, 4, 100, [&](std::size_t begin, std::size_t end) {
    EXPECT_GE(end - begin, 100u);
    ++pieces;
  });
  EXPECT_EQ(pieces, 10);
}

TEST(ParallelForTest, FewItemsStayWithTheCaller) {
  const auto caller = std::this_thread::get_id();
  parallel_for(199, 4, 100, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(begin, 0u);
    EXPECT_EQ(end, 199u);
  });
}

TEST(ParallelForTest, ExceptionsComeBackToTheCaller) {
  for (const int threads : {1, 2, 5})
    for (const std::size_t bad : {0u, 500u, 999u})
      EXPECT_THROW(parallel_for(1000, threads, 10,
                                [&](std::size_t begin, std::size_t end) {
                                  if (begin <= bad && bad < end) throw std::runtime_error("here");
                                }),
                   std::runtime_error)
          << threads << ' ' << bad;
}

TEST(ParallelForTest, AtLeastOneThread) {
  EXPECT_GE(thread_count(0), 1);
  EXPECT_EQ(thread_count(-3), thread_count(0));
  EXPECT_EQ(thread_count(5), 5);
}

TEST(EachAliveTest, SkipsTheDeadAndStopsAtTheEnd) {
  IdPool ids;
  ids.create_many(200);
  for (const std::uint32_t id : {0u, 63u, 64u, 150u, 199u}) ids.destroy(id);
  const auto visited = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> all;
    each_alive(ids, begin, end, [&](std::uint32_t id) { all.push_back(id); });
    return all;
  };
  EXPECT_EQ(visited(62, 66), (std::vector<std::uint32_t>{62, 65}));
  EXPECT_EQ(visited(149, 151), (std::vector<std::uint32_t>{149}));
  EXPECT_EQ(visited(0, 1), (std::vector<std::uint32_t>{}));
  EXPECT_EQ(visited(197, 5000), (std::vector<std::uint32_t>{197, 198}));
  EXPECT_EQ(visited(300, 400), (std::vector<std::uint32_t>{}));
}

//  3--2     0, 1 and 2 touch each other; 3 touches 0 and 2
//  | /|
//  |/ |
//  0--1
TEST(ColouringTest, ASquareHasThreeColours) {
  Mesh mesh(zoo::square());
  mesh.set(0, 2);
  const Colouring all(mesh, [](Vertex) { return true; });
  ASSERT_EQ(all.colours(), 3u);
  EXPECT_EQ(all.vertices(0).size(), 1u);
  ASSERT_EQ(all.vertices(1).size(), 2u);
  EXPECT_EQ(all.vertices(1)[0], Vertex(1));
  EXPECT_EQ(all.vertices(1)[1], Vertex(3));
  EXPECT_EQ(all.vertices(2)[0], Vertex(2));
  EXPECT_EQ(Colouring(mesh, [](Vertex) { return false; }).colours(), 0u);
}

// Every pair of 70 vertices is joined, so that each needs a colour of its own.
TEST(ColouringTest, AnyNumberOfColours) {
  constexpr std::uint32_t n = 70;
  std::vector<glm::dvec3> p;
  zoo::Triangles t;
  for (std::uint32_t i = 0; i < n; ++i) p.emplace_back(i, i * i, i * i * i);
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = i + 1; k + 1 < n; ++k) t.push_back({i, k, k + 1});
  Mesh mesh(zoo::make(p, t));
  mesh.set(0, 2);
  EXPECT_EQ(Colouring(mesh, [](Vertex) { return true; }).colours(), n);
}

TEST(ColouringTest, NoFaceHasAColourTwiceAndEveryWantedVertexHasOne) {
  std::vector<zoo::Animal> all = zoo::all();
  all.push_back({"scan", make_sample("scan", 3000)});
  for (const zoo::Animal& animal : all) {
    Mesh mesh(animal.data);
    mesh.set(0, 2);
    const auto wanted = [](Vertex v) { return v.index % 5 != 2; };
    const Colouring colouring(mesh, wanted);
    Column<Vertex, std::uint32_t> colour(mesh.capacity(0), no_index);
    std::size_t painted = 0, expected = 0;
    for (std::uint32_t c = 0; c < colouring.colours(); ++c) {
      EXPECT_FALSE(colouring.vertices(c).empty());
      EXPECT_TRUE(std::is_sorted(colouring.vertices(c).begin(), colouring.vertices(c).end()));
      for (const Vertex v : colouring.vertices(c)) colour[v] = c, ++painted;
    }
    for (const Vertex v : mesh.vertices()) {
      EXPECT_EQ(colour[v] != no_index, wanted(v)) << animal.name;
      expected += wanted(v);
    }
    EXPECT_EQ(painted, expected) << animal.name << ": none twice";
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.triangle(f);
      EXPECT_TRUE(colour[a] == no_index || (colour[a] != colour[b] && colour[a] != colour[c])) << animal.name;
      EXPECT_TRUE(colour[b] == no_index || colour[b] != colour[c]) << animal.name;
    }
  }
}

}  // namespace
}  // namespace aomd
