#pragma once
// A program that a test starts, and that does not outlive it.

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace aomd::test {

class Child {
 public:
  /// Starts `words[0]`, looked for in PATH, with "NAME=value" added to the environment; both
  /// outputs go to `output`. `inherited` stays open in it. A program that cannot be started ends
  /// with 127.
  Child(const std::vector<std::string>& words, const std::vector<std::string>& environment,
        const std::filesystem::path& output, int inherited = -1);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Kills it.
  ~Child();

  [[nodiscard]] bool running();
  /// Its exit code, or minus the number of the signal that ended it; nothing while it runs.
  [[nodiscard]] std::optional<int> result();
  /// Looks every few milliseconds until a condition holds. False where it ends before, or after two
  /// minutes.
  [[nodiscard]] bool waits_for(const std::function<bool()>& condition);
  /// Waits for its end and returns what result() does then.
  int wait();
  void send_signal(int number) const;
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
  std::optional<int> result_;
};

}  // namespace aomd::test
