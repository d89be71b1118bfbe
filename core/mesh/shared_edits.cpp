#include "core/mesh/shared_edits.h"

#include <algorithm>

#include "core/base/assertion.h"

namespace aomd {

bool SharedEdits::possible(const Mesh& mesh) {
  const int level = level_of(mesh);
  const auto follows = [&](int k) { return mesh.stored(k, level) || mesh.stored(level, k); };
  const bool stored = mesh.stored(level, 0) && mesh.stored(0, level) && !mesh.journal() &&
                      !mesh.class_lists() && !mesh.hash(level).built() && !mesh.complete(1);
  if (level == 2) return stored && !follows(1) && !follows(3) && !mesh.stored(0, 1);
  const ShapeTemplate* all = mesh.uniform_shape(3);
  return stored && !follows(1) && !follows(2) && !mesh.complete(2) && all && all->vertex_count == 4;
}

void SharedEdits::begin(Mesh& mesh, std::size_t parts, std::vector<SharedEdits>& edits) {
  AOMD_DEBUG_CHECK(possible(mesh));
  const int level = level_of(mesh);
  UpRows& rows = mesh.representation_.up(0, level);
  const std::size_t least = 4 * std::size_t{enough_on(level)};
  rows.lend(parts, static_cast<std::uint32_t>(std::max(least, rows.entries() / (8 * parts))));
  for (std::size_t part = edits.size(); part < parts; ++part)
    edits.push_back(SharedEdits(mesh, part));
}

void SharedEdits::settle(Mesh& mesh, std::vector<SharedEdits>& edits) {
  const int upper = level_of(mesh);
  for (SharedEdits& part : edits)
    for (const int level : {0, 1}) {
      std::vector<std::uint32_t>& ids = part.destroyed_[static_cast<std::size_t>(level)];
      for (const std::uint32_t id : ids) mesh.level(upper * level).ids.destroy(id);
      ids.clear();
    }
  mesh.representation_.up(0, upper).settle();
  ++mesh.revision_;
}

template <std::size_t N>
void SharedEdits::destroy_unused(std::uint32_t id, const std::array<Vertex, N>& corners) {
  UpRows& uppers_of = rows();
  for (const Vertex v : corners) AOMD_CHECK(uppers_of.erase(v.index, id, uppers_of.room(part_)));
  destroyed_[1].push_back(id);
}

template void SharedEdits::destroy_unused(std::uint32_t, const std::array<Vertex, 3>&);
template void SharedEdits::destroy_unused(std::uint32_t, const std::array<Vertex, 4>&);

void SharedEdits::rebind(std::span<const Rebinding> items) {
  UpRows& uppers_of = rows();
  for (const Rebinding& item : items) {
    const std::uint32_t id = item.entity.index;
    std::uint32_t& corner = mesh_->representation_.down(level_, 0).row(id)[item.slot];
    AOMD_CHECK(item.entity.dimension == level_ && corner == item.from.index);
    corner = item.to.index;
    uppers_of.erase(item.from.index, id, uppers_of.room(part_));
    uppers_of.insert(item.to.index, id, uppers_of.room(part_));
  }
}

}  // namespace aomd
