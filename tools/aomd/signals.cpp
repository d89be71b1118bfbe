#include "tools/aomd/signals.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <exception>
#include <string>
#include <system_error>
#include <thread>

#include "core/base/text.h"
#include "core/io/output_files.h"
#include "tools/aomd/command.h"

namespace aomd::cli {
namespace {

sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int each : {SIGINT, SIGTERM}) {
    std::signal(each, SIG_DFL);
    sigaddset(&signals, each);
  }
  struct sigaction present {};
  const bool under_nohup =
      ::sigaction(SIGHUP, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
  if (!under_nohup) sigaddset(&signals, SIGHUP);
  return signals;
}

/// Where a signal is told instead of ending the program; below 0: nowhere, or it has been.
std::atomic<int> told = -1;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
/// Outputs are matters of other processes.
std::atomic<bool> others_write =
    false;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// False where a signal has to end the program.
bool tell(int signal) {
  const int descriptor = told.exchange(-1);
  const char number = static_cast<char>(signal);
  return descriptor >= 0 && ::write(descriptor, &number, 1) == 1;
}

const char* state_of_outputs() {
  const bool written = io::abandon_outputs();
  if (others_write) return "all outputs are as they were or complete";
  return written ? "the output had been written" : "nothing was written";
}

/// A thread of its own waits for the signals, so that their end needs no care for what a handler
/// may do, and no stage of the work has to ask.
[[noreturn]] void wait_for(const sigset_t& signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0 || tell(signal)) {
  }
  say(std::string("aomd: cancelled; ") + state_of_outputs());
  ::_exit(signalled + signal);
}

std::string what_of(const std::exception_ptr& present) {
  try {
    if (present) std::rethrow_exception(present);
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "an exception of unknown kind";
  }
  return "an early end";
}

}  // namespace

void end_on_signals() {
  for (const int each : {SIGPIPE, SIGXFSZ}) std::signal(each, SIG_IGN);  // writing fails instead
  const sigset_t signals = ending_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    std::thread([signals] { wait_for(signals); }).detach();
  } catch (const std::system_error&) {  // no more threads: they end the program as they always do
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  }
}

int signals_from_here_on() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "pipe");
  others_write = true;
  told = ends[1];
  return ends[0];
}

void name_internal_faults() {
  std::signal(SIGABRT, [](int) { ::_exit(internal_fault); });
  std::set_terminate([] {
    say("aomd: " + printable(fault_words(what_of(std::current_exception()))));
    ::_exit(internal_fault);
  });
}

// Straight to the descriptor: another thread may be within std::cerr.
void say(const std::string& line) {
  const std::string text = (::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + line + '\n';
  static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
}

std::string fault_words(const std::string& what) {
  return "internal fault: " + what + "; please report it with the input and the command line";
}

}  // namespace aomd::cli
