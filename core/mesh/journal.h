#pragma once
// Every edit, recorded: undo, stepping, replay and partial redraws are the same record read in
// different directions.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/handle.h"
#include "core/mesh/journal_record.h"
#include "core/mesh/mesh.h"

#pragma GCC visibility push(default)

namespace aomd {

class JournalReplay;

/// What a step was for. Edit: elementary edits made outside any operator.
enum class StepKind : std::uint8_t { Edit, Collapse, Swap, Smooth, Classify };

[[nodiscard]] const char* step_name(StepKind kind);

/// One undoable step: a kind, the entity that it was about, and where its records begin.
struct JournalStep {
  StepKind kind = StepKind::Edit;
  EntityRef entity;
  std::uint64_t begin = 0;  ///< in words
};

/// Steps that follow some place of a history, outside of it. They fit behind that place alone.
struct JournalPart {
  std::vector<std::uint32_t> words;
  std::vector<JournalStep> steps;  ///< the first one begins at word 0
  [[nodiscard]] std::size_t bytes() const {
    return words.size() * 4 + steps.size() * sizeof(JournalStep);
  }
};

/// A linear history of one mesh. Edits made after an undo cut off what had been undone. Undo and
/// redo restore ids, id stack, connectivity, positions and classification exactly; cost O(records
/// of the step). Attach it when the levels that T asks for exist: edges that a later change of T
/// creates are not recorded. Records name entities by vertices only, so a history replays under any
/// representation that has the same levels.
class Journal {
 public:
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  /// Steps [0, cursor) are applied.
  [[nodiscard]] std::size_t cursor() const { return cursor_; }
  [[nodiscard]] const JournalStep& step(std::size_t i) const { return steps_[i]; }
  /// What step i did, record by record (journal_record.h).
  [[nodiscard]] std::span<const std::uint32_t> records(std::size_t i) const {
    return std::span(words_).subspan(steps_[i].begin, step_end(i) - steps_[i].begin);
  }
  /// How much steps [first, last) recorded, in words of 4 bytes. O(1).
  [[nodiscard]] std::size_t words_of(std::size_t first, std::size_t last) const {
    return first < last ? step_end(last - 1) - steps_[first].begin : 0;
  }
  [[nodiscard]] std::size_t bytes() const {
    return words_.capacity() * 4 + steps_.capacity() * sizeof(JournalStep);
  }
  /// How many entities of each level the steps that are applied created. O(records).
  [[nodiscard]] std::array<std::size_t, 4> applied_creations() const;
  /// Changes whenever a history is cut or cleared, so that readers of cursors know to start afresh.
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }

  /// Collects the edits that follow into one step, until end_step; steps do not nest. A step
  /// without edits leaves no trace, not even on what could be redone.
  void begin_step(StepKind kind, EntityRef entity);
  void end_step();

  /// Each returns false at its end of the history.
  bool undo(Mesh& mesh);
  bool redo(Mesh& mesh);
  /// Undoes or redoes until `step` steps are applied (clamped to the history). O(records in
  /// between); far away, only what defines the entities follows each record, on two threads where T
  /// allows it, and what T stores besides is built anew at the end, O(size).
  void seek(Mesh& mesh, std::size_t step);
  void clear();

  /// Whether the last part that new edits cut off is kept, for take_cut(); else it is gone.
  void keep_cut(bool on) { keeps_cut_ = on; }
  [[nodiscard]] std::optional<JournalPart> take_cut() { return std::exchange(cut_, std::nullopt); }
  /// Puts other steps behind the cursor and returns those that were there. The part must have been
  /// recorded from the present state of the mesh. O(both).
  JournalPart exchange_future(const JournalPart& part);

  /// Calls visit(EntityRef) for every entity that steps [first, last) created, deleted, rebound,
  /// moved or classified; some more than once. O(records).
  template <typename Visit>
  void touched(std::size_t first, std::size_t last, Visit&& visit) const;

  /// The raw history, for writing it to a file and reading it back (core/io/journal_file).
  [[nodiscard]] std::span<const std::uint32_t> words() const { return words_; }
  [[nodiscard]] std::span<const JournalStep> steps() const { return steps_; }
  /// Takes over a history read from a file, nothing of it applied yet. Throws std::runtime_error
  /// when a record is malformed. Whether it fits a mesh shows only when it is applied.
  void restore(std::vector<std::uint32_t> words, std::vector<JournalStep> steps);

 private:
  friend class Mesh;
  // Called by Mesh, after an edit was made (destroy: before)
  void record_entity(bool create, const Mesh& mesh, EntityRef e, bool fresh);
  void record_rebind(std::span<const Rebinding> items);
  void record_move(Vertex v, const glm::dvec3& from, const glm::dvec3& to);
  void record_classify(EntityRef e, ModelRef from, ModelRef to);

  void open_record();
  void cut_future();
  [[nodiscard]] JournalPart future() const;
  void drop_future();
  void close_record();
  void push_position(const glm::dvec3& p);
  [[nodiscard]] std::uint64_t step_end(std::size_t i) const {
    return i + 1 < steps_.size() ? steps_[i + 1].begin : words_.size();
  }
  [[nodiscard]] bool is_far(const Mesh& mesh, std::size_t step) const;
  void walk(JournalReplay replay, std::size_t step) const;

  std::vector<std::uint32_t> words_;
  std::vector<JournalStep> steps_;
  std::size_t cursor_ = 0;
  std::uint64_t epoch_ = 0;
  std::optional<JournalStep> pending_;  ///< begun, nothing recorded yet
  std::optional<JournalPart> cut_;
  bool keeps_cut_ = false;
  bool in_step_ = false;
  bool implicit_step_ = false;
};

template <typename Visit>
void Journal::touched(std::size_t first, std::size_t last, Visit&& visit) const {
  if (first >= last) return;
  const std::uint64_t end = step_end(last - 1);
  for (std::uint64_t at = steps_[first].begin; at < end;) {
    const RecordHead head = RecordHead::unpack(words_[at]);
    if (head.kind == RecordKind::Rebind) {
      for (std::size_t i = 0; i < head.count; ++i)
        visit(EntityRef(static_cast<int>(words_[at + 1 + 4 * i] >> 8), words_[at + 2 + 4 * i]));
    } else {
      visit(EntityRef(head.dim, words_[at + 1]));
    }
    at += head.length();
  }
}

}  // namespace aomd

#pragma GCC visibility pop
