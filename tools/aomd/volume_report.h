#pragma once
// What `aomd info`, `aomd check` and `aomd compare` say of a volume mesh.

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

#include "core/measure/volume_complex.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/verify.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// "3", the tag of a model region; "none" for regions without a class.
[[nodiscard]] std::string region_name(ModelRef model);
/// The same as JSON: a number or null.
[[nodiscard]] Json region_json(ModelRef model);

/// "volume": the model regions, and what does not fit together.
[[nodiscard]] Json volume_json(const measure::VolumeComplex& complex,
                               const measure::VolumeQuality& quality);

/// The volume of one model region before and after a run.
struct VolumeChange {
  ModelRef model;
  std::array<std::size_t, 2> regions{};
  std::array<double, 2> volume{};

  /// In percent of the volume before; infinite where that was none and now is some.
  [[nodiscard]] double percent() const;
};
/// By ascending `model`.
[[nodiscard]] std::vector<VolumeChange> volume_changes(
    const std::vector<measure::RegionVolume>& before,
    const std::vector<measure::RegionVolume>& after);
/// The percent of the region that has changed most; 0 where there is none.
[[nodiscard]] double largest_percent(const std::vector<VolumeChange>& changes);

/// "model_regions" of a report, by the names that aomd compare has for it.
[[nodiscard]] Json volume_changes_json(const std::vector<VolumeChange>& changes);
/// A line for each model region, 20 at most.
void print_volume_changes(std::ostream& out, const std::vector<VolumeChange>& changes);

/// Prints a line for each model region, 20 at most: regions, volume, Euler number, parts.
void print_regions(const measure::VolumeComplex& complex);

/// Inverted, repeated, folded and crowded regions, by name.
[[nodiscard]] std::vector<Finding> volume_findings(const measure::VolumeComplex& complex,
                                                   const measure::VolumeQuality& quality);

}  // namespace aomd::cli
