// The paper's two ways to store adjacencies during decimation (its section 4), side by side.

#include <algorithm>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::StoragePart;
using scene::StorageRun;

std::string ms_text(double ms) { return scene::short_number(ms, ms < 10 ? 1 : 0) + " ms"; }

/// A value with a bar that compares it with the larger of the two.
void bar_row(const Frame& frame, const char* name, const std::string& value, double share) {
  muted(frame, name);
  ImGui::SameLine();
  text_right(value);
  bar(share, ImGui::GetColorU32(frame.colors.accent), 0.35f);
}

/// "collapses 56 KB, swaps and smoothing 60 KB"
std::string phase_words(const Frame& frame, const StorageRun& run) {
  const auto part = [&](const char* name, const StoragePart& p) {
    return std::string(name) + " " + scene::bytes_text(p.peak) +
           (frame.interactive ? " and " + ms_text(p.ms) : "");
  };
  return part("Collapses", run.collapses) + "; " + part("swaps and smoothing", run.improvement) +
         ".";
}

void result(const Frame& frame, const scene::StorageComparison& r) {
  const double most =
      static_cast<double>(std::max({r.ways[0].peak(), r.ways[1].peak(), std::size_t{1}}));
  const double longest = std::max({r.ways[0].ms(), r.ways[1].ms(), 1e-9});
  for (std::size_t way = 0; way < 2; ++way) {
    const StorageRun& run = r.ways[way];
    gap(0.1f);
    text(scene::way_names[way]);
    bar_row(frame, "Bytes at most", scene::bytes_text(run.peak()),
            static_cast<double>(run.peak()) / most);
    if (frame.interactive) bar_row(frame, "Time", ms_text(run.ms()), run.ms() / longest);
    wrapped(frame, phase_words(frame, run));
  }
  gap(0.1f);
  wrapped(frame, (r.same ? "The same mesh either way: " : "Different meshes: ") +
                     (r.same ? "" : scene::grouped(r.ways[0].counts[2]) + " and ") +
                     scene::counted(r.ways[1].counts[2], "face") + "; relations changed places " +
                     scene::counted(r.ways[1].exchanges, "time") + ".");
}

}  // namespace

void strategy_section(Frame& frame) {
  wrapped(frame,
          "Either T(0,1) and T(0,2) stay stored; or, to save memory, T(0,2) makes way for T(0,1) "
          "and T(1,2) "
          "whenever edges are swapped and vertices smoothed, and collapses find edges by hash set. "
          "Decimates two "
          "copies of this mesh by the paper's strategy with the present options.");
  if (const auto* going = frame.session.sheet().comparison()) {
    bar(frame.interactive ? going->progress() : 0, ImGui::GetColorU32(frame.colors.accent), 0.5f);
    command_button(frame, "Cancel", "cancel", -1);
    return;
  }
  const bool volume = frame.has_mesh() && frame.document().content().volume();
  const std::string hindrance(volume ? "This mesh is a volume: surfaces are compared."
                                     : frame.document().hindrance());
  command_button(frame, "Compare on this mesh", "strategies run", -1,
                 frame.can_decimate() && !volume);
  if (!hindrance.empty()) wrapped(frame, hindrance);
  if (frame.session.sheet().storage()) result(frame, *frame.session.sheet().storage());
}

}  // namespace aomd::ui
