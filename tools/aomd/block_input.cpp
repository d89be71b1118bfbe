#include "tools/aomd/block_input.h"

namespace aomd::cli {

std::optional<CoarseSurface> read_in_blocks(const DecimateOptions& options, Exchange& exchange,
                                            Progress& progress) {
  BlockRules rules;
  rules.decimation = options.for_library();
  rules.classify = options.for_classification();
  rules.target = [&](std::uint32_t faces) { return options.target_count(false, faces); };
  return coarsen_in_blocks(options.input, options.blocks, rules, exchange,
                           [&](double done) { progress.show("making blocks coarser", done); });
}

std::vector<std::string> notes_of(const CoarseSurface& input) {
  std::string names;
  for (const std::string& name : input.left_out) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) return {};
  return {"left out, since blocks hold the shape alone: " + names};
}

}  // namespace aomd::cli
