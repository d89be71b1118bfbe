#pragma once
// What a Python program hears of a work that goes on, and how it ends it.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/aomd/in_memory.h"
#include "tools/python/binding.h"

namespace aomd::python {

/// A progress function returned False.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled; nothing was written") {}
};

/// Passes phases on to a function of Python, or None, and looks for Ctrl-C. To be made with the
/// lock of the interpreter; told things without it.
class Listening {
 public:
  explicit Listening(py::object progress) : progress_(std::move(progress)) {}

  /// Throws Cancelled, or what the function or a signal raised.
  void tell(std::string_view phase, std::optional<double> done);
  [[nodiscard]] cli::Listener listener();
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  py::object progress_;
  std::vector<std::string> notes_;
};

}  // namespace aomd::python
