#pragma once
// Which meshes a glTF scene shows, and where.

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "core/io/gltf_file.h"

namespace aomd::io::detail {

/// A mesh at one place.
struct GltfInstance {
  int mesh = 0;
  glm::dmat4 place{1};
  std::string name;  ///< of its node, or else of the mesh
};

/// The meshes of the default scene, of the first one where none is, of all nodes where there is no
/// scene, and all meshes where there are no nodes. Nodes come before their children. Throws
/// ReadError for what is not there, for numbers that are none, and for nodes that are not a tree.
[[nodiscard]] std::vector<GltfInstance> scene_of(const GltfFile& file);

}  // namespace aomd::io::detail
