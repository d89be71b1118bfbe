#pragma once
// What is said of a suite that was run.

#include <string>
#include <vector>

#include "viewer/suite/case_result.h"

namespace aomd::suite {

/// A case of a suite, and what became of it.
struct Finished {
  const Case* what = nullptr;
  CaseResult result;
};

/// For a terminal: a line a case, and a last one with how many there are of each outcome.
[[nodiscard]] std::string report_table(const std::vector<Finished>& finished);

/// "3 cases: 2 same, 1 differs"
[[nodiscard]] std::string report_summary(const std::vector<Finished>& finished);

/// JUnit XML, as GitLab, Jenkins and GitHub's actions read it: a picture that differs and an
/// expectation that is missed are failures, all else that is wrong is an error.
[[nodiscard]] std::string report_junit(const Suite& suite, const std::vector<Finished>& finished);

/// A page that works from a file alone: baseline, result and difference of each case, side by side,
/// under a slider or blinking, the worst first, with a choice of outcomes and names.
[[nodiscard]] std::string report_page(const Suite& suite, const std::vector<Finished>& finished);

}  // namespace aomd::suite
