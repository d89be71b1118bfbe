#include "core/mesh/shared_edits.h"

#include <algorithm>

#include "core/base/assertion.h"

namespace aomd {

bool SharedEdits::possible(const Mesh& mesh) {
  const auto follows = [&](int k) { return mesh.stored(k, 2) || mesh.stored(2, k); };
  return mesh.stored(2, 0) && mesh.stored(0, 2) && !follows(1) && !follows(3) &&
         mesh.count(3) == 0 && !mesh.stored(0, 1) && !mesh.complete(1) && !mesh.journal() &&
         !mesh.class_lists() && !mesh.hash(2).built();
}

void SharedEdits::begin(Mesh& mesh, std::size_t parts, std::vector<SharedEdits>& edits) {
  AOMD_DEBUG_CHECK(possible(mesh));
  UpRows& rows = mesh.representation_.up(0, 2);
  constexpr std::size_t least = 4 * std::size_t{enough};
  rows.lend(parts, static_cast<std::uint32_t>(std::max(least, rows.entries() / (8 * parts))));
  for (std::size_t part = edits.size(); part < parts; ++part)
    edits.push_back(SharedEdits(mesh, part));
}

void SharedEdits::settle(Mesh& mesh, std::vector<SharedEdits>& edits) {
  for (SharedEdits& part : edits)
    for (const int level : {0, 1}) {
      std::vector<std::uint32_t>& ids = part.destroyed_[static_cast<std::size_t>(level)];
      for (const std::uint32_t id : ids) mesh.level(2 * level).ids.destroy(id);
      ids.clear();
    }
  mesh.representation_.up(0, 2).settle();
  ++mesh.revision_;
}

void SharedEdits::destroy_unused(Face f) {
  UpRows& faces_of = rows();
  for (const Vertex v : mesh_->triangle(f))
    AOMD_CHECK(faces_of.erase(v.index, f.index, faces_of.room(part_)));
  destroyed_[1].push_back(f.index);
}

void SharedEdits::rebind(std::span<const Rebinding> items) {
  UpRows& faces_of = rows();
  for (const Rebinding& item : items) {
    const std::uint32_t face = item.entity.index;
    std::uint32_t& corner = mesh_->representation_.down(2, 0).row(face)[item.slot];
    AOMD_CHECK(item.entity.dimension == 2 && corner == item.from.index);
    corner = item.to.index;
    faces_of.erase(item.from.index, face, faces_of.room(part_));
    faces_of.insert(item.to.index, face, faces_of.room(part_));
  }
}

}  // namespace aomd
