#pragma once
// A surface that need not fit into memory as a coarser one that does, for a decimation to go on
// from.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/blocks/block.h"
#include "core/blocks/exchange.h"
#include "core/mesh/mesh_data.h"

namespace aomd {

/// A mesh that stands for the surface of a file, and points of what it stands for.
struct CoarseSurface {
  MeshData mesh;
  std::shared_ptr<const OriginalSamples> samples;  ///< DecimationOptions::original
  std::uint32_t vertices = 0, faces = 0;           ///< of the file
  std::vector<std::string> left_out;               ///< what the file has beside them
};

/// Cuts the surface into so many blocks (1 to BlockCut::most_blocks), makes each coarser than the
/// file and finer than the target, and puts them together again by the numbers of the vertices on
/// the seams, which have stayed. Processes take the blocks in turn; the first one gets the result,
/// the others nothing. The result follows from the surface, the rules and the number of blocks: not
/// from the numbers of processes and of threads. `done` is told the share that is. In memory at a
/// time: a block with what its decimation takes, two bytes a vertex of the file, and the result.
/// Throws ReadError and LimitError as StreamedSurface does; the first process does for the others.
[[nodiscard]] std::optional<CoarseSurface> coarsen_in_blocks(
    const std::filesystem::path& path, std::size_t blocks, const BlockRules& rules,
    Exchange& exchange, const std::function<void(double)>& done);

}  // namespace aomd
