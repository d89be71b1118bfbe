#include "viewer/document/history_tree.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/assertion.h"

namespace aomd::scene {

void HistoryTree::clear() {
  const std::uint64_t version = version_ + 1;
  *this = {};
  version_ = version;
}

const HistoryBranch* HistoryTree::find(unsigned id) const {
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const HistoryBranch& b) { return b.id == id; });
  return found == branches_.end() ? nullptr : &*found;
}

std::size_t HistoryTree::bytes() const {
  std::size_t sum = 0;
  for (const HistoryBranch& b : branches_) sum += b.part.bytes();
  return sum;
}

/// What lies on the present branch beyond a fork goes with it when it becomes branch `id`.
void HistoryTree::leave_present(std::size_t fork, unsigned id) {
  for (HistoryBranch& b : branches_)
    if (b.from == 0 && b.fork > fork) b.from = id;
  for (Bookmark& b : bookmarks_)
    if (b.branch == 0 && b.step > fork) b.branch = id;
  for (auto& [number, place] : places_)
    if (place.branch == 0 && place.step > fork) place.branch = id;
  if (saved_ && saved_->branch == 0 && saved_->step > fork) saved_->branch = id;
}

void HistoryTree::arrive(unsigned id) {
  for (HistoryBranch& b : branches_)
    if (b.from == id) b.from = 0;
  for (Bookmark& b : bookmarks_)
    if (b.branch == id) b.branch = 0;
  for (auto& [number, place] : places_)
    if (place.branch == id) place.branch = 0;
  if (saved_ && saved_->branch == id) saved_->branch = 0;
}

void HistoryTree::keep(std::size_t fork, JournalPart part, std::vector<HistoryMark> marks) {
  leave_present(fork, present_);
  branches_.push_back({present_, 0, fork, std::move(part), std::move(marks)});
  present_ = ++last_id_;
  bound();
}

void HistoryTree::bound() {
  while (branches_.size() > 1 && bytes() > most_bytes) {
    const auto left = [&](const HistoryBranch& b) {
      return std::none_of(branches_.begin(), branches_.end(),
                          [&](const HistoryBranch& other) { return other.from == b.id; });
    };
    const auto oldest = std::find_if(branches_.begin(), branches_.end() - 1, left);
    remove((oldest == branches_.end() - 1 ? branches_.front() : *oldest).id);
  }
}

std::vector<unsigned> HistoryTree::way_to(unsigned id) const {
  std::vector<unsigned> way;
  for (const HistoryBranch* b = find(id); b != nullptr; b = find(b->from)) way.push_back(b->id);
  std::reverse(way.begin(), way.end());
  return way;
}

void HistoryTree::exchange(unsigned id, Journal& journal, std::vector<HistoryMark>& marks) {
  const auto at = std::find_if(branches_.begin(), branches_.end(),
                               [&](const HistoryBranch& b) { return b.id == id; });
  AOMD_CHECK(at != branches_.end() && at->from == 0 && at->fork == journal.cursor());
  HistoryBranch next = std::move(*at);
  branches_.erase(at);
  leave_present(next.fork, present_);
  arrive(id);
  HistoryBranch old{present_, 0, next.fork, journal.exchange_future(next.part), {}};
  const auto ahead = std::find_if(marks.begin(), marks.end(),
                                  [&](const HistoryMark& m) { return m.begin >= next.fork; });
  old.marks.assign(std::make_move_iterator(ahead), std::make_move_iterator(marks.end()));
  marks.erase(ahead, marks.end());
  marks.insert(marks.end(), std::make_move_iterator(next.marks.begin()),
               std::make_move_iterator(next.marks.end()));
  present_ = id;
  branches_.insert(std::upper_bound(branches_.begin(), branches_.end(), old.id,
                                    [](unsigned i, const HistoryBranch& b) { return i < b.id; }),
                   std::move(old));
}

std::size_t HistoryTree::remove(unsigned id) {
  if (find(id) == nullptr) return 0;
  std::size_t removed = 1;
  std::erase_if(branches_, [&](const HistoryBranch& b) { return b.id == id; });
  if (std::erase_if(bookmarks_, [&](const Bookmark& b) { return b.branch == id; }) > 0) ++version_;
  std::erase_if(places_, [&](const auto& each) { return each.second.branch == id; });
  if (saved_ && saved_->branch == id) saved_.reset();
  std::vector<unsigned> leaving;
  for (const HistoryBranch& b : branches_)
    if (b.from == id) leaving.push_back(b.id);
  for (const unsigned each : leaving) removed += remove(each);
  return removed;
}

const Bookmark* HistoryTree::find_bookmark(const std::string& name) const {
  const auto found = std::find_if(bookmarks_.begin(), bookmarks_.end(),
                                  [&](const Bookmark& b) { return b.name == name; });
  return found == bookmarks_.end() ? nullptr : &*found;
}

const TreePlace* HistoryTree::find_place(unsigned number) const {
  const auto found = places_.find(number);
  return found == places_.end() ? nullptr : &found->second;
}

void HistoryTree::set_bookmark(const std::string& name, std::size_t step) {
  remove_bookmark(name);
  bookmarks_.push_back({name, 0, step});
  ++version_;
}

bool HistoryTree::remove_bookmark(const std::string& name) {
  const bool removed =
      std::erase_if(bookmarks_, [&](const Bookmark& b) { return b.name == name; }) > 0;
  if (removed) ++version_;
  return removed;
}

}  // namespace aomd::scene
