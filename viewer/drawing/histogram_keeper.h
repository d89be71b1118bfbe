#pragma once
// Histograms of the present mesh beside those of the mesh as loaded, or of a kept state.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/measure/histogram.h"
#include "viewer/document/document.h"
#include "viewer/document/kept_runs.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// One quantity. Both histograms have the same bins.
struct HistogramPair {
  std::vector<measure::Sample> samples;  ///< of the present mesh
  std::vector<measure::Sample> earlier;  ///< of the mesh as loaded, or of a kept state
  measure::Histogram before, now;
};

/// What a model region holds.
struct RegionContent {
  ModelRef model;
  std::int64_t count = 0;  ///< of regions of the mesh
  double volume = 0;       ///< in cubed units of the mesh
};
/// A model region of the present mesh and of the earlier one.
struct RegionChange {
  RegionContent now, before;
  /// Of the volume, in percent of what it was.
  [[nodiscard]] double percent() const {
    return before.volume > 0 ? 100 * (now.volume / before.volume - 1) : 0;
  }
  /// More than decimation lets a region owe (docs/VOLUMES.md).
  [[nodiscard]] bool large() const { return std::abs(percent()) > 0.1; }
};

/// By HistogramKind. Of a volume there are smallest dihedral angles alone, and the others are
/// empty.
struct Histograms {
  std::array<HistogramPair, 3> pairs;
  bool changed = false;         ///< whether the mesh may differ from the one as loaded
  bool wanted_lengths = false;  ///< lengths over the wanted ones; else over their mean as loaded
  bool volume = false;
  std::vector<RegionChange> regions;  ///< of a volume, in ascending order of their tags

  [[nodiscard]] const HistogramPair& of(HistogramKind kind) const {
    return pairs[static_cast<std::size_t>(kind)];
  }
  /// O(entities)
  [[nodiscard]] std::vector<EntityRef> counted_in(const MarkedBar& bar) const {
    const HistogramPair& pair = of(bar.kind);
    return measure::entities_in(pair.samples, pair.now, pair.now.bin(bar.value));
  }
};

/// Makes them where somebody looks, and not again before the mesh or the options have changed.
class HistogramKeeper {
 public:
  /// O(1) where nothing has changed, else O(entities). Lets go of them where they are not `wanted`.
  /// True when they have changed. While something runs, which is not `still`, those that there are
  /// stay. `reference` is the kept state to compare with; null: the mesh as loaded.
  bool update(Document& document, const KeptRun* reference, bool wanted, bool still);
  /// Whether they are of the mesh at this place.
  [[nodiscard]] bool current(const HistoryPlace& place) const {
    return histograms_ && place == place_;
  }
  [[nodiscard]] const Histograms* histograms() const {
    return histograms_ ? &*histograms_ : nullptr;
  }

 private:
  void measure_now(const Mesh& mesh);
  void measure_before(Document& document, const KeptRun* reference);

  std::optional<Histograms> histograms_;
  std::vector<RegionContent> regions_before_;
  Column<Vertex, double> lengths_;  ///< what edges are held against
  HistoryPlace place_;
  unsigned reference_ = 0;
  std::uint64_t options_ = 0;  ///< revision of the options
};

}  // namespace aomd::scene
