#pragma once
// The command line of `aomd-view test`.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aomd::app {

struct TestOptions {
  std::filesystem::path suite;
  std::size_t jobs = 1;
  bool update = false;
  std::vector<std::string> names;  ///< of the cases that are carried out; empty: all
  std::filesystem::path junit;     ///< files that are written; empty: none
  std::filesystem::path html;
  std::filesystem::path results;  ///< a folder for pictures; empty: none
};

/// `argv[0]` is "test". None: the program ends with the code (--help, wrong usage: the message is
/// printed).
[[nodiscard]] std::optional<TestOptions> parse_test_options(int argc, char** argv, int& exit_code);

}  // namespace aomd::app
