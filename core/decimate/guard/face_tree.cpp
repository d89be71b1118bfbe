#include "core/decimate/guard/face_tree.h"

#include <algorithm>

#include "core/base/assertion.h"
#include "core/model/triangle_intersection.h"

namespace aomd {
namespace {

Box box_of(const Triangle& t) {
  Box box;
  if (without_area(t)) return box;
  for (const glm::dvec3& p : t) box.add(p);
  return box;
}

bool same(const Box& a, const Box& b) { return a.low == b.low && a.high == b.high; }

}  // namespace

FaceTree::FaceTree(const Mesh& mesh) : place_(mesh.capacity(2), no_index) {
  items_.reserve(mesh.count(2));
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() == 3) continue;  // inside a region of a volume
    const auto t = mesh.triangle(f);
    const Triangle corners{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
    items_.push_back({box_of(corners), corners, f});
  }
  build();
}

void FaceTree::build() {
  present_ = items_.size();
  nodes_.clear();
  leaf_.resize(items_.size());
  if (items_.empty()) return;
  build(0, static_cast<std::uint32_t>(items_.size()), no_index);
  for (std::uint32_t n = 0; n < items_.size(); ++n) place_[items_[n].face] = n;
  for (auto id = static_cast<std::uint32_t>(nodes_.size()); id-- > 0;)
    nodes_[id].box = box_below(id);
}

void FaceTree::build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, parent});
  if (end - begin <= leaf_size) {
    std::fill(leaf_.begin() + begin, leaf_.begin() + end, id);
    return;
  }
  Box centres;
  for (std::uint32_t n = begin; n < end; ++n) centres.add(items_[n].box.low + items_[n].box.high);
  const glm::dvec3 size = centres.high - centres.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [axis](const Item& a, const Item& b) {
                     return a.box.low[axis] + a.box.high[axis] < b.box.low[axis] + b.box.high[axis];
                   });
  build(begin, middle, id);
  nodes_[id].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end, id);
}

Box FaceTree::box_below(std::uint32_t id) const {
  const Node& node = nodes_[id];
  Box box;
  if (node.right == 0) {
    for (std::uint32_t n = node.begin; n < node.end; ++n) box.add(items_[n].box);
  } else {
    box = nodes_[id + 1].box;
    box.add(nodes_[node.right].box);
  }
  return box;
}

void FaceTree::refit(std::uint32_t id) {
  for (; id != no_index; id = nodes_[id].parent) {
    const Box box = box_below(id);
    if (same(box, nodes_[id].box)) return;
    nodes_[id].box = box;
  }
}

void FaceTree::put(Face f, const Box& box) {
  AOMD_CHECK(f.index < place_.size() && place_[f] != no_index);
  Item& item = items_[place_[f]];
  present_ += item.box.empty();
  present_ -= box.empty();
  item.box = box;
  refit(leaf_[place_[f]]);
}

void FaceTree::remove(Face f) { put(f, Box()); }

void FaceTree::put(Face f, const Triangle& corners) {
  put(f, box_of(corners));
  items_[place_[f]].corners = corners;
}

void FaceTree::tidy() {
  if (2 * present_ >= items_.size()) return;
  std::erase_if(items_, [](const Item& item) { return item.box.empty(); });
  build();
}

}  // namespace aomd
