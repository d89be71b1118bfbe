#include "tools/aomd/progress.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace aomd::cli {

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

void Progress::show(std::string_view phase, double done) {
  if (!shown_) return;
  if (listener_) return listener_(phase, done);
  const int percent = static_cast<int>(100 * std::clamp(done, 0.0, 1.0));
  std::cerr << "\r\033[Kaomd: " << phase << ' ' << percent << " %" << std::flush;
  dirty_ = true;
}

void Progress::show(std::string_view phase) {
  if (!shown_) return;
  if (listener_) return listener_(phase, -1);
  std::cerr << "\r\033[Kaomd: " << phase << std::flush;
  dirty_ = true;
}

void Progress::wipe() {
  if (dirty_) std::cerr << "\r\033[K" << std::flush;
  dirty_ = false;
}

}  // namespace aomd::cli
