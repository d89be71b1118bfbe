#pragma once
// Text that is copied and pasted.

#include <functional>
#include <string>
#include <utility>

namespace aomd::scene {

/// The system's clipboard where a window gives the two functions; without one a string that the
/// session keeps, so that scripts can copy and paste too.
class Clipboard {
 public:
  std::function<std::string()> read_system;
  std::function<void(const std::string&)> write_system;

  void set(std::string text) {
    if (write_system) write_system(text);
    text_ = std::move(text);
  }
  [[nodiscard]] std::string get() const { return read_system ? read_system() : text_; }

 private:
  std::string text_;
};

}  // namespace aomd::scene
