#pragma once
// What is not on the way from the start of a history to its present end: branches, and named
// places.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/decimate/options.h"
#include "core/mesh/journal.h"

namespace aomd::scene {

/// What a sweep had counted when `end` steps were applied: at its end, or where its command
/// stopped.
struct SweepMark {
  std::size_t end = 0;
  SweepStatistics statistics;
};

/// The steps that one user-visible command made: from `begin` to the next mark, or to the end.
struct HistoryMark {
  std::size_t begin = 0;
  std::string label;  ///< "sweep"
  std::vector<SweepMark> sweeps =
      {};                 ///< the last first; what lies beyond the next mark is another branch's
  std::string stop = {};  ///< why the run stopped; empty where it did not go to its end
  std::size_t stopped_at = 0;  ///< where that was
};

/// Steps that were ahead where something new was done. Branches keep their number while they are
/// the present one; `from` is the branch that it leaves, 0 for the present one.
struct HistoryBranch {
  unsigned id = 0;
  unsigned from = 0;
  std::size_t fork = 0;  ///< steps that both have in common
  JournalPart part;
  std::vector<HistoryMark> marks;  ///< of commands that begin at `fork` or behind
  [[nodiscard]] std::size_t size() const { return fork + part.steps.size(); }
};

/// A place with a name, where `step` steps are applied: on a branch, or (0) on the present one.
struct Bookmark {
  std::string name;
  unsigned branch = 0;
  std::size_t step = 0;
};

/// Where `step` steps are applied: on a branch, or (0) on the present one.
struct TreePlace {
  unsigned branch = 0;
  std::size_t step = 0;
};

/// Every branch goes on beyond each place where another one leaves it. Places before a fork belong
/// to the branch that is left.
class HistoryTree {
 public:
  /// All branches together; the oldest that no other leaves is forgotten first. One is always kept.
  static constexpr std::size_t most_bytes = 512'000'000;

  void clear();
  /// The number of the present branch.
  [[nodiscard]] unsigned present() const { return present_; }
  /// All others, the oldest first.
  [[nodiscard]] const std::vector<HistoryBranch>& branches() const { return branches_; }
  [[nodiscard]] const HistoryBranch* find(unsigned id) const;
  [[nodiscard]] std::size_t bytes() const;
  /// Something new was done after `fork` steps: what was ahead becomes a branch, and the present
  /// one gets another number. O(branches + bookmarks).
  void keep(std::size_t fork, JournalPart part, std::vector<HistoryMark> marks);
  /// The branches to exchange one after the other on the way to one.
  [[nodiscard]] std::vector<unsigned> way_to(unsigned id) const;
  /// A branch that leaves the present one, where the journal stands, becomes the present one. O(its
  /// steps + those ahead).
  void exchange(unsigned id, Journal& journal, std::vector<HistoryMark>& marks);
  /// With those that leave it, and the bookmarks on them; returns how many branches there were.
  std::size_t remove(unsigned id);

  [[nodiscard]] const std::vector<Bookmark>& bookmarks() const { return bookmarks_; }
  [[nodiscard]] const Bookmark* find_bookmark(const std::string& name) const;
  void set_bookmark(const std::string& name, std::size_t step);
  bool remove_bookmark(const std::string& name);
  /// Changes whenever a bookmark does.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  // Places under a number, for what is kept about them elsewhere: without a name, and gone with
  // their branch.
  void set_place(unsigned number, std::size_t step) { places_[number] = {0, step}; }
  void forget_place(unsigned number) { places_.erase(number); }
  [[nodiscard]] const TreePlace* find_place(unsigned number) const;

  /// The place that was saved last, which goes with its branch.
  void set_saved(std::size_t step) { saved_ = TreePlace{0, step}; }
  [[nodiscard]] bool saved_at(std::size_t step) const {
    return saved_ && saved_->branch == 0 && saved_->step == step;
  }

 private:
  void leave_present(std::size_t fork, unsigned id);
  void arrive(unsigned id);
  void bound();

  std::vector<HistoryBranch> branches_;
  std::vector<Bookmark> bookmarks_;
  std::map<unsigned, TreePlace> places_;
  std::optional<TreePlace> saved_;
  unsigned present_ = 1;
  unsigned last_id_ = 1;
  std::uint64_t version_ = 0;
};

}  // namespace aomd::scene
