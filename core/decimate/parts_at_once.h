#pragma once
// The parts of a mesh at work at the same time, each on a thread.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
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
  return options.threads > 1 && !guards.any() && SharedEdits::possible(mesh);
}

/// The same for surfaces, where a model or the paper's topology changes more than lies in a part.
[[nodiscard]] inline bool surface_parts_may_share(const Mesh& mesh,
                                                  const DecimationOptions& options,
                                                  const Guards& guards) {
  return !options.model && options.topology == TopologyRule::Safe &&
         parts_may_share(mesh, options, guards);
}

/// Threads that take the turns of the parts of a mesh, each with a hand of its own.
template <typename Hand>
class PartsAtOnce {
 public:
  /// What the parts of a mesh are worked off by.
  struct Work {
    std::size_t parts = 1;
    std::size_t first = 0;  ///< the part whose turn it is: those before it are done
    int threads = 1;
    const std::function<bool()>& cancelled;  ///< asked every few candidates
  };

  /// Makes sure that there is a hand for each thread, by make().
  template <typename Make>
  void need_hands(const Work& work, const Make& make) {
    threads_ = std::min(static_cast<std::size_t>(work.threads), work.parts);
    while (hands_.size() < threads_) hands_.push_back(make());
  }
  /// Calls advance(hand) for each part until it says that its part has nothing more to do. Where
  /// parts have used up their room, they go on when all have new room, after begin(). Then the mesh
  /// is one again, and the statistics have what all hands made. Who is cancelled begins no other
  /// part, but ends those that were begun: regions that come later get the ids that went last, and
  /// so what follows does not depend on where it was cancelled. Returns whether all parts are done.
  template <typename Begin, typename Advance>
  bool run(Mesh& mesh, const Work& work, SweepStatistics& sweep, const Begin& begin,
           const Advance& advance) {
    Shared shared{.work = work, .end = work.parts};
    do {
      SharedEdits::begin(mesh, work.parts, edits_);
      begin();
      shared.next = work.first;
      shared.wants_room = false;
      each_thread([&](std::size_t i) { take_parts(*hands_[i], i == 0, advance, shared); });
      shared.end = std::min(shared.end, shared.next.load());
      shared.may_stop = false;
    } while (shared.wants_room);
    SharedEdits::settle(mesh, edits_);
    for (const auto& hand : hands_) sweep += std::exchange(hand->made, {});
    return shared.end == work.parts;
  }
  [[nodiscard]] const std::vector<std::unique_ptr<Hand>>& hands() const { return hands_; }

 private:
  /// What threads share while they take the parts.
  struct Shared {
    const Work& work;
    std::size_t end;                    ///< no part from here on is begun
    std::atomic<std::size_t> next = 0;  ///< the part that nobody has taken yet
    bool may_stop = true;
    std::atomic<bool> wants_room = false, stopped = false;
  };

  template <typename Do>
  void each_thread(const Do& act) {
    parallel_for(threads_, static_cast<int>(threads_), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) act(i);
    });
  }
  template <typename Advance>
  void take_parts(Hand& hand, bool may_ask, const Advance& advance, Shared& shared) {
    constexpr int candidates_between_checks = 64;
    const auto& cancelled = shared.work.cancelled;
    hand.within_part = true;
    while (!(shared.may_stop && shared.stopped)) {
      hand.part = shared.next++;
      if (hand.part >= shared.end) return;
      hand.edits = &edits_[hand.part];
      bool goes_on = true;
      for (int i = 1; goes_on; ++i) {
        if (may_ask && i % candidates_between_checks == 0 && cancelled && cancelled())
          shared.stopped = true;
        goes_on = hand.edits->has_room();
        if (!goes_on) shared.wants_room = true;
        goes_on = goes_on && advance(hand);
      }
    }
  }

  std::size_t threads_ = 1;
  std::vector<std::unique_ptr<Hand>> hands_;
  std::vector<SharedEdits> edits_;  ///< by part
};

}  // namespace aomd
