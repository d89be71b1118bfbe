#pragma once
// The options of `aomd decimate`: from the command line to what the library is told.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/decimate/options.h"
#include "core/decimate/spacing/spacing.h"
#include "core/model/classify.h"
#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/report.h"
#include "tools/aomd/weld_option.h"

namespace aomd::cli {

/// As given, defaults included.
struct DecimateOptions {
  std::string input, output, format;
  // What to aim at
  std::string target;               ///< "1000", or "10%" of the input's faces; empty: none
  std::string target_tets;          ///< the same of tetrahedra
  double target_error_pct = 0;      ///< of the diagonal of the input's box; 0: none
  bool reach = false;               ///< guards are let go of until the target is met
  std::string spacing;              ///< empty: by factor
  std::optional<double> gradation;  ///< of the spacing; none: what suits it
  // How
  std::string strategy = "quality", feature_angle = "20", seams = "keep", snap = "none", model;
  std::vector<std::string> attributes;  ///< what counts beside the shape, as given
  bool feature_angle_given = false, factor_given = false, no_swap = false, no_smooth = false,
       repair = false, triangulate = false, split_to_tets = false;
  WeldOption weld;                   ///< with repair
  std::vector<std::string> without;  ///< names of ideas that are left out
  // What is guaranteed
  std::optional<double> angle_deg;  ///< none: what suits the strategy
  std::string topology = "safe", keep, only;
  std::string volume_rule;  ///< keep or free; empty: what the strategy does
  bool min_dihedral_given = false;
  double max_distance_pct = 0;  ///< of the diagonal of the input's box
  int threads = 0;              ///< 0: all cores
  std::size_t blocks = 1;       ///< that the input is cut into
  // What is written
  std::string report, journal;
  std::size_t pieces = 1;  ///< of a .pvtu
  bool quiet = false, strict = false, prints_json = false;
  bool one_of_several = false;   ///< other processes write to the same terminal
  DecimationOptions decimation;  ///< takes the numbers that need nothing else

  [[nodiscard]] bool paper() const { return strategy == "paper"; }
  [[nodiscard]] bool snaps() const { return snap == "model"; }

  /// The number of faces, or of tetrahedra, to aim at, at least 1; 0 for none. Throws UsageError
  /// for a target of the other kind.
  [[nodiscard]] std::uint32_t target_count(bool volume, std::uint32_t input_count) const;
  /// Throws UsageError for options that belong to the other kind of mesh, or of strategy.
  void check_kind(bool volume) const;
  /// The files that it reads.
  [[nodiscard]] std::vector<NamedFile> inputs() const;
  /// The files that it writes.
  [[nodiscard]] std::vector<NamedFile> outputs() const;
  /// What would mend the input before: an option, or a command where blocks refuse that.
  [[nodiscard]] const char* mending() const { return blocks > 1 ? "aomd repair" : "--repair"; }
  /// For the library, apart from what needs the mesh: target, spacing, keep, model and
  /// max_distance.
  [[nodiscard]] DecimationOptions for_library() const;
  [[nodiscard]] ClassifyOptions for_classification() const;
  /// None without --spacing. Throws UsageError for what is no file and no formula.
  [[nodiscard]] std::optional<SpacingSource> spacing_source() const;
  /// Throws UsageError too where a factor is given beside one that has no use for it, or a --weld
  /// beside nothing to weld.
  void check_spacing() const;
  /// "options" of a report: each of them, null where it is not in use; `steps` is what the library
  /// was told.
  [[nodiscard]] Json json(const DecimationOptions& steps, bool volume) const;
};

/// Adds them to the command, in groups.
void add_decimate_options(CLI::App& command, DecimateOptions& options);

}  // namespace aomd::cli
