#include "core/mesh/journal_replay.h"

#include "core/base/assertion.h"
#include "core/mesh/journal_record.h"

namespace aomd {

void JournalReplay::redo(std::span<const std::uint32_t> records) {
  const std::uint32_t* const end = records.data() + records.size();
  for (const std::uint32_t* w = records.data(); w < end; w += RecordHead::unpack(*w).length())
    apply(w, true);
}

void JournalReplay::undo(std::span<const std::uint32_t> records) {
  const std::uint32_t* const end = records.data() + records.size();
  records_.clear();
  for (const std::uint32_t* w = records.data(); w < end; w += RecordHead::unpack(*w).length())
    records_.push_back(w);
  for (auto w = records_.rbegin(); w != records_.rend(); ++w) apply(*w, false);
}

void JournalReplay::apply(const std::uint32_t* record, bool forward) {
  const RecordHead head = RecordHead::unpack(record[0]);
  if (head.kind != RecordKind::Rebind && !mine(head.dim)) return;
  switch (head.kind) {
    case RecordKind::Create:
      return forward ? create(record) : destroy(record);
    case RecordKind::Destroy:
      return forward ? destroy(record) : create(record);
    case RecordKind::Move:
      mesh_.positions_[record[1]] = unpack_position(record + (forward ? 8 : 2));
      return;
    case RecordKind::Classify:
      return mesh_.classify(head.dim, record[1], ModelRef::from_bits(record[forward ? 3 : 2]));
    case RecordKind::Rebind:
      return rebind(record, forward);
  }
}

/// What a creation did, or what undoes a destruction.
void JournalReplay::create(const std::uint32_t* record) {
  const RecordHead head = RecordHead::unpack(record[0]);
  const bool recorded = head.kind == RecordKind::Create;
  const std::uint32_t id = record[1];
  IdPool& ids = mesh_.level(head.dim).ids;
  if (recorded) {
    const auto again = ids.create();
    AOMD_CHECK(again.id == id && again.fresh == head.fresh);
  } else {
    ids.undo_destroy(id);
  }
  if (mesh_.level(head.dim).classes.size() < ids.capacity()) mesh_.grow_level(head.dim);
  const ModelRef model = ModelRef::from_bits(record[2]);
  if (head.dim == 0)
    mesh_.attach_vertex(id, unpack_position(record + 3), model);
  else
    mesh_.attach_entity(head.dim, id, head.shape, {record + 3, head.count}, model);
  if (recorded)
    mesh_.attached_.cover_again(head.dim, id,
                                mesh_.recorded_creations_[static_cast<std::size_t>(head.dim)]++);
}

void JournalReplay::destroy(const std::uint32_t* record) {
  const RecordHead head = RecordHead::unpack(record[0]);
  const std::uint32_t id = record[1];
  IdPool& ids = mesh_.level(head.dim).ids;
  if (!bare_) mesh_.detach_entity(head.dim, id);
  if (head.kind == RecordKind::Destroy) return ids.destroy(id);
  mesh_.attached_.uncover(head.dim, id,
                          --mesh_.recorded_creations_[static_cast<std::size_t>(head.dim)]);
  ids.undo_create(id, head.fresh);
  if (head.fresh) mesh_.grow_level(head.dim);
}

void JournalReplay::rebind(const std::uint32_t* record, bool forward) {
  rebindings_.clear();
  const std::uint32_t count = RecordHead::unpack(record[0]).count;
  ++record;
  for (std::uint32_t i = 0; i < count; ++i, record += 4) {
    const EntityRef entity(static_cast<int>(record[0] >> 8), record[1]);
    const Vertex from(record[2]), to(record[3]);
    if (!mine(entity.dimension)) continue;
    if (bare_)
      mesh_.representation_.down(entity.dimension, 0).row(entity.index)[record[0] & 255u] =
          record[forward ? 3 : 2];
    else
      rebindings_.push_back({entity, record[0] & 255u, forward ? from : to, forward ? to : from});
  }
  if (!rebindings_.empty()) mesh_.apply_rebindings(rebindings_);
}

}  // namespace aomd
