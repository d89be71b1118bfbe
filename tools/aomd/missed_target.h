#pragma once
// A run that stopped above its target: why, and what would help.

#include <cstdint>
#include <string>
#include <vector>

#include "core/decimate/options.h"
#include "core/measure/statistics.h"
#include "tools/aomd/decimate_options.h"

namespace aomd::cli {

/// Whether so many faces miss a target, 0 for none, by more than one percent.
[[nodiscard]] bool misses(std::uint64_t faces, std::uint64_t target);

/// How many faces the pieces of a surface need: where no more are left, only joining pieces helps.
[[nodiscard]] std::uint64_t least_faces(const measure::Counts& input);

/// What loosens a reason that keeps edges: an option, or a command that mends the input. None for
/// pieces that only welding joins.
struct Help {
  Reason reason = Reason::None;
  std::string option;
};

/// What a run that missed its target found.
struct MissedTarget {
  EdgesByReason edges{};   ///< that are left, by what keeps them
  std::vector<Help> help;  ///< the one for most edges first
};

/// The input of a run.
struct RunInput {
  const MeshData& mesh;
  const measure::Counts& counts;
  bool features;  ///< edges became model edges by their angle
};

/// Says what would loosen each reason that keeps a twentieth of the edges at least: an option of
/// `given`, or a command that mends the input. Where the `faces` that are left are no more than its
/// pieces need, only welding can.
[[nodiscard]] std::vector<Help> what_would_help(const EdgesByReason& edges,
                                                const DecimateOptions& given,
                                                const DecimationOptions& steps,
                                                const RunInput& input, std::uint64_t faces);

/// "3,210 faces, above the target of 1,000: of 4,815 edges left, ...; --angle 20 would help, or
/// --feature-angle off"; of a volume tetrahedra.
[[nodiscard]] std::string sentence(const MissedTarget& missed, const DecimationOptions& steps,
                                   std::uint64_t target, std::uint64_t cells, bool volume);

/// "refused" of a report: how many edges each reason keeps, those that keep none left out.
[[nodiscard]] Json refused_json(const EdgesByReason& edges);
/// "help": the option for each reason that has one.
[[nodiscard]] Json help_json(const std::vector<Help>& help);

}  // namespace aomd::cli
