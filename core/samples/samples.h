#pragma once
// Generated meshes: what the program opens when it is given no file, and what tests run on.

#include <span>
#include <string>
#include <string_view>

#include "core/mesh/mesh_data.h"

namespace aomd {

struct SampleInfo {
  std::string_view name;          ///< as in `aomd sample NAME`
  std::string_view description;   ///< one line
  int default_size = 0;           ///< what --size means when it is not given
  std::string_view size_meaning;  ///< e.g. "cells along a side"
  int dimension = 2;              ///< 2 a surface, 3 a volume
};

/// Every sample, in the order in which menus list them. The first is what opens without a file.
[[nodiscard]] std::span<const SampleInfo> samples();

/// Makes a sample; the same arguments give the same mesh on every machine.
/// Size 0 means the default. Throws std::invalid_argument naming the known samples, or the size's
/// bounds.
[[nodiscard]] MeshData make_sample(std::string_view name, int size = 0);

}  // namespace aomd
