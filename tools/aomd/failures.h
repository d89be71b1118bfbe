#pragma once
// What fails, as exit codes.

#include <functional>
#include <string>

#include "tools/aomd/command.h"

namespace aomd::cli {

/// Runs an action and returns its exit code. What it throws is told in words, with the code that
/// stands for its kind, which is then returned.
int run_caught(const Action& action,
               const std::function<void(const std::string& words, int code)>& tell);

}  // namespace aomd::cli
