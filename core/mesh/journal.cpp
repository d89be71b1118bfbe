#include "core/mesh/journal.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "core/base/assertion.h"
#include "core/base/parallel.h"
#include "core/mesh/journal_replay.h"

namespace aomd {
namespace {

/// From so many words of records for each entity on, a move through the history lets go of what can
/// be derived and builds it anew afterwards: building costs about as much as keeping relations up
/// to date for a twelfth of the entities.
constexpr std::size_t far_words_per_entity = 1;

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

void Journal::record_entity(bool create, const Mesh& mesh, EntityRef e, bool fresh) {
  open_record();
  VertexBuffer buffer;
  const auto vertices = mesh.vertices_of(e, buffer);
  words_.push_back(RecordHead{create ? RecordKind::Create : RecordKind::Destroy, e.dimension,
                              mesh.shape(e), fresh, static_cast<std::uint32_t>(vertices.size())}
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
  words_.push_back(RecordHead{RecordKind::Rebind, 0, Shape::Point, false,
                              static_cast<std::uint32_t>(items.size())}
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

std::array<std::size_t, 4> Journal::applied_creations() const {
  std::array<std::size_t, 4> creations{};
  const std::uint64_t end = cursor_ > 0 ? step_end(cursor_ - 1) : 0;
  for (std::uint64_t at = 0; at < end;) {
    const RecordHead head = RecordHead::unpack(words_[at]);
    creations[static_cast<std::size_t>(head.dim)] += head.kind == RecordKind::Create;
    at += head.length();
  }
  return creations;
}

bool Journal::undo(Mesh& mesh) {
  AOMD_CHECK(!in_step_);
  if (cursor_ == 0) return false;
  ++mesh.revision_;
  JournalReplay(mesh).undo(records(--cursor_));
  return true;
}

bool Journal::redo(Mesh& mesh) {
  AOMD_CHECK(!in_step_);
  if (cursor_ == steps_.size()) return false;
  ++mesh.revision_;
  JournalReplay(mesh).redo(records(cursor_++));
  return true;
}

bool Journal::is_far(const Mesh& mesh, std::size_t step) const {
  const auto [first, last] = std::minmax(cursor_, step);
  const std::size_t entities =
      std::size_t{mesh.count(0)} + mesh.count(1) + mesh.count(2) + mesh.count(3);
  return words_of(first, last) > far_words_per_entity * entities;
}

void Journal::seek(Mesh& mesh, std::size_t step) {
  ++mesh.revision_;
  AOMD_CHECK(!in_step_);
  step = std::min(step, steps_.size());
  const Mesh::Derived derived = is_far(mesh, step) ? mesh.release_derived() : Mesh::Derived();
  if (derived.bare)
    // No level knows of another now.
    parallel_for(2, 2, 1, [&](std::size_t begin, std::size_t end) {
      walk(JournalReplay(mesh, 2 * static_cast<int>(begin), 2 * static_cast<int>(end) - 1), step);
    });
  else
    walk(JournalReplay(mesh), step);
  cursor_ = step;
  if (derived.bare) mesh.build_again(derived);
}

void Journal::walk(JournalReplay replay, std::size_t step) const {
  for (std::size_t i = cursor_; i > step; --i) replay.undo(records(i - 1));
  for (std::size_t i = cursor_; i < step; ++i) replay.redo(records(i));
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
    if (steps[i].begin != at || end > words.size())
      throw std::runtime_error("journal: step out of order");
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
