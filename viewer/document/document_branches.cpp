// Other ways on from places of the history, and named places.

#include <algorithm>
#include <utility>

#include "viewer/document/document.h"

namespace aomd::scene {

/// What the open command, or the one that just ended, has cut off where it began becomes a branch.
void Document::keep_cut() {
  auto part = loaded_->journal.take_cut();
  if (!part) return;
  tree_.keep(mark_begin_, std::move(*part), std::move(undone_marks_));
  undone_marks_.clear();
}

void Document::exchange(unsigned id) {
  const auto classifies = [](const HistoryMark& m) { return changes_classes(m.label); };
  const HistoryBranch& branch = *tree_.find(id);
  const std::size_t fork = branch.fork;
  // Two classifications may end at the same step of two branches.
  const bool other = std::any_of(marks_.begin(), marks_.end(), classifies) ||
                     std::any_of(branch.marks.begin(), branch.marks.end(), classifies);
  move_to(fork, false);
  tree_.exchange(id, loaded_->journal, marks_);
  last_cut_ = mark_begin_ = fork;
  epoch_at_mark_ = journal().epoch();
  if (other) forget_fits();
}

bool Document::switch_branch(unsigned id) {
  if (!loaded_ || tree_.find(id) == nullptr) return loaded_ && id == tree_.present();
  cancel_run();
  for (const unsigned each : tree_.way_to(id)) exchange(each);
  move_to(journal().size(), false);
  return true;
}

bool Document::go_to_bookmark(const std::string& name) {
  const Bookmark* found = tree_.find_bookmark(name);
  if (found == nullptr) return false;
  go_to({found->branch, found->step}, true);
  return true;
}

bool Document::go_to_place(unsigned number) {
  const TreePlace* found = tree_.find_place(number);
  if (found == nullptr) return false;
  go_to(*found, false);
  return true;
}

void Document::go_to(TreePlace place, bool single) {
  if (place.branch != 0) {
    cancel_run();
    for (const unsigned each : tree_.way_to(place.branch)) exchange(each);
  }
  move_to(place.step, single);
}

}  // namespace aomd::scene
