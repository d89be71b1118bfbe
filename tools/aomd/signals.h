#pragma once
// How the program ends where it is not by itself: signals from outside, and faults of its own.

#include <string>

namespace aomd::cli {

/// From now on Ctrl-C, SIGTERM and SIGHUP end the program at once, whatever it is doing, with code
/// 128 + the signal's number; no temporary file stays, and outputs are as they were or complete.
/// nohup is respected. A reader of standard output that goes away and a file that reaches the limit
/// of the process are errors of writing, not the end. To be called before any thread is started.
void end_on_signals();

/// The next of them ends nothing: its number can be read, as one byte, from the descriptor that
/// this returns. For who has to end other processes first, which write all outputs. One more ends
/// the program at once, and these then notice.
[[nodiscard]] int signals_from_here_on();

/// From now on failed assertions and exceptions that nothing catches end with one line and the code
/// of internal faults, not with a signal.
void name_internal_faults();

/// Writes one line to standard error, over what a line of progress left there, whatever other
/// threads do.
void say(const std::string& line);

/// "internal fault: WHAT; please report it with the input and the command line".
[[nodiscard]] std::string fault_words(const std::string& what);

}  // namespace aomd::cli
