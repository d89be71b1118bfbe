#include "core/base/box_tree.h"

#include <algorithm>

#include "core/base/assertion.h"
#include "core/base/parallel.h"

namespace aomd {
namespace {

// Each comparison as the processor's own instruction has it, whose first operand gives way: for
// Box::add it needs copies, as there equal numbers leave the other one.
Box box_of_centres(std::span<const BoxTree::Item> items) {
  Box box;
  glm::dvec3 low = box.low, high = box.high;
  for (const BoxTree::Item& item : items)
    for (int axis = 0; axis < 3; ++axis) {
      const double at = item.centre[axis];
      low[axis] = low[axis] < at ? low[axis] : at;
      high[axis] = high[axis] > at ? high[axis] : at;
    }
  return {low, high};
}

}  // namespace

BoxTree::BoxTree(std::span<Item> items, int threads) {
  if (items.empty()) return;
  nodes_.reserve(items.size());
  build(items, 0, threads, nodes_);
  source_.reserve(items.size());
  for (const Item& item : items) source_.push_back(item.source);
}

void BoxTree::fit(std::vector<Box> boxes) {
  AOMD_CHECK(boxes.size() == size());
  boxes_ = std::move(boxes);
  for (auto id = static_cast<std::uint32_t>(nodes_.size()); id-- > 0;)
    nodes_[id].box = box_below(id);  // children stand after their parents
}

Box BoxTree::box_below(std::uint32_t id) const {
  const Node& node = nodes_[id];
  Box box;
  if (node.leaf()) {
    for (std::uint32_t n = node.begin; n < node.end; ++n) box.add(boxes_[n]);
  } else {
    box = nodes_[id + 1].box;
    box.add(nodes_[node.right].box);
  }
  return box;
}

void BoxTree::put(std::uint32_t n, const Box& box) {
  boxes_[n] = box;
  std::uint32_t path[stack_size];
  std::size_t depth = 0;
  path[depth++] = 0;
  while (!nodes_[path[depth - 1]].leaf()) {
    const std::uint32_t id = path[depth - 1], right = nodes_[id].right;
    path[depth++] = n < nodes_[right].begin ? id + 1 : right;
  }
  while (depth > 0) {
    const std::uint32_t id = path[--depth];
    const Box around = box_below(id);
    if (around == nodes_[id].box) return;
    nodes_[id].box = around;
  }
}

// Sorts the items into two halves and returns the size of the first.
std::size_t BoxTree::split(std::span<Item> items) {
  const Box centres = box_of_centres(items);
  const glm::dvec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const double middle = 0.5 * (centres.low[axis] + centres.high[axis]);
  const auto second = std::partition(items.begin(), items.end(), [axis, middle](const Item& item) {
    return item.centre[axis] < middle;
  });
  auto half = static_cast<std::size_t>(second - items.begin());
  if (std::min(half, items.size() - half) * lopsided < items.size()) {
    half = items.size() / 2;
    std::nth_element(
        items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
        [axis](const Item& a, const Item& b) { return a.centre[axis] < b.centre[axis]; });
  }
  return half;
}

// Where threads share the halves, the right one gets nodes of its own, to be put behind those of
// the left.
void BoxTree::build(std::span<Item> items, std::uint32_t begin, int threads,
                    std::vector<Node>& nodes) {
  constexpr std::size_t worth_a_thread = 4096;
  const std::size_t id = nodes.size();
  nodes.push_back({{}, begin, begin + static_cast<std::uint32_t>(items.size()), 0});
  if (items.size() <= leaf_size) return;
  const std::size_t half = split(items);
  const std::uint32_t middle = begin + static_cast<std::uint32_t>(half);
  if (threads <= 1 || items.size() < worth_a_thread) {
    build(items.first(half), begin, 1, nodes);
    nodes[id].right = static_cast<std::uint32_t>(nodes.size());
    return build(items.subspan(half), middle, 1, nodes);
  }
  std::vector<Node> rest;
  parallel_for(2, 2, 1, [&](std::size_t first, std::size_t) {
    if (first == 0) build(items.first(half), begin, threads - threads / 2, nodes);
    if (first == 1) build(items.subspan(half), middle, threads / 2, rest);
  });
  const auto right = static_cast<std::uint32_t>(nodes.size());
  nodes[id].right = right;
  for (Node& node : rest) node.right += node.leaf() ? 0 : right;
  nodes.insert(nodes.end(), rest.begin(), rest.end());
}

}  // namespace aomd
