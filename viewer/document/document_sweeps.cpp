// What sweeps counted, and why runs stopped, at each place of the history.

#include <algorithm>

#include "core/decimate/explain/stop_words.h"
#include "viewer/document/document.h"

namespace aomd::scene {
namespace {

bool counted(const SweepStatistics& s) {
  return s.collapses > 0 ||
         std::any_of(s.refused.begin(), s.refused.end(), [](std::uint32_t n) { return n > 0; });
}

std::size_t operations(const SweepStatistics& s) {
  return std::size_t{s.collapses} + s.swaps + s.smooths;
}

/// The last one that counted something; null: none.
const SweepStatistics* last_counted(const std::vector<SweepStatistics>& sweeps) {
  const auto found = std::find_if(sweeps.rbegin(), sweeps.rend(), counted);
  return found == sweeps.rend() ? nullptr : &*found;
}

}  // namespace

/// Every operation is a step, so that the sweeps lie one behind the other before the present place.
void Document::note_sweeps() {
  const auto& sweeps = loaded_->decimation->sweeps();
  HistoryMark& mark = marks_.back();
  const std::size_t begin = mark.begin;
  std::size_t end = journal().cursor();
  for (auto it = sweeps.rbegin(); it != sweeps.rend() && end > begin; ++it) {
    if (counted(*it)) mark.sweeps.push_back({end, *it});
    end -= std::min(end, operations(*it));
  }
}

/// The sweeps before the last may be those of another branch.
void Document::note_last_work() {
  const SweepStatistics& last = loaded_->decimation->sweeps().back();
  last_work_ = {place(), counted(last) ? std::optional(last) : std::nullopt, {}};
}

/// The run has gone to its end; its command is closed. One that changed nothing has left no mark.
void Document::note_stop(std::size_t made) {
  last_work_.stop =
      stop_words(loaded_->decimation->edges_left(), options(), loaded_->cells(), loaded_->volume());
  if (made == 0) return;
  marks_.back().stop = last_work_.stop;
  marks_.back().stopped_at = journal().cursor();
}

const SweepStatistics* Document::last_sweep() const {
  if (!loaded_) return nullptr;
  if (running_) return last_counted(decimation()->sweeps());
  if (last_work_.place == place() && last_work_.sweep) return &*last_work_.sweep;
  for (std::size_t bound = journal().cursor(); bound > 0;) {
    const HistoryMark& mark = mark_of(bound - 1);
    for (const SweepMark& sweep : mark.sweeps)
      if (sweep.end <= bound) return &sweep.statistics;
    bound = mark.begin;
  }
  return nullptr;
}

std::string_view Document::stop() const {
  if (!loaded_ || running_) return {};
  if (last_work_.place == place() && !last_work_.stop.empty()) return last_work_.stop;
  const std::size_t cursor = journal().cursor();
  if (cursor == 0) return {};
  const HistoryMark& mark = mark_of(cursor - 1);
  return mark.stopped_at == cursor ? std::string_view(mark.stop) : std::string_view();
}

}  // namespace aomd::scene
