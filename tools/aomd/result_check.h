#pragma once
// What a decimation must not have made worse, and what it made.

#include <optional>
#include <string>
#include <vector>

#include "core/measure/volume_statistics.h"
#include "core/mesh/mesh.h"
#include "tools/aomd/decimate_report.h"
#include "tools/aomd/given_mesh.h"
#include "tools/aomd/volume_faults.h"

namespace aomd::cli {

/// Looks at a mesh before and after.
class ResultCheck {
 public:
  ResultCheck(const DecimateOptions& options, const GivenMesh& given, int threads)
      : options_(options), given_(given), threads_(threads) {}

  /// As classified. Fills in what the report says of the input; notes what keeps a surface from its
  /// target, or what does not fit together in a volume.
  std::vector<std::string> before(const Mesh& mesh, DecimateReport& report);
  /// A result that agrees with itself. Fills in what the report says of it. Throws InternalFault
  /// where something in a volume is worse than before.
  void after(const Mesh& mesh, DecimateReport& report) const;

 private:
  [[nodiscard]] std::vector<std::string> wrong_with(const Mesh& mesh,
                                                    const DecimateReport& report) const;
  void look_at_volume(const Mesh& mesh, DecimateReport& report) const;

  const DecimateOptions& options_;
  const GivenMesh& given_;
  int threads_;
  std::vector<measure::RegionVolume> volumes_;
  std::optional<VolumeFaults> faults_;  ///< of a volume as classified
};

}  // namespace aomd::cli
