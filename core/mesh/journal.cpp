#include "core/mesh/journal.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "core/mesh/check.h"

namespace aomd {
namespace {

/// From so many words of records for each entity on, a move through the history lets go of what can be
/// derived and builds it anew afterwards: building costs about as much as keeping relations up to date for a
/// twelfth of the entities.
constexpr std::size_t far_words_per_entity = 1;
/// How many steps before its turn the memory of a step is asked for.
constexpr std::size_t steps_ahead = 6;

void prefetch(const void* address) { __builtin_prefetch(address, 1); }

}  // namespace

const char* step_name(StepKind kind) {
  constexpr const char* names[] = {"edit", "collapse", "swap", "smooth", "classify"};
  return names[static_cast<std::size_t>(kind)];
}

void Journal::begin_step(StepKind kind, EntityRef entity) {
  AOMD_CHECK(!in_step_);
  pending_ = JournalStep{kind, entity, 0};
  in_step_ = true;
}

void Journal::end_step() {
  AOMD_CHECK(in_step_);
  in_step_ = false;
  if (!pending_) cursor_ = steps_.size();
  pending_.reset();
}

void Journal::cut_future() {
  if (cursor_ == steps_.size()) return;
  if (keeps_cut_) cut_ = future();
  drop_future();
}

JournalPart Journal::future() const {
  JournalPart part;
  if (cursor_ == steps_.size()) return part;
  const std::uint64_t begin = steps_[cursor_].begin;
  part.words.assign(words_.begin() + static_cast<std::ptrdiff_t>(begin), words_.end());
  part.steps.assign(steps_.begin() + static_cast<std::ptrdiff_t>(cursor_), steps_.end());
  for (JournalStep& step : part.steps) step.begin -= begin;
  return part;
}

void Journal::drop_future() {
  if (cursor_ == steps_.size()) return;
  words_.resize(steps_[cursor_].begin);
  steps_.resize(cursor_);
  ++epoch_;
}

JournalPart Journal::exchange_future(const JournalPart& part) {
  AOMD_CHECK(!in_step_);
  JournalPart old = future();
  drop_future();
  const std::uint64_t begin = words_.size();
  words_.insert(words_.end(), part.words.begin(), part.words.end());
  for (JournalStep step : part.steps) {
    step.begin += begin;
    steps_.push_back(step);
  }
  if (old.steps.empty()) ++epoch_;
  return old;
}

void Journal::open_record() {
  implicit_step_ = !in_step_;
  if (implicit_step_) begin_step(StepKind::Edit, {});
  if (!pending_) return;
  cut_future();
  pending_->begin = words_.size();
  steps_.push_back(*pending_);
  pending_.reset();
}

void Journal::close_record() {
  if (implicit_step_) end_step();
  implicit_step_ = false;
}

void Journal::push_position(const glm::dvec3& p) {
  for (int k = 0; k < 3; ++k) {
    const auto bits = std::bit_cast<std::uint64_t>(p[k]);
    words_.push_back(static_cast<std::uint32_t>(bits));
    words_.push_back(static_cast<std::uint32_t>(bits >> 32));
  }
}

glm::dvec3 Journal::read_position(std::uint64_t at) const { return unpack_position(words_.data() + at); }

void Journal::record_entity(bool create, const Mesh& mesh, EntityRef e, bool fresh) {
  open_record();
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  words_.push_back(RecordHead{create ? RecordKind::Create : RecordKind::Destroy, e.dimension, mesh.shape(e),
                              fresh, static_cast<std::uint32_t>(vertices.size())}
                       .packed());
  words_.push_back(e.index);
  words_.push_back(mesh.classification(e).bits());
  if (e.dimension == 0)
    push_position(mesh.position(Vertex(e.index)));
  else
    words_.insert(words_.end(), vertices.begin(), vertices.end());
  close_record();
}

void Journal::record_rebind(std::span<const Rebinding> items) {
  open_record();
  words_.push_back(
      RecordHead{RecordKind::Rebind, 0, Shape::Point, false, static_cast<std::uint32_t>(items.size())}
          .packed());
  for (const Rebinding& r : items) {
    words_.push_back(std::uint32_t{r.entity.dimension} << 8 | r.slot);
    words_.push_back(r.entity.index);
    words_.push_back(r.from.index);
    words_.push_back(r.to.index);
  }
  close_record();
}

void Journal::record_move(Vertex v, const glm::dvec3& from, const glm::dvec3& to) {
  open_record();
  words_.push_back(RecordHead{RecordKind::Move, 0, Shape::Point, false, 1}.packed());
  words_.push_back(v.index);
  push_position(from);
  push_position(to);
  close_record();
}

void Journal::record_classify(EntityRef e, ModelRef from, ModelRef to) {
  open_record();
  words_.push_back(RecordHead{RecordKind::Classify, e.dimension, Shape::Point, false, 1}.packed());
  words_.push_back(e.index);
  words_.push_back(from.bits());
  words_.push_back(to.bits());
  close_record();
}

void Journal::apply_entity(Mesh& mesh, std::uint64_t at, bool create) const {
  const RecordHead head = RecordHead::unpack(words_[at]);
  const std::uint32_t id = words_[at + 1];
  IdPool& ids = mesh.level(head.dim).ids;
  const bool recorded_create = head.kind == RecordKind::Create;
  std::size_t& creations = mesh.recorded_creations_[static_cast<std::size_t>(head.dim)];
  if (!create) {
    mesh.detach_entity(head.dim, id);
    if (recorded_create) mesh.attached_.uncover(head.dim, id, --creations);
    if (recorded_create)
      ids.undo_create(id, head.fresh);
    else
      ids.destroy(id);
    if (recorded_create && head.fresh) mesh.grow_level(head.dim);
    return;
  }
  if (recorded_create) {
    const auto again = ids.create();
    AOMD_CHECK(again.id == id && again.fresh == head.fresh);
  } else {
    ids.undo_destroy(id);
  }
  if (mesh.level(head.dim).classes.size() < ids.capacity()) mesh.grow_level(head.dim);
  const ModelRef model = ModelRef::from_bits(words_[at + 2]);
  if (head.dim == 0)
    mesh.attach_vertex(id, read_position(at + 3), model);
  else
    mesh.attach_entity(head.dim, id, head.shape, std::span(words_).subspan(at + 3, head.count), model);
  if (recorded_create) mesh.attached_.cover_again(head.dim, id, creations++);
}

void Journal::apply(Mesh& mesh, std::uint64_t at, bool forward) {
  const RecordHead head = RecordHead::unpack(words_[at]);
  const std::uint32_t id = words_[at + 1];
  switch (head.kind) {
    case RecordKind::Create:
      return apply_entity(mesh, at, forward);
    case RecordKind::Destroy:
      return apply_entity(mesh, at, !forward);
    case RecordKind::Move:
      mesh.positions_[id] = read_position(forward ? at + 8 : at + 2);
      return;
    case RecordKind::Classify:
      mesh.classify(head.dim, id, ModelRef::from_bits(words_[forward ? at + 3 : at + 2]));
      return;
    case RecordKind::Rebind:
      break;
  }
  rebindings_.resize(head.count);
  for (std::uint32_t i = 0; i < head.count; ++i) {
    const std::uint32_t* w = words_.data() + at + 1 + 4 * std::size_t{i};
    const Vertex from(w[2]), to(w[3]);
    rebindings_[i] = {EntityRef(static_cast<int>(w[0] >> 8), w[1]), w[0] & 255u, forward ? from : to,
                      forward ? to : from};
  }
  mesh.apply_rebindings(rebindings_);
}

bool Journal::undo(Mesh& mesh) {
  AOMD_CHECK(!in_step_);
  if (cursor_ == 0) return false;
  --cursor_;
  places_.clear();
  for (std::uint64_t at = steps_[cursor_].begin; at < step_end(cursor_);
       at += RecordHead::unpack(words_[at]).length())
    places_.push_back(at);
  for (auto it = places_.rbegin(); it != places_.rend(); ++it) apply(mesh, *it, false);
  return true;
}

bool Journal::redo(Mesh& mesh) {
  AOMD_CHECK(!in_step_);
  if (cursor_ == steps_.size()) return false;
  for (std::uint64_t at = steps_[cursor_].begin; at < step_end(cursor_);
       at += RecordHead::unpack(words_[at]).length())
    apply(mesh, at, true);
  ++cursor_;
  return true;
}

bool Journal::is_far(const Mesh& mesh, std::size_t step) const {
  const auto [first, last] = std::minmax(cursor_, step);
  const std::size_t entities = std::size_t{mesh.count(0)} + mesh.count(1) + mesh.count(2) + mesh.count(3);
  return words_of(first, last) > far_words_per_entity * entities;
}

void Journal::seek(Mesh& mesh, std::size_t step) {
  step = std::min(step, steps_.size());
  if (is_far(mesh, step)) return seek_far(mesh, step);
  while (cursor_ > step) undo(mesh);
  while (cursor_ < step) redo(mesh);
}

void Journal::seek_far(Mesh& mesh, std::size_t step) {
  const Mesh::Derived derived = mesh.release_derived();
  while (cursor_ > step) {
    if (cursor_ > step + steps_ahead) fetch(mesh, cursor_ - 1 - steps_ahead);
    undo(mesh);
  }
  while (cursor_ < step) {
    if (cursor_ + steps_ahead < step) fetch(mesh, cursor_ + steps_ahead);
    redo(mesh);
  }
  mesh.build_again(derived);
}

/// Asks for the memory that a step will touch: on a large mesh waiting for it is most of the work.
void Journal::fetch(const Mesh& mesh, std::size_t step) const {
  const auto row = [&](int dim, std::uint32_t id) {
    if (id >= mesh.capacity(dim)) return;
    prefetch(dim == 0 ? static_cast<const void*>(&mesh.positions_[id])
                      : mesh.representation_.down(dim, 0).row(id));
  };
  for (std::uint64_t at = steps_[step].begin; at < step_end(step);) {
    const RecordHead head = RecordHead::unpack(words_[at]);
    const std::uint32_t* w = words_.data() + at + 1;
    if (head.kind == RecordKind::Rebind) {
      for (std::uint32_t i = 0; i < head.count; ++i) row(static_cast<int>(w[4 * i] >> 8), w[4 * i + 1]);
    } else {
      row(head.dim, w[0]);
      if (w[0] < mesh.capacity(head.dim)) prefetch(&mesh.level(head.dim).classes[w[0]]);
    }
    at += head.length();
  }
}

void Journal::clear() {
  words_.clear();
  steps_.clear();
  cut_.reset();
  cursor_ = 0;
  ++epoch_;
}

void Journal::restore(std::vector<std::uint32_t> words, std::vector<JournalStep> steps) {
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::uint64_t end = i + 1 < steps.size() ? steps[i + 1].begin : words.size();
    if (steps[i].begin != at || end > words.size()) throw std::runtime_error("journal: step out of order");
    while (at < end) {
      const RecordHead head = RecordHead::unpack(words[at]);
      if (head.kind > RecordKind::Classify || at + head.length() > end)
        throw std::runtime_error("journal: bad record");
      at += head.length();
    }
  }
  if (at != words.size()) throw std::runtime_error("journal: records without a step");
  words_ = std::move(words);
  steps_ = std::move(steps);
  cursor_ = 0;
  ++epoch_;
}

}  // namespace aomd
