#pragma once
// What a glTF file says of materials beyond what Material holds: more pictures, and how they lie,
// blending and extensions. It stays JSON, in a line about the whole for each such material.

#include <cstdint>
#include <functional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// The number of the picture of a texture, or Material::no_picture.
using PictureOfTexture = std::function<std::uint32_t(std::uint64_t texture)>;

/// What a material of a file says beyond Material, under the name by which faces know it, or an
/// empty string. Textures are pictures there; those that have none are left out.
[[nodiscard]] std::string rest_of_material(const nlohmann::json& material, const std::string& name,
                                           const PictureOfTexture& picture);

/// Gives the materials of a glTF tree what the mesh has kept of them, and names their extensions.
/// The n-th texture of the tree is the mesh's n-th picture.
void add_rests(const MeshData& mesh, nlohmann::json& tree);

}  // namespace aomd::io::detail
