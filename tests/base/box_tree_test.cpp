// The tree of boxes against a look at every box.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "core/base/box_tree.h"

namespace aomd::test::box_tree_test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

Box random_box(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 10), size(0, 1);
  Box box;
  const glm::dvec3 corner(place(random), place(random), place(random));
  box.add(corner);
  box.add(corner + glm::dvec3(size(random), size(random), size(random)));
  return box;
}

std::vector<Box> random_boxes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Box> boxes;
  while (boxes.size() < count) boxes.push_back(random_box(random));
  return boxes;
}

BoxTree tree_over(const std::vector<Box>& boxes, int threads = 1) {
  std::vector<BoxTree::Item> items;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    items.push_back({boxes[i].low + boxes[i].high, i});
  BoxTree tree(items, threads);
  std::vector<Box> ordered;
  for (std::uint32_t n = 0; n < tree.size(); ++n) ordered.push_back(boxes[tree.source(n)]);
  tree.fit(ordered);
  return tree;
}

std::set<std::uint32_t> touching(const BoxTree& tree, const Box& box) {
  std::set<std::uint32_t> found;
  tree.touching(box, [&](std::uint32_t n) { EXPECT_TRUE(found.insert(tree.source(n)).second); });
  return found;
}

std::set<std::uint32_t> touching(const std::vector<Box>& boxes, const Box& box) {
  std::set<std::uint32_t> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].touches(box)) found.insert(i);
  return found;
}

TEST(BoxTreeTest, FindsWhatTouches) {
  std::mt19937 random(1);
  for (const std::size_t count : {0u, 1u, 4u, 5u, 400u}) {
    const std::vector<Box> boxes = random_boxes(count, 2);
    const BoxTree tree = tree_over(boxes);
    for (int k = 0; k < 50; ++k) {
      const Box box = random_box(random);
      EXPECT_EQ(touching(tree, box), touching(boxes, box)) << count;
    }
  }
}

TEST(BoxTreeTest, ABoxThatChangesIsFoundWhereItIs) {
  std::vector<Box> boxes = random_boxes(300, 3);
  BoxTree tree = tree_over(boxes);
  std::mt19937 random(4);
  for (int k = 0; k < 600; ++k) {
    const auto n = static_cast<std::uint32_t>(random() % boxes.size());
    const Box box = random() % 3 == 0 ? Box() : random_box(random);
    boxes[tree.source(n)] = box;
    tree.put(n, box);
    const Box there = random_box(random);
    ASSERT_EQ(touching(tree, there), touching(boxes, there)) << k;
    Box all;
    for (const Box& b : boxes) all.add(b);
    ASSERT_EQ(tree.box(), all) << k;
  }
}

TEST(BoxTreeTest, FindsTheCheapest) {
  const std::vector<Box> boxes = random_boxes(500, 5);
  const BoxTree tree = tree_over(boxes);
  std::mt19937 random(6);
  for (int k = 0; k < 100; ++k) {
    const glm::dvec3 p = 2.0 * random_box(random).low;
    double best = 1e300, expected = 1e300;
    int asked = 0;
    tree.cheapest(
        best, [&](std::uint32_t node) { return tree.node(node).box.distance2(p); },
        [&](std::uint32_t n) { return ++asked, best = std::min(best, tree.box(n).distance2(p)); });
    for (const Box& box : boxes) expected = std::min(expected, box.distance2(p));
    EXPECT_EQ(best, expected);
    EXPECT_LT(asked, 100);
  }
}

TEST(BoxTreeTest, EveryPairOnce) {
  const std::vector<Box> boxes = random_boxes(300, 7), others = random_boxes(100, 8);
  const BoxTree tree = tree_over(boxes), other = tree_over(others);
  std::vector<Pair> within, between, expected_within, expected_between;
  tree.touching_pairs(0, tree.nodes(), [&](std::uint32_t n, std::uint32_t m) {
    within.push_back(std::minmax({tree.source(n), tree.source(m)}));
  });
  tree.touching_pairs(other, [&](std::uint32_t n, std::uint32_t m) {
    between.push_back({tree.source(n), other.source(m)});
  });
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (boxes[i].touches(boxes[j])) expected_within.push_back({i, j});
    for (std::uint32_t j = 0; j < others.size(); ++j)
      if (boxes[i].touches(others[j])) expected_between.push_back({i, j});
  }
  std::sort(within.begin(), within.end());
  std::sort(between.begin(), between.end());
  EXPECT_EQ(within, expected_within);
  EXPECT_EQ(between, expected_between);
}

TEST(BoxTreeTest, TheSameForAnyNumberOfThreads) {
  const std::vector<Box> boxes = random_boxes(20000, 9);
  const BoxTree one = tree_over(boxes);
  std::vector<Pair> expected;  // in the order of the nodes
  one.touching_pairs(0, one.nodes(), [&](auto n, auto m) { expected.push_back({n, m}); });
  for (const int threads : {2, 3, 7}) {
    const BoxTree several = tree_over(boxes, threads);
    ASSERT_EQ(several.nodes(), one.nodes());
    for (std::uint32_t n = 0; n < one.size(); ++n) ASSERT_EQ(several.source(n), one.source(n));
    std::vector<Pair> pairs;
    several.touching_pairs(0, one.nodes(), [&](auto n, auto m) { pairs.push_back({n, m}); });
    EXPECT_TRUE(pairs == expected) << threads;
  }
}

// Places that halve their distance to one corner again and again: the middle leaves one aside.
TEST(BoxTreeTest, StaysShallow) {
  std::vector<Box> boxes(1000);
  double x = 1;
  for (Box& box : boxes) box.add(glm::dvec3(x, 0, 0)), x /= 2;
  const BoxTree tree = tree_over(boxes);
  EXPECT_EQ(touching(tree, boxes[500]), (std::set<std::uint32_t>{500}));
}

}  // namespace
}  // namespace aomd::test::box_tree_test
