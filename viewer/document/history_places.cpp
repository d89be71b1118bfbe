#include "viewer/document/history_places.h"

#include <algorithm>

#include "viewer/base/text.h"

namespace aomd::scene {

std::size_t next_command(const Document& document) {
  const auto& marks = document.marks();
  const auto next =
      std::upper_bound(marks.begin(), marks.end(), document.journal().cursor(),
                       [](std::size_t at, const HistoryMark& m) { return at < m.begin; });
  return next == marks.end() ? document.journal().size() : next->begin;
}

std::size_t previous_command(const Document& document) {
  const auto& marks = document.marks();
  const auto next =
      std::lower_bound(marks.begin(), marks.end(), document.journal().cursor(),
                       [](const HistoryMark& m, std::size_t at) { return m.begin < at; });
  return next == marks.begin() ? 0 : (next - 1)->begin;
}

std::size_t next_phase(const Document& document) {
  const Journal& journal = document.journal();
  const std::size_t end = next_command(document);
  std::size_t at = journal.cursor();
  if (at == end) return end;
  const StepKind kind = journal.step(at).kind;
  while (at < end && journal.step(at).kind == kind) ++at;
  return at;
}

std::size_t previous_phase(const Document& document) {
  const Journal& journal = document.journal();
  const std::size_t begin = previous_command(document);
  std::size_t at = journal.cursor();
  if (at == begin) return begin;
  const StepKind kind = journal.step(at - 1).kind;
  while (at > begin && journal.step(at - 1).kind == kind) --at;
  return at;
}

std::string place_words(const Journal& journal) {
  return "operation " + grouped(journal.cursor()) + " of " + grouped(journal.size());
}

}  // namespace aomd::scene
