#include "tools/aomd/signals.h"

#include <pthread.h>
#include <unistd.h>

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

/// Straight to the descriptor: another thread may be within std::cerr.
void say(const std::string& line) {
  const std::string text = (::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + line + '\n';
  static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
}

/// A thread of its own waits for the signals, so that their end needs no care for what a handler
/// may do, and no stage of the work has to ask.
[[noreturn]] void wait_for(const sigset_t& signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
  const bool written = io::abandon_outputs();
  say(std::string("aomd: cancelled; ") +
      (written ? "the output had been written" : "nothing was written"));
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

void name_internal_faults() {
  std::signal(SIGABRT, [](int) { ::_exit(internal_fault); });
  std::set_terminate([] {
    say("aomd: " + printable(fault_words(what_of(std::current_exception()))));
    ::_exit(internal_fault);
  });
}

std::string fault_words(const std::string& what) {
  return "internal fault: " + what + "; please report it with the input and the command line";
}

}  // namespace aomd::cli
