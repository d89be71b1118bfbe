#pragma once
// An input that is read in blocks, each made coarser at once, since all of it may not fit into
// memory.

#include <optional>
#include <string>
#include <vector>

#include "core/blocks/coarse_surface.h"
#include "core/blocks/exchange.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/progress.h"

namespace aomd::cli {

/// For --blocks N. Shared out among the processes of an exchange, of which the first one gets it.
[[nodiscard]] std::optional<CoarseSurface> read_in_blocks(const DecimateOptions& options,
                                                          Exchange& exchange, Progress& progress);
/// What it has left behind, as a note.
[[nodiscard]] std::vector<std::string> notes_of(const CoarseSurface& input);

}  // namespace aomd::cli
