// What goes on by itself on a sheet: playing, and work in the background.

#include <cmath>
#include <utility>

#include "viewer/session/sheet.h"

namespace aomd::scene {

void Sheet::play(bool on) {
  if (on && document.empty()) return;
  if (on && !document.can_redo()) document.seek(0);
  playing_ = on && document.can_redo();
  steps_due_ = 0;
}

void Sheet::advance_playing(double frame_s) {
  steps_due_ += frame_s * view_.play_speed.in(document.journal().size());
  const double whole = std::floor(steps_due_);
  steps_due_ -= whole;
  if (whole > 0) document.seek(document.journal().cursor() + static_cast<std::size_t>(whole));
  playing_ = document.can_redo();
}

void Sheet::play_to_the_end() {
  if (playing_) document.seek(document.journal().size());
  playing_ = false;
}

void Sheet::start_comparison() {
  storage_.reset();
  comparison_ = start_comparing(document.mesh(), document.options());
}

bool Sheet::take_comparison(bool wait) {
  const auto result = take(comparison_, wait);
  if (result) storage_ = result;
  return result.has_value();
}

bool Sheet::cancel_comparison() { return std::exchange(comparison_, nullptr) != nullptr; }

bool Sheet::start_measuring() {
  std::vector<MeasuredRun> wanted;
  for (const KeptRun& run : runs.rows())
    if (run.number > 0 && !run.distance) wanted.push_back({run.number, run.data, {}});
  if (wanted.empty()) return false;
  measurement_ = scene::start_measuring(to_data(document.copy_mesh_as_loaded().mesh()),
                                        document.content().bounds.diagonal(), std::move(wanted));
  return true;
}

bool Sheet::take_measurement(bool wait) {
  const auto measured = take(measurement_, wait);
  if (!measured) return false;
  for (const MeasuredRun& each : *measured) runs.set_distance(each.number, each.distance);
  return true;
}

bool Sheet::cancel_measuring() { return std::exchange(measurement_, nullptr) != nullptr; }

}  // namespace aomd::scene
