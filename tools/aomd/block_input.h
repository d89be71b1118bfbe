#pragma once
// An input that is read in blocks, each made coarser at once, since all of it may not fit into
// memory.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/blocks/coarse_surface.h"
#include "core/blocks/exchange.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/progress.h"

namespace aomd::cli {

struct BlockInput {
  CoarseSurface coarse;
  std::uint32_t vertices = 0, faces = 0;  ///< of the file
  std::vector<std::string> notes;
};

/// Of --blocks N. Shared out among the processes of an exchange, of which the first one gets it.
[[nodiscard]] std::optional<BlockInput> read_in_blocks(const DecimateOptions& options,
                                                       Exchange& exchange, Progress& progress);

}  // namespace aomd::cli
