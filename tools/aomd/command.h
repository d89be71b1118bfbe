#pragma once
// What the commands of the program `aomd` share.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/io/io.h"

namespace aomd {
class Exchange;
}

namespace aomd::cli {

/// Exit codes, as scripts rely on them.
enum ExitCode : int {
  done = 0,
  says_no = 1,
  wrong_usage = 2,
  bad_input = 3,
  not_written = 4,
  out_of_limits = 5,
  internal_fault = 70,
  signalled = 128,  ///< and the number of the signal: 130 for Ctrl-C
};

/// What parsing chose to run; returns an exit code and may throw anything: see main.cpp.
using Action = std::function<int()>;

/// Values that parse but make no sense: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// There is nothing that the command could do: exit code 1.
struct NothingToDo : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// This program contradicts itself: exit code 70.
struct InternalFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each adds one command with its options to the program; when the command line names it, `action`
/// is set.
void add_info(CLI::App& app, Action& action);
void add_decimate(CLI::App& app, Action& action);
/// The same for processes that share the blocks of an input; the first one does all the rest.
void add_shared_decimate(CLI::App& app, Action& action, Exchange& exchange);
void add_check(CLI::App& app, Action& action);
void add_classify(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_repair(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_sample(CLI::App& app, Action& action);
void add_image_diff(CLI::App& app, Action& action);

/// Prints what a reader or a writer has to say, one line each, on standard error.
void print_notes(const std::string& file, const std::vector<std::string>& notes);

/// Reads a mesh; "-" stands for standard input, and a pipe is read to its end.
[[nodiscard]] io::ReadResult read_input(const std::string& file);

/// Reads a mesh as read_input() does; what the reader had to do goes to standard error as notes
/// unless `quiet`.
[[nodiscard]] io::ReadResult read_mesh(const std::string& file, bool quiet = false);

/// Adds --threads N: 0, the default, stands for all cores.
CLI::Option* add_threads(CLI::App& command, int& threads);

}  // namespace aomd::cli
