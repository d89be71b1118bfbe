#pragma once
// Which arrays of a mesh a glTF file holds, and what they are called there.

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// An array, the semantic of its attribute, and the type by which it is stored.
struct GltfArray {
  const Attribute* array;
  bool on_corners;
  std::string semantic;
  NumberType type;
};

/// Those on vertices and on corners of 1, 2, 3, 4, 9 and 16 components whose numbers have a place
/// among floats and whole numbers of 8 and 16 bits.
[[nodiscard]] std::vector<GltfArray> gltf_arrays(const MeshData& mesh);

/// Whether an array has a number for a corner or vertex.
[[nodiscard]] bool has_numbers(const Attribute& array, std::size_t at);

}  // namespace aomd::io::detail
