// Rows of any length against sorted sets, under random insertion and erasure from all sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "core/mesh/relation.h"
#include "core/mesh/verify.h"

namespace aomd::long_rows_test {
namespace {

using Sets = std::vector<std::set<std::uint32_t>>;

UpRows rows_of(const Sets& sets) {
  UpRows rows;
  std::vector<std::uint32_t> places;
  for (const auto& set : sets) places.push_back(static_cast<std::uint32_t>(set.size()));
  std::uint32_t* pool = rows.allocate(places);
  for (std::size_t i = 0; i < sets.size(); ++i)
    std::copy(sets[i].begin(), sets[i].end(), pool + places[i]);
  return rows;
}

void expect_equal(const UpRows& rows, const Sets& sets) {
  for (std::uint32_t i = 0; i < sets.size(); ++i) {
    const auto row = rows.row(i);
    ASSERT_EQ(std::vector(row.begin(), row.end()), std::vector(sets[i].begin(), sets[i].end()))
        << i;
  }
}

Sets random_sets(std::mt19937& random) {
  Sets sets(12);
  for (auto& set : sets)
    for (std::uint32_t n = std::uniform_int_distribution<>(0, 1)(random) ? 10 : 1600; n > 0; --n)
      set.insert(random() % 4000);
  return sets;
}

TEST(LongRowsTest, AreWhatSetsAreUnderRandomEdits) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    Sets sets = random_sets(random);
    UpRows rows = rows_of(sets);
    for (int edit = 0; edit < 20000; ++edit) {
      const std::uint32_t i = random() % sets.size(), value = random() % 4000;
      const bool grow = (edit / 4000 + i) % 2 == 0;
      if (grow && sets[i].insert(value).second) rows.insert(i, value);
      ASSERT_TRUE(grow || rows.erase(i, value) == (sets[i].erase(value) == 1));
    }
    ASSERT_NO_FATAL_FAILURE(expect_equal(rows, sets));
  }
}

// What erasing from the begin gives up before a row is used again once the row grows.
TEST(LongRowsTest, FromEitherEndToNothingAndBack) {
  for (const bool ascending : {true, false}) {
    Sets sets(2);
    for (std::uint32_t n = 0; n < 3000; ++n) sets[0].insert(n), sets[1].insert(2 * n);
    UpRows rows = rows_of(sets);
    while (sets[0].size() > 1) {
      const std::uint32_t value = ascending ? *sets[0].begin() : *sets[0].rbegin();
      sets[0].erase(value);
      ASSERT_TRUE(rows.erase(0, value));
      ASSERT_FALSE(rows.erase(0, value));
    }
    for (std::uint32_t n = 0; n < 5000; ++n)
      if (sets[0].insert(n).second) rows.insert(0, n);
    expect_equal(rows, sets);
  }
}

// Both those that a row leaves as it grows and those of rows that go.
TEST(LongRowsTest, BlocksAreUsedAgain) {
  UpRows rows;
  rows.allocate({});
  std::size_t bytes = 0;
  for (int round = 0; round < 100; ++round) {
    rows.resize(3);
    for (std::uint32_t n = 0; n < 3000; ++n) rows.insert(n % 3, n);
    rows.resize(0);
    if (round == 0) bytes = rows.bytes();
    EXPECT_EQ(rows.bytes(), bytes) << round;
  }
}

// Rows close up only where much lies idle: before, a row that comes and goes has its block again.
TEST(LongRowsTest, ARowThatComesAndGoesNeedsNoMoreRoom) {
  for (const bool erased : {true, false}) {
    Sets sets(100);
    for (auto& set : sets)
      for (std::uint32_t n = 0; n < 60; ++n) set.insert(n);
    UpRows rows = rows_of(sets);
    std::size_t bytes = 0;
    for (int round = 0; round < 60; ++round) {
      rows.resize(101);
      for (std::uint32_t n = 0; n < 20; ++n) rows.insert(100, n);
      for (std::uint32_t n = 0; erased && n < 20; ++n) ASSERT_TRUE(rows.erase(100, n));
      if (!erased) rows.resize(100);
      if (round == 0) bytes = rows.bytes();
    }
    EXPECT_EQ(rows.bytes(), bytes) << erased;
  }
}

// Half of the rows go, one value after the other, and the others take these in: as in collapses.
// Blocks of the size that is needed are never left behind, so the rows must close up.
TEST(LongRowsTest, RowsThatTakeOthersInNeedNoMoreRoom) {
  for (const std::uint32_t size : {22u, 700u}) {
    Sets sets(22000 / size);
    for (std::uint32_t i = 0; i < sets.size(); ++i)
      for (std::uint32_t n = 0; n < size; ++n) sets[i].insert(i * size + n);
    UpRows rows = rows_of(sets);
    const std::size_t bytes = rows.bytes();
    for (std::size_t step = 1; step < sets.size(); step *= 2)
      for (std::size_t i = step; i < sets.size(); i += 2 * step)
        for (const std::uint32_t value : std::exchange(sets[i], {})) {
          ASSERT_TRUE(rows.erase(static_cast<std::uint32_t>(i), value));
          if (value % 2 == 0) continue;
          sets[i - step].insert(value);
          rows.insert(static_cast<std::uint32_t>(i - step), value);
        }
    expect_equal(rows, sets);
    EXPECT_LE(rows.bytes(), bytes * 4 / 3) << size;
  }
}

// A hub, vertex 0, with `rim` faces around it, in an order that chance gave; edge (0, 3) listed
// twice.
MeshData hub(std::uint32_t rim) {
  MeshData data;
  data.positions.resize(rim + 1, {0, 0, 0});
  std::vector<std::uint32_t> order(rim);
  std::iota(order.begin(), order.end(), 1u);
  for (const std::uint32_t v : order) data.positions[v] = {std::cos(v), std::sin(v), 0};
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  for (const std::uint32_t v : order) data.faces.add(Shape::Triangle, {0, v, v % rim + 1});
  for (const std::uint32_t v : order) data.edges.add(Shape::Line, {v, 0}, ModelRef(1, 7));
  data.edges.add(Shape::Line, {3, 0}, ModelRef(1, 8));
  return data;
}

// Sides at a vertex of few faces are found by looking at all, at one of many by halves. Of an edge
// that is listed twice the last class counts.
TEST(LongRowsTest, SidesAtAHubAreFound) {
  for (const std::uint32_t rim : {20u, 250u, 256u, 257u, 3000u}) {
    Mesh mesh(hub(rim));
    mesh.set(2, 1);
    EXPECT_EQ(mesh.count(1), 2 * rim);
    EXPECT_TRUE(verify(mesh).empty()) << rim;
    EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(3))), ModelRef(1, 8)) << rim;
    EXPECT_EQ(mesh.classification(mesh.find_edge(Vertex(0), Vertex(4))), ModelRef(1, 7)) << rim;
  }
}

}  // namespace
}  // namespace aomd::long_rows_test
