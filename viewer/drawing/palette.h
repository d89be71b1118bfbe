#pragma once
// Colours: packing, and the palette of model entities, safe for colour-blind eyes.

#include <cstdint>

#include <glm/vec4.hpp>

#include "core/mesh/model_ref.h"

namespace aomd::scene {

/// sRGB with alpha, one byte each, red in the lowest: the bytes R, G, B, A in memory (and ImGui's
/// ImU32).
using Color = std::uint32_t;

/// From components in [0,1]; values outside are clamped.
[[nodiscard]] Color pack_color(const glm::vec4& rgba);
[[nodiscard]] glm::vec4 unpack_color(Color color);
/// From 0xRRGGBB, opaque.
[[nodiscard]] constexpr Color rgb(std::uint32_t hex) {
  return 0xff000000u | (hex & 0xffu) << 16 | (hex & 0xff00u) | (hex >> 16 & 0xffu);
}
/// a at t = 0, b at t = 1, per channel.
[[nodiscard]] Color mix_colors(Color a, Color b, float t);

/// The colour of a model entity, the same in every run and on every machine. Based on the palette
/// of Okabe and Ito: model vertices strongest, model edges strong, model faces and regions light
/// tints; consecutive tags get hues that lie far apart. The first 8 tags differ in hue, the next
/// ones in lightness too. Never the neutral one.
[[nodiscard]] Color color_of(ModelRef ref);

/// Stands for the lines where model faces meet in a mesh that names no model edges.
inline constexpr ModelRef unnamed_border{1, 0};
/// Their colour, and that of all model edges where colours have no meaning.
[[nodiscard]] constexpr Color plain_line_color() { return rgb(0x3a4656); }
/// The colour of faces where colours have no meaning.
[[nodiscard]] constexpr Color plain_face_color() { return rgb(0xc4cbd4); }
/// The colour of what is not classified.
[[nodiscard]] constexpr Color unclassified_color() { return rgb(0xc9ccd1); }

/// Scales for numbers. Lightness rises evenly along each, also for colour-blind eyes and in grey;
/// the darkest part is left out, because shading would not show on it.
enum class ColorMap {
  Viridis,  ///< dark blue over green to yellow
  Magma,    ///< violet over red to pale yellow: where more is worse
  Cividis,  ///< blue over grey to yellow: nearly the same to colour-blind eyes
  Grey,     ///< for print
};
/// 0 to 1 (clamped).
[[nodiscard]] Color ramp_color(float t, ColorMap map = ColorMap::Viridis);

}  // namespace aomd::scene
