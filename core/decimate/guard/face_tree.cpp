#include "core/decimate/guard/face_tree.h"

#include <utility>

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

}  // namespace

FaceTree::FaceTree(const Mesh& mesh) : place_(mesh.capacity(2), no_index) {
  std::vector<Item> items;
  items.reserve(mesh.count(2));
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() == 3) continue;  // inside a region of a volume
    const auto t = mesh.triangle(f);
    items.push_back({{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])}, f});
  }
  build(items);
}

void FaceTree::build(const std::vector<Item>& items) {
  std::vector<BoxTree::Item> order;
  order.reserve(items.size());
  for (const Item& item : items) {
    const Triangle& t = item.corners;
    order.push_back({t[0] + t[1] + t[2], static_cast<std::uint32_t>(order.size())});
  }
  boxes_ = BoxTree(order);
  items_.clear();
  std::vector<Box> boxes;
  boxes.reserve(items.size());
  for (const BoxTree::Item& place : order) {
    const Item& item = items[place.source];
    place_[item.face] = static_cast<std::uint32_t>(items_.size());
    items_.push_back(item);
    boxes.push_back(box_of(item.corners));
  }
  boxes_.fit(std::move(boxes));
  present_ = items.size();
}

void FaceTree::remove(Face f) {
  AOMD_CHECK(f.index < place_.size() && place_[f] != no_index);
  const std::uint32_t n = std::exchange(place_[f], no_index);
  boxes_.put(n, Box());
  items_[n].face = Face();
  --present_;
}

void FaceTree::put(Face f, const Triangle& corners) {
  AOMD_CHECK(f.index < place_.size() && place_[f] != no_index);
  items_[place_[f]].corners = corners;
  boxes_.put(place_[f], box_of(corners));
}

void FaceTree::tidy() {
  if (2 * present_ >= items_.size()) return;
  std::vector<Item> items;
  items.reserve(present_);
  for (const Item& item : items_)
    if (item.face.valid()) items.push_back(item);
  build(items);
}

}  // namespace aomd
