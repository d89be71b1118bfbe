#pragma once
// One block of a surface: read, made coarser, and handed over.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/blocks/block_cut.h"
#include "core/decimate/options.h"
#include "core/decimate/original_samples.h"
#include "core/model/classify.h"

namespace aomd {

/// The faces of a block, and what is known of the original under them.
struct Block {
  using Triangle = BlockCut::Triangle;
  std::vector<glm::dvec3> positions;
  /// By vertex: its number in the file where it lies on the seam, else no_index.
  std::vector<std::uint32_t> ids;
  std::vector<Triangle> faces;
  /// Of each array of the file: at the vertices, or on the faces.
  std::vector<std::vector<double>> values;
  OriginalSamples samples;

  /// As bytes for another process of the same machine type, and back.
  [[nodiscard]] std::string bytes() const;
  [[nodiscard]] static Block from(std::string_view bytes);
};

/// What a block is told.
struct BlockRules {
  io::StreamedSurface::Weld weld;  ///< of tiles
  DecimationOptions decimation;    ///< but for its target
  ClassifyOptions classify;
  /// How many faces a surface with so many is to have in the end.
  std::function<std::uint32_t(std::uint32_t faces)> target;
  double above = 4;  ///< blocks end at so many times their share of that
};

/// Collapses alone, in the order of what they cost; what lies on the seam stays where it is. The
/// file's arrays have no say, and go along (io::carry_along). Once through the file. The result
/// does not depend on the number of threads.
[[nodiscard]] Block coarse_block(const io::StreamedSurface& surface, const BlockCut& cut,
                                 std::size_t block, const BlockRules& rules);

}  // namespace aomd
