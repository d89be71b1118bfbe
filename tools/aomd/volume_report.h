#pragma once
// What `aomd info`, `aomd check` and `aomd compare` say of a volume mesh.

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

/// Prints a line for each model region, 20 at most: regions, volume, Euler number, parts.
void print_regions(const measure::VolumeComplex& complex);

/// Inverted, repeated, folded and crowded regions, by name.
[[nodiscard]] std::vector<Finding> volume_findings(const measure::VolumeComplex& complex,
                                                   const measure::VolumeQuality& quality);

}  // namespace aomd::cli
