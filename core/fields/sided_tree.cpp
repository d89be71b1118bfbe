#include "core/fields/sided_tree.h"

#include <utility>

#include <glm/geometric.hpp>

namespace aomd::fields {
namespace {

std::vector<Triangle> triangles_of_items(const std::vector<glm::dvec3>& positions,
                                         const std::vector<SidedTree::Item>& items) {
  std::vector<Triangle> triangles;
  triangles.reserve(items.size());
  for (const SidedTree::Item& item : items)
    triangles.push_back(
        {positions[item.corners[0]], positions[item.corners[1]], positions[item.corners[2]]});
  return triangles;
}

}  // namespace

std::vector<SidedTree::Item> face_items(const Cells& faces) {
  std::vector<SidedTree::Item> items;
  items.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto v = faces.vertices(f);
    const glm::dvec3 normal = faces.area_normal(f);
    for (std::size_t k = 2; k < v.size(); ++k)
      items.push_back({{v[0], v[k - 1], v[k]}, f, 0, normal});
  }
  return items;
}

SidedTree::SidedTree(const std::vector<glm::dvec3>& positions, std::vector<Item> items, int threads)
    : items_(std::move(items)), tree_(triangles_of_items(positions, items_), threads) {}

template <typename Takes>
TriangleTree::Nearest SidedTree::look(const glm::dvec3& p, const Takes& takes, double most2) const {
  return tree_.nearest_of(
      p, [&](std::uint32_t n) { return takes(items_[tree_.source(n)]); }, most2);
}

TriangleTree::Nearest SidedTree::nearest_in(const glm::dvec3& p, std::uint32_t part) const {
  if (part == no_index) return tree_.nearest(p);
  const TriangleTree::Nearest found =
      look(p, [part](const Item& item) { return item.part == part; });
  return found.triangle == no_index ? tree_.nearest(p) : found;
}

const SidedTree::Item* SidedTree::nearest(const glm::dvec3& p, const Side& side) const {
  const auto agrees = [&](const Item& item) {
    return (side.part == no_index || item.part == side.part) &&
           glm::dot(item.direction, side.direction) > 0;
  };
  TriangleTree::Nearest found = nearest_in(p, side.part);
  if (found.triangle == no_index) return nullptr;
  const Item* const any = &items_[tree_.source(found.triangle)];
  if (agrees(*any)) return any;
  found = look(p, agrees, side.reach * side.reach);
  return found.triangle != no_index ? &items_[tree_.source(found.triangle)] : any;
}

}  // namespace aomd::fields
