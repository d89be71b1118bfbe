#pragma once
// `aomd-view test`: the pictures of a suite against their baselines.

namespace aomd::app {

/// `argv[0]` is "test". Returns what the program ends with; throws what it cannot begin without.
int test_command(int argc, char** argv);

}  // namespace aomd::app
