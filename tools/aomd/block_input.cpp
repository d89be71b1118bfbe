#include "tools/aomd/block_input.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/io/streamed_surface.h"

namespace aomd::cli {
namespace {

std::vector<std::string> notes_of(const io::StreamedSurface& surface) {
  std::string names;
  for (const std::string& name : surface.left_out()) names += (names.empty() ? "" : ", ") + name;
  if (names.empty()) return {};
  return {"left out, since blocks hold the shape alone: " + names};
}

}  // namespace

std::optional<BlockInput> read_in_blocks(const DecimateOptions& options, Exchange& exchange,
                                         Progress& progress) {
  const io::StreamedSurface surface(options.input);
  BlockRules rules;
  rules.decimation = options.for_library();
  rules.decimation.target_faces = options.target_count(false, surface.faces());
  rules.classify = options.for_classification();
  auto coarse = coarsen_in_blocks(surface, options.blocks, rules, exchange, [&](double done) {
    progress.show("making blocks coarser", done);
  });
  if (!coarse) return {};
  return BlockInput{std::move(*coarse), surface.vertices(), surface.faces(), notes_of(surface)};
}

}  // namespace aomd::cli
