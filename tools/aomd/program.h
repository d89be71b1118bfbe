#pragma once
// A program of commands: reads the command line, runs one of them, and turns failures into exit
// codes.

#include <functional>
#include <vector>

#include "tools/aomd/command.h"

namespace aomd::cli {

/// Adds one command, as those of command.h do.
using AddCommand = std::function<void(CLI::App&, Action&)>;

/// The exit code of a whole program. `name` stands in its help, not in messages, which begin with
/// "aomd:" always.
[[nodiscard]] int run_program(const char* name, const std::vector<AddCommand>& commands, int argc,
                              char** argv);

}  // namespace aomd::cli
