#include "core/mesh/attached.h"

#include <algorithm>

namespace aomd {

AttachedBase* AttachedData::find(int dim, std::string_view name) const {
  const Names& names = names_[static_cast<std::size_t>(dim)];
  const auto found = names.find(name);
  return found == names.end() ? nullptr : found->second;
}

AttachedBase& AttachedData::add(int dim, std::unique_ptr<AttachedBase> column) {
  const auto d = static_cast<std::size_t>(dim);
  AttachedBase& added = *lists_[d].emplace_back(std::move(column));
  names_[d].emplace(added.name(), &added);
  return added;
}

bool AttachedData::drop(int dim, std::string_view name) {
  const auto d = static_cast<std::size_t>(dim);
  const auto found = names_[d].find(name);
  if (found == names_[d].end()) return false;
  const AttachedBase* column = found->second;
  names_[d].erase(found);
  std::erase_if(lists_[d], [&](const auto& each) { return each.get() == column; });
  return true;
}

std::size_t AttachedData::bytes() const {
  std::size_t sum = 0;
  for (const List& list : lists_)
    for (const auto& column : list) sum += column->bytes();
  return sum;
}

void AttachedData::resize(int dim, std::uint32_t entities) {
  for (const auto& column : columns(dim)) column->resize(entities);
}

void AttachedData::created(int dim, std::uint32_t id) {
  for (const auto& column : columns(dim)) column->reset(id);
}

void AttachedData::cover(int dim, std::uint32_t id, std::size_t creation) {
  for (const auto& column : columns(dim)) column->cover(id, creation);
}

void AttachedData::uncover(int dim, std::uint32_t id, std::size_t creation) {
  for (const auto& column : columns(dim)) column->uncover(id, creation);
}

void AttachedData::cover_again(int dim, std::uint32_t id, std::size_t creation) {
  for (const auto& column : columns(dim)) column->cover_again(id, creation);
}

void AttachedData::start_after(int dim, std::size_t creations) {
  for (const auto& column : columns(dim)) column->start_after(creations);
}

void AttachedData::compact(int dim, std::span<const std::uint32_t> new_index,
                           std::uint32_t entities) {
  for (const auto& column : columns(dim)) column->compact(new_index, entities);
}

}  // namespace aomd
