// Loops on several threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"

namespace aomd::parallel_test {
namespace {

TEST(ParallelForTest, EveryItemHasItsTurnOnce) {
  for (const int threads : {-1, 0, 1, 2, 3, 7})
    for (const std::size_t count : {0u, 1u, 2u, 99u, 1000u}) {
      std::vector<int> seen(count, 0);
      parallel_for(count, threads, 10, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++seen.at(i);
      });
      EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count))
          << threads;
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

}  // namespace
}  // namespace aomd::parallel_test
