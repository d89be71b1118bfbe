#include <algorithm>

#include "core/base/box.h"
#include "core/repair/stages.h"

namespace aomd::repair_detail {

Tally remove_small_pieces(Surface& surface, double percent) {
  DisjointSets pieces = pieces_of(surface);
  std::vector<Box> boxes(surface.vertex_count());
  Box whole;
  surface.each_face([&](std::uint32_t f) {
    Box& own = boxes[pieces.find(surface.vertices(f)[0])];
    for (const std::uint32_t v : surface.vertices(f)) own.add(surface.position(v));
  });
  std::size_t largest = 0;
  for (std::size_t root = 0; root < boxes.size(); ++root) {
    if (boxes[root].diagonal() > boxes[largest].diagonal() || boxes[largest].empty())
      largest = root;
    whole.add(boxes[root]);
  }
  const double limit = whole.diagonal() * percent / 100;
  std::vector<std::uint8_t> told(boxes.size(), 0);
  Tally removed;
  surface.each_face([&](std::uint32_t f) {
    const std::uint32_t root = pieces.find(surface.vertices(f)[0]);
    if (root == largest || !(boxes[root].diagonal() < limit)) return;
    if (!told[root]) removed.add(f);
    told[root] = 1;
    surface.remove(f);
  });
  return removed;
}

std::vector<std::uint8_t> used_vertices(const MeshData& data) {
  std::vector<std::uint8_t> used(data.positions.size(), 0);
  for (const EntityList* list : {&data.edges, &data.faces})
    for (const std::uint32_t v : list->vertices) used[v] = 1;
  return used;
}

Tally drop_unused_vertices(MeshData& data) {
  const std::vector<std::uint8_t> used = used_vertices(data);
  Tally dropped;
  std::vector<std::uint32_t> place(used.size());
  for (std::uint32_t v = 0, next = 0; v < used.size(); ++v) {
    place[v] = next;
    next += used[v];
    if (!used[v]) dropped.add(v);
  }
  if (dropped.count() == 0) return dropped;
  for (EntityList* list : {&data.edges, &data.faces})
    for (std::uint32_t& v : list->vertices) v = place[v];
  keep_entities(data, 0, used);
  return dropped;
}

}  // namespace aomd::repair_detail
