#pragma once
// What the commands of the program `aomd` share.

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/io/io.h"

namespace aomd::cli {

/// Exit codes, as scripts rely on them.
enum ExitCode : int {
  done = 0,
  says_no = 1,
  wrong_usage = 2,
  bad_input = 3,
  not_written = 4,
  out_of_limits = 5,
  cancelled = 130,
};

/// What parsing chose to run; returns an exit code and may throw io::FileError, UsageError,
/// Cancelled or bad_alloc.
using Action = std::function<int()>;

/// Values that parse but make no sense: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user pressed Ctrl-C and the work stopped: exit code 130.
struct Cancelled : std::exception {};

/// Each adds one command with its options to the program; when the command line names it, `action`
/// is set.
void add_info(CLI::App& app, Action& action);
void add_decimate(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_classify(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_repair(CLI::App& app, Action& action);
void add_replay(CLI::App& app, Action& action);
void add_sample(CLI::App& app, Action& action);
void add_image_diff(CLI::App& app, Action& action);

/// Prints what a reader had to do, one line each, on standard error.
void print_notes(const std::string& file, const std::vector<std::string>& notes);

/// Reads a mesh; what the reader had to do goes to standard error as notes unless `quiet`.
[[nodiscard]] io::ReadResult read_mesh(const std::string& file, bool quiet = false);

/// Writes a mesh; what the format does not hold goes to standard error as a note unless `quiet`.
void write_mesh(const std::string& file, const MeshData& mesh, bool quiet = false,
                const io::WriteOptions& how = {});

/// The whole text as a number, or nothing.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

/// Adds --threads N: 0, the default, stands for all cores.
CLI::Option* add_threads(CLI::App& command, int& threads);

/// A validator for angles: more than 0 and less than 180 degrees.
[[nodiscard]] CLI::Validator angle_range();

}  // namespace aomd::cli
