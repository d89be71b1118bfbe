#include "tools/aomd/block_input.h"

#include <filesystem>

#include "core/base/text.h"

namespace aomd::cli {

std::optional<CoarseSurface> read_in_blocks(const DecimateOptions& options, Exchange& exchange,
                                            Progress& progress) {
  if (options.paper()) throw UsageError("--blocks is for --strategy quality");
  const std::filesystem::path input = options.input;
  if (options.weld.on() && std::filesystem::is_regular_file(input) &&
      lower(input.extension().string()) != ".pvtu")
    throw UsageError("--weld with --blocks is for the borders of tiles, and " + options.input +
                     " is one file");
  BlockRules rules;
  rules.weld = options.weld.for_tiles();
  rules.decimation = options.for_library();
  rules.classify = options.for_classification();
  rules.target = [&](std::uint32_t faces) { return options.target_count(false, faces); };
  return coarsen_in_blocks(options.input, options.blocks, rules, exchange,
                           [&](double done) { progress.show("making blocks coarser", done); });
}

std::vector<std::string> notes_of(const CoarseSurface& input) {
  if (input.left_out.empty()) return {};
  return {"left out, since blocks hold vertices and faces alone: " + joined(input.left_out, ", ")};
}

}  // namespace aomd::cli
