#include "core/mesh/class_lists.h"

#include <algorithm>

#include "core/base/assertion.h"

namespace aomd {

std::span<const std::uint32_t> ClassLists::entities(int dim, ModelRef model) const {
  const auto it = level(dim).lists.find(model.bits());
  return it == level(dim).lists.end() ? std::span<const std::uint32_t>() : it->second;
}

std::vector<ModelRef> ClassLists::models(int dim) const {
  std::vector<ModelRef> result;
  for (const auto& [bits, list] : level(dim).lists)
    if (!list.empty()) result.push_back(ModelRef::from_bits(bits));
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t ClassLists::bytes() const {
  std::size_t sum = 0;
  for (const Level& l : levels_) {
    sum += l.place.capacity() * 4;
    for (const auto& [bits, list] : l.lists)
      sum += list.capacity() * 4 + sizeof(std::vector<std::uint32_t>) + sizeof(bits);
  }
  return sum;
}

// Neighbours are mostly on the same model entity: its list is not looked up for each.
void ClassLists::insert_all(int dim, const IdPool& ids, std::span<const ModelRef> classes) {
  Level& l = level(dim);
  l.place.resize(ids.capacity());
  ModelRef recent;
  std::vector<std::uint32_t>* list = nullptr;
  for (std::uint32_t id = ids.next_alive(0); id < ids.capacity(); id = ids.next_alive(id + 1)) {
    if (!list || classes[id] != recent) list = &l.lists[(recent = classes[id]).bits()];
    l.place[id] = static_cast<std::uint32_t>(list->size());
    list->push_back(id);
  }
  l.used = l.lists.size();
}

void ClassLists::insert(int dim, std::uint32_t id, ModelRef model) {
  Level& l = level(dim);
  std::vector<std::uint32_t>& list = l.lists[model.bits()];
  l.used += list.empty() ? 1 : 0;
  if (id >= l.place.size()) l.place.resize(std::size_t{id} + 1);
  l.place[id] = static_cast<std::uint32_t>(list.size());
  list.push_back(id);
}

void ClassLists::erase(int dim, std::uint32_t id, ModelRef model) {
  Level& l = level(dim);
  std::vector<std::uint32_t>& list = l.lists[model.bits()];
  const std::uint32_t at = l.place[id];
  AOMD_CHECK(at < list.size() && list[at] == id);
  list[at] = list.back();
  l.place[list[at]] = at;
  list.pop_back();
  l.used -= list.empty() ? 1 : 0;
}

}  // namespace aomd
