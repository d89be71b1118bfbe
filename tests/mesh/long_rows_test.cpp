// Rows of any length against sorted sets, under random insertion and erasure from all sides.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/mesh/relation.h"

namespace aomd {
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

}  // namespace
}  // namespace aomd
