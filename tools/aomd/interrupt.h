#pragma once
// Ctrl-C: work stops between two operations instead of in the middle of one.

namespace aomd::cli {

/// From now on the first Ctrl-C only sets a flag; a second one ends the program at once.
void catch_interrupts();

[[nodiscard]] bool interrupted();

/// Throws Cancelled when Ctrl-C was pressed: called between two stages of work and before anything
/// is written.
void stop_if_interrupted();

}  // namespace aomd::cli
