#pragma once
// What one `aomd decimate` did and measured: for its report and its last lines.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "core/fields/carry.h"
#include "core/model/classify.h"
#include "core/repair/repair.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/letting_go.h"
#include "tools/aomd/missed_target.h"
#include "tools/aomd/report.h"
#include "tools/aomd/volume_report.h"

namespace aomd::cli {

/// What is known of an input that was read in blocks.
struct InBlocks {
  std::uint32_t vertices = 0, faces = 0;
};

struct DecimateReport {
  measure::Counts input, output;
  std::optional<InBlocks> in_blocks;  ///< `input` is then what blocks came to, put together
  measure::Quality quality;
  RepairReport repaired;
  std::vector<SweepStatistics> sweeps;
  std::vector<fields::CarriedField> fields;
  std::optional<MissedTarget> missed;
  std::uint32_t target = 0;         ///< faces, or tetrahedra; 0: none
  std::vector<Guard> let_go;        ///< of until the target was met, or nothing was left
  std::optional<double> error_pct;  ///< largest distance, where that was the aim
  int tries = 0;                    ///< that led to it
  std::uint32_t others = 0;         ///< regions that are no tetrahedra
  std::size_t flips = 0, self_intersections = 0;
  Json seconds = Json::object(), memory = Json::object();
  // Of a volume
  measure::VolumeQuality volume_quality;
  std::vector<VolumeChange> volumes;

  [[nodiscard]] bool volume() const { return input.regions > 0; }
  /// The result's faces, or its tetrahedra.
  [[nodiscard]] std::size_t cells() const {
    return volume() ? output.regions - others : output.faces;
  }
};

/// Schema 1 (docs/COMMAND_LINE.md).
[[nodiscard]] Json report_json(const DecimateOptions& options, const DecimationOptions& steps,
                               const ClassifyOptions& how, const DecimateReport& report);

/// "let go of facing and features to come that far"
[[nodiscard]] std::string words_of_let_go(const std::vector<Guard>& guards);

/// One line, then one for each model region and each array.
void print_decimation(std::ostream& out, const DecimateOptions& options,
                      const DecimateReport& report);

}  // namespace aomd::cli
