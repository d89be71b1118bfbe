#pragma once
// One operator application is one journal step, when a journal is attached.

#include "core/mesh/journal.h"

namespace aomd {

/// Opens a journal step for its lifetime; does nothing on a mesh without a journal.
class JournalScope {
 public:
  JournalScope(Mesh& mesh, StepKind kind, EntityRef entity) : journal_(mesh.journal()) {
    if (journal_) journal_->begin_step(kind, entity);
  }
  ~JournalScope() {
    if (journal_) journal_->end_step();
  }
  JournalScope(const JournalScope&) = delete;
  JournalScope& operator=(const JournalScope&) = delete;

 private:
  Journal* journal_;
};

}  // namespace aomd
