#pragma once
// One line on a terminal that says how far a long work is.

#include <functional>
#include <string_view>
#include <utility>

namespace aomd::cli {

/// Is told the phase of a work and how far it is, in [0,1]; negative where that is not known. What
/// it throws ends the work.
using ProgressListener = std::function<void(std::string_view phase, double done)>;

/// Shows phases and percentages on standard error where that is a terminal; the line is wiped at
/// the end. Or tells a listener.
class Progress {
 public:
  explicit Progress(bool quiet);
  explicit Progress(ProgressListener listener) : listener_(std::move(listener)), shown_(true) {}
  ~Progress() { wipe(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  [[nodiscard]] bool shown() const { return shown_; }
  /// `done` in [0,1].
  void show(std::string_view phase, double done);
  void show(std::string_view phase);
  void wipe();

 private:
  ProgressListener listener_;  ///< none: the terminal
  bool shown_;
  bool dirty_ = false;
};

}  // namespace aomd::cli
