#pragma once
// The parts of a surface at work at the same time, each on a thread.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/decimate/guard/guards.h"
#include "core/decimate/options.h"
#include "core/mesh/shared_edits.h"

namespace aomd {

/// What a thread is at that takes the turns of parts; each strategy adds what it needs to judge and
/// to make operations.
struct PartHand {
  std::size_t part = 0;
  bool within_part = false;      ///< what touches the seam is left to others
  SharedEdits* edits = nullptr;  ///< none: nobody else edits, and the mesh follows at once
  SweepStatistics made;          ///< where there are others
};

/// Whether nothing else has to follow each operation at once: else the parts take their turns one
/// by one.
[[nodiscard]] inline bool parts_may_share(const Mesh& mesh, const DecimationOptions& options,
                                          const Guards& guards) {
  return options.threads > 1 && !guards.any() && !options.model &&
         options.topology == TopologyRule::Safe && SharedEdits::possible(mesh);
}

/// Threads that take the turns of the parts of a surface, each with a hand of its own.
template <typename Hand>
class PartsAtOnce {
 public:
  enum class Outcome { Done, WantsRoom, Stopped };

  /// Makes sure that there is a hand for each thread, by make(), and begins edits of all parts.
  template <typename Make>
  void begin(Mesh& mesh, std::size_t parts, int threads, Make&& make) {
    parts_ = parts;
    threads_ = std::min(static_cast<std::size_t>(threads), parts);
    while (hands_.size() < threads_) hands_.push_back(make());
    SharedEdits::begin(mesh, parts, edits_);
  }
  /// Calls advance(hand) for the parts from `first` on until it says that its part has nothing more
  /// to do. Stops where parts have used up their room, who go on when all have new room, and when
  /// `cancelled`, asked every few candidates, says so.
  template <typename Advance>
  Outcome run(std::size_t first, const Advance& advance, const std::function<bool()>& cancelled) {
    Work work{cancelled, first};
    parallel_for(threads_, static_cast<int>(threads_), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) take_parts(*hands_[i], i == 0, advance, work);
    });
    if (work.stopped) return Outcome::Stopped;
    return work.wants_room ? Outcome::WantsRoom : Outcome::Done;
  }
  /// The mesh is one again, and the statistics have what all hands made.
  void settle(Mesh& mesh, SweepStatistics& sweep) {
    SharedEdits::settle(mesh, edits_);
    for (const auto& hand : hands_) {
      sweep.collapses += hand->made.collapses;
      sweep.swaps += hand->made.swaps;
      sweep.smooths += hand->made.smooths;
      for (std::size_t i = 0; i < sweep.refused.size(); ++i)
        sweep.refused[i] += hand->made.refused[i];
      hand->made = {};
    }
  }
  [[nodiscard]] const std::vector<std::unique_ptr<Hand>>& hands() const { return hands_; }

 private:
  struct Work {
    const std::function<bool()>& cancelled;
    std::atomic<std::size_t> next;  ///< the part that nobody has taken yet
    std::atomic<bool> wants_room = false, stopped = false;
  };

  template <typename Advance>
  void take_parts(Hand& hand, bool may_ask, const Advance& advance, Work& work) {
    constexpr int candidates_between_checks = 64;
    hand.within_part = true;
    for (hand.part = work.next++; hand.part < parts_; hand.part = work.next++) {
      hand.edits = &edits_[hand.part];
      bool goes_on = true;
      for (int i = 1; goes_on && !work.stopped; ++i) {
        if (may_ask && i % candidates_between_checks == 0 && work.cancelled && work.cancelled())
          work.stopped = true;
        goes_on = hand.edits->has_room();
        if (!goes_on) work.wants_room = true;
        goes_on = goes_on && advance(hand);
      }
    }
  }

  std::size_t parts_ = 1, threads_ = 1;
  std::vector<std::unique_ptr<Hand>> hands_;
  std::vector<SharedEdits> edits_;  ///< by part
};

}  // namespace aomd
