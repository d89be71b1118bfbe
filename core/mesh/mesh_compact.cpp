// Consecutive ids: what is left of a mesh after many deletions, without the holes.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/mesh/mesh.h"
#include "core/mesh/names.h"

namespace aomd {
namespace {

template <typename T>
void close_up(std::vector<T>& values, std::span<const std::uint32_t> new_index,
              std::uint32_t count) {
  if (values.empty()) return;
  for (std::size_t old = 0; old < new_index.size(); ++old)
    if (new_index[old] != no_index) values[new_index[old]] = values[old];
  values.resize(count);
  values.shrink_to_fit();
}

void close_up_rows(DownRows& old, std::span<const std::uint32_t> new_index, std::uint32_t count) {
  DownRows rows;
  rows.allocate(count, old.stride(), false);
  for (std::uint32_t id = 0; id < new_index.size(); ++id)
    if (new_index[id] != no_index) std::copy_n(old.row(id), old.stride(), rows.row(new_index[id]));
  old = std::move(rows);
}

std::vector<std::uint32_t> consecutive(const IdPool& ids) {
  std::vector<std::uint32_t> new_index(ids.capacity(), no_index);
  std::uint32_t next = 0;
  for (std::uint32_t id = ids.next_alive(0); id < ids.capacity(); id = ids.next_alive(id + 1))
    new_index[id] = next++;
  return new_index;
}

}  // namespace

// Takes the new ids into all that is known of a level but its relations.
void Mesh::close_up_level(int dim, std::span<const std::uint32_t> new_index, std::uint32_t count) {
  close_up(level(dim).classes, new_index, count);
  close_up(level(dim).shapes, new_index, count);
  attached_.compact(dim, new_index, count);
  level(dim).ids = IdPool();
  level(dim).ids.create_many(count);
  hash_of(dim).release();
}

std::array<std::vector<std::uint32_t>, 4> Mesh::compact() {
  if (journal_)
    throw std::logic_error("a journal is attached, and its records name the present ids");
  ++revision_;
  std::array<std::vector<std::uint32_t>, 4> maps;
  for (int dim = 0; dim < 4; ++dim) maps[static_cast<std::size_t>(dim)] = consecutive(ids(dim));
  const auto upward = compact_relations(maps);
  close_up(positions_, maps[0], count(0));
  for (int dim = 0; dim < 4; ++dim)
    close_up_level(dim, maps[static_cast<std::size_t>(dim)], count(dim));
  for (const auto& [i, j] : upward) build_up(i, j);
  if (class_lists_) keep_class_lists(true);
  return maps;
}

// Renumbers the downward relations and returns the upward ones, which are to be built again.
std::vector<std::pair<int, int>> Mesh::compact_relations(
    const std::array<std::vector<std::uint32_t>, 4>& maps) {
  Representation compacted;
  std::vector<std::pair<int, int>> upward;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      compacted.demand(i, j) = representation_.demand(i, j);
      compacted.record(i, j) = representation_.record(i, j);
      if (!stored(i, j)) continue;
      if (i < j)
        upward.emplace_back(i, j);
      else
        compacted.down(i, j) = compact_rows(i, j, maps);
    }
  representation_ = std::move(compacted);
  return upward;
}

// Entities on model entities of no higher dimension stay, and so do unclassified ones that nothing
// else implies.
std::vector<std::uint8_t> Mesh::entities_to_keep(int dim) {
  std::vector<std::uint8_t> stays(capacity(dim), 0);
  std::vector<Request> users;
  const auto has_users = [&](std::uint32_t id) {
    for (int j = dim + 1; j < 4; ++j)
      if (count(j) > 0 && !representation_.up(dim, j).row(id).empty()) return true;
    return false;
  };
  for (std::uint32_t id = ids(dim).next_alive(0); id < capacity(dim);
       id = ids(dim).next_alive(id + 1)) {
    const ModelRef on = level(dim).classes[id];
    if (!on.valid() && users.empty())
      for (int j = dim + 1; j < 4; ++j)
        if (count(j) > 0) users.push_back(request(dim, j, "letting go of entities"));
    stays[id] = on.valid() ? on.dimension() <= dim : !has_users(id);
  }
  return stays;
}

void Mesh::keep_model_entities_only(int dim) {
  const std::string names = entity_plural(dim);
  if (journal_)
    throw std::logic_error("a journal is attached, and its records name the present " + names);
  std::vector<std::pair<int, int>> relations{{0, dim}};
  for (int other = 1; other < 4; ++other) {
    if (other == dim) continue;
    relations.emplace_back(std::min(dim, other), std::max(dim, other));
    relations.emplace_back(std::max(dim, other), std::min(dim, other));
  }
  for (const auto& [i, j] : relations) {
    if (representation_.demand(i, j).requests > 0)
      throw std::logic_error("an algorithm has requested " + names + ", and would lose them");
    if (stored(i, j) && i > j && !stored(i, 0)) build_vertices(i);
  }
  const std::vector<std::uint8_t> stays = entities_to_keep(dim);
  for (const auto& [i, j] : relations) {
    representation_.demand(i, j).user = false;
    free_unwanted(i, j);
  }
  std::vector<std::uint32_t> new_index(capacity(dim), no_index);
  std::uint32_t kept = 0;
  for (std::uint32_t id = 0; id < new_index.size(); ++id)
    if (stays[id] != 0) new_index[id] = kept++;
  if (stored(dim, 0)) close_up_rows(representation_.down(dim, 0), new_index, kept);
  close_up_level(dim, new_index, kept);
  level(dim).complete = false;
  if (class_lists_) keep_class_lists(true);
}

DownRows Mesh::compact_rows(int i, int j,
                            const std::array<std::vector<std::uint32_t>, 4>& maps) const {
  const DownRows& old = representation_.down(i, j);
  DownRows rows;
  rows.allocate(count(i), old.stride(), j == i - 1 && j > 0);
  for (std::uint32_t id = 0; id < capacity(i); ++id) {
    if (!ids(i).alive(id)) continue;
    const std::uint32_t to = maps[static_cast<std::size_t>(i)][id];
    for (int k = 0; k < lower_count(EntityRef(i, id), j); ++k)
      rows.row(to)[k] = maps[static_cast<std::size_t>(j)][old.row(id)[k]];
    if (j == i - 1 && j > 0) rows.set_directions(to, old.directions(id));
  }
  return rows;
}

}  // namespace aomd
