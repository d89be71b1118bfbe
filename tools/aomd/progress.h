#pragma once
// One line on a terminal that says how far a long work is.

#include <string_view>

namespace aomd::cli {

/// Shows phases and percentages on standard error where that is a terminal; the line is wiped at
/// the end.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  [[nodiscard]] bool shown() const { return shown_; }
  /// `done` in [0,1].
  void show(std::string_view phase, double done);
  void show(std::string_view phase);
  void wipe();

 private:
  bool shown_;
  bool dirty_ = false;
};

}  // namespace aomd::cli
