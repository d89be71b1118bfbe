// The table on the terminal.

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "viewer/base/text.h"
#include "viewer/suite/report.h"

namespace aomd::suite {
namespace {

using Row = std::array<std::string, 6>;

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

Row row_of(const Finished& each) {
  const CaseResult& result = each.result;
  Row row{each.what->name,
          std::string(outcome_word(result.outcome)),
          "-",
          "-",
          "-",
          formatted("%.2f s", result.seconds)};
  if (result.judged.empty()) return row;
  row[2] = formatted("%.4f", result.worst_tile());
  row[3] = std::to_string(result.largest());
  row[4] = formatted("%.3f %%", 100 * result.share());
  return row;
}

/// Names and outcomes are words and stand on the left, numbers on the right.
std::string line_of(const Row& row, const std::array<std::size_t, 6>& widths) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string blanks(widths[i] - row[i].size(), ' ');
    line += (i == 0 ? "" : "  ") + (i < 2 ? row[i] + blanks : blanks + row[i]);
  }
  return line + "\n";
}

}  // namespace

std::string report_summary(const std::vector<Finished>& finished) {
  std::map<Outcome, std::size_t> counts;
  for (const Finished& each : finished) ++counts[each.result.outcome];
  std::string text = scene::counted(finished.size(), "case") + ":";
  const char* between = " ";
  for (const auto& [outcome, count] : counts) {
    text += between + scene::grouped(count) + " " + std::string(outcome_word(outcome));
    between = ", ";
  }
  return text;
}

std::string report_table(const std::vector<Finished>& finished) {
  std::vector<Row> rows = {{"case", "verdict", "worst tile", "largest", "pixels", "time"}};
  for (const Finished& each : finished) rows.push_back(row_of(each));
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const Row& row : rows) text += line_of(row, widths);
  return text + report_summary(finished) + "\n";
}

}  // namespace aomd::suite
