#pragma once
// Where a surface is hollow: small folds, which looking from afar does not tell.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace aomd::scene {

/// By vertex: how strongly the surface bends towards its normal there, times the part of `diagonal`
/// over which that is told; 0 where it is flat or bulges out. `lengths` are those of the edges
/// around each vertex, on average. Finer meshes are told over more faces, since they have more
/// noise.
[[nodiscard]] std::vector<float> hollows(std::span<const glm::vec3> positions,
                                         std::span<const glm::vec3> normals,
                                         std::span<const float> lengths,
                                         std::span<const std::array<std::uint32_t, 3>> faces,
                                         float diagonal);

}  // namespace aomd::scene
