#include "tests/support/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace aomd::test {
namespace {

[[noreturn]] void become(const std::vector<std::string>& words,
                         const std::vector<std::string>& environment,
                         const std::filesystem::path& output, int inherited) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) std::signal(each, SIG_DFL);
  const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  if (inherited >= 0) ::fcntl(inherited, F_SETFD, 0);
  for (const std::string& setting : environment) ::putenv(const_cast<char*>(setting.c_str()));
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

int code_of(int status) { return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace

Child::Child(const std::vector<std::string>& words, const std::vector<std::string>& environment,
             const std::filesystem::path& output, int inherited) {
  id_ = ::fork();
  if (id_ == 0) become(words, environment, output, inherited);
}

Child::~Child() {
  if (!running()) return;
  send_signal(SIGKILL);
  wait();
}

bool Child::running() { return !result(); }

std::optional<int> Child::result() {
  if (result_) return result_;
  int status = 0;
  if (id_ < 0)
    result_ = 127;
  else if (::waitpid(id_, &status, WNOHANG) == id_)
    result_ = code_of(status);
  return result_;
}

bool Child::waits_for(const std::function<bool()>& condition) {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + std::chrono::minutes(2); Clock::now() < end;) {
    if (condition()) return true;
    if (!running()) return condition();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

int Child::wait() {
  int status = 0;
  if (running() && ::waitpid(id_, &status, 0) == id_) result_ = code_of(status);
  return result_.value();
}

void Child::send_signal(int number) const { ::kill(id_, number); }

}  // namespace aomd::test
