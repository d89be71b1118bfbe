// Consecutive ids: what is left of a mesh after many deletions, without the holes.

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/mesh/mesh.h"

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

std::vector<std::uint32_t> consecutive(const IdPool& ids) {
  std::vector<std::uint32_t> new_index(ids.capacity(), no_index);
  std::uint32_t next = 0;
  for (std::uint32_t id = ids.next_alive(0); id < ids.capacity(); id = ids.next_alive(id + 1))
    new_index[id] = next++;
  return new_index;
}

}  // namespace

std::array<std::vector<std::uint32_t>, 4> Mesh::compact() {
  if (journal_)
    throw std::logic_error("a journal is attached, and its records name the present ids");
  ++revision_;
  std::array<std::vector<std::uint32_t>, 4> maps;
  for (int dim = 0; dim < 4; ++dim) maps[static_cast<std::size_t>(dim)] = consecutive(ids(dim));
  Representation compacted;
  std::array<bool, 16> upward{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      compacted.demand(i, j) = representation_.demand(i, j);
      compacted.record(i, j) = representation_.record(i, j);
      if (!stored(i, j)) continue;
      if (i < j)
        upward[static_cast<std::size_t>(4 * i + j)] = true;
      else
        compacted.down(i, j) = compact_rows(i, j, maps);
    }
  representation_ = std::move(compacted);
  for (int dim = 0; dim < 4; ++dim) {
    const auto& map = maps[static_cast<std::size_t>(dim)];
    const std::uint32_t n = count(dim);
    if (dim == 0) close_up(positions_, map, n);
    close_up(level(dim).classes, map, n);
    close_up(level(dim).shapes, map, n);
    attached_.compact(dim, map, n);
    level(dim).ids = IdPool();
    level(dim).ids.create_many(n);
    hash_of(dim).release();
  }
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (upward[static_cast<std::size_t>(4 * i + j)]) build_up(i, j);
  if (class_lists_) keep_class_lists(true);
  return maps;
}

// Those on model edges, and of the unclassified ones those that nothing else implies.
std::vector<std::uint8_t> Mesh::edges_to_keep() {
  std::vector<std::uint8_t> stays(capacity(1), 0);
  std::optional<Request> faces, regions;
  for (const Edge e : edges()) {
    const ModelRef on = classification(e);
    if (!on.valid() && !faces) {
      faces = request(1, 2, "letting go of edges");
      if (count(3) > 0) regions = request(1, 3, "letting go of edges");
    }
    stays[e.index] = on.valid() ? on.dimension() <= 1
                                : row<2>(e).empty() && (count(3) == 0 || row<3>(e).empty());
  }
  return stays;
}

void Mesh::keep_model_edges_only() {
  if (journal_)
    throw std::logic_error("a journal is attached, and its records name the present edges");
  constexpr std::pair<int, int> relations[] = {{0, 1}, {1, 2}, {1, 3}, {2, 1}, {3, 1}};
  for (const auto& [i, j] : relations) {
    if (representation_.demand(i, j).requests > 0)
      throw std::logic_error("an algorithm has requested edges, and would lose them");
    if (stored(i, j) && i > j && !stored(i, 0)) build_vertices(i);
  }
  const std::vector<std::uint8_t> stays = edges_to_keep();
  for (const auto& [i, j] : relations) {
    representation_.demand(i, j).user = false;
    free_unwanted(i, j);
  }
  std::vector<std::uint32_t> new_index(capacity(1), no_index);
  DownRows rows;
  std::uint32_t kept = 0;
  for (const Edge e : edges())
    if (stays[e.index]) new_index[e.index] = kept++;
  rows.allocate(kept, 2, false);
  for (std::uint32_t id = 0; id < new_index.size(); ++id)
    if (new_index[id] != no_index)
      std::copy_n(representation_.down(1, 0).row(id), 2, rows.row(new_index[id]));
  close_up(level(1).classes, new_index, kept);
  attached_.compact(1, new_index, kept);
  level(1).ids = IdPool();
  level(1).ids.create_many(kept);
  level(1).complete = false;
  hash_of(1).release();
  representation_.down(1, 0) = std::move(rows);
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
