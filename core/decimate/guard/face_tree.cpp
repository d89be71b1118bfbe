#include "core/decimate/guard/face_tree.h"

#include <utility>

#include "core/base/assertion.h"
#include "core/model/triangle_intersection.h"

namespace aomd {

// Of a quad with one half that has area, that one.
FaceTree::Item FaceTree::item_of(const Mesh& mesh, Face f) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(f, buffer);
  const auto at = [&](std::size_t i) { return mesh.position(Vertex(v[i])); };
  Item item{{at(0), at(1), at(2)}, f};
  if (v.size() == 3) return item;
  const Triangle second{at(0), at(2), at(3)};
  if (without_area(item.corners)) {
    item.corners = second;
  } else if (!without_area(second)) {
    item.half = static_cast<std::uint32_t>(halves_.size());
    halves_.push_back(second);
  }
  return item;
}

Box FaceTree::box_of(const Item& item) const {
  if (without_area(item.corners)) return {};
  Box box = aomd::box_of(item.corners);
  if (item.half != no_index) box.add(aomd::box_of(halves_[item.half]));
  return box;
}

bool FaceTree::cuts(const Triangle& t, const Item& item) const {
  return intersect(t, item.corners) || (item.half != no_index && intersect(t, halves_[item.half]));
}

FaceTree::FaceTree(const Mesh& mesh) : place_(mesh.capacity(2), no_index) {
  std::vector<Item> items;
  items.reserve(mesh.count(2));
  for (const Face f : mesh.faces())
    if (mesh.classification(f).dimension() != 3) items.push_back(item_of(mesh, f));
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
    boxes.push_back(box_of(item));
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
  Item& item = items_[place_[f]];
  AOMD_CHECK(item.half == no_index);
  item.corners = corners;
  boxes_.put(place_[f], box_of(item));
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
