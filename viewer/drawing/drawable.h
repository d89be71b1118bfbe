#pragma once
// What the renderer draws: flat arrays in the layout of the GPU's buffers, patched in place.

#include <cstdint>
#include <memory>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "viewer/base/box.h"
#include "viewer/drawing/palette.h"
#include "viewer/drawing/patched.h"

namespace aomd::scene {

struct Pictures;

/// Bits of Corner::flags. The three corners of a face slot carry the same flags.
enum CornerFlag : std::uint32_t {
  hide_edge_01 =
      1u,  ///< no line from the slot's first corner to the second (a quad's diagonal, for instance)
  hide_edge_12 = 2u,
  hide_edge_20 = 4u,
  without_back = 16u,  ///< either side is its front
  highlighted = 8u,    ///< blended with the theme's highlight colour: the selection, a preview
};
/// The picture on a face, from 1 on (0: none), in the bits from here on: of Drawable::pictures.
inline constexpr std::uint32_t picture_shift = 20, most_pictures = 4095;
/// Besides, four bits from here on for each side, from the slot's corner k to the next: what is
/// said about that edge (EdgeCodes), for RenderSettings::show_edge_codes.
inline constexpr std::uint32_t edge_code_shift = 8;

/// One corner of a triangle; three in a row make a face slot. A dead slot has three equal
/// positions.
struct Corner {
  glm::vec3 position{};       ///< relative to Drawable::origin
  std::uint32_t normal = 0;   ///< pack_normal; need not be the geometric one
  Color color = 0xffffffffu;  ///< its alpha: how open the surface lies to light from all sides
  std::uint32_t flags = 0;    ///< CornerFlag
};
static_assert(sizeof(Corner) == 24);

/// A line of constant width in pixels with round ends: model edges, highlights. A dead one has
/// width 0.
struct Segment {
  glm::vec3 a{};
  glm::vec3 b{};
  Color color = 0xff000000u;
  float width_px = 0;  ///< at pixel scale 1
};
static_assert(sizeof(Segment) == 32);

/// A round dot of constant size in pixels: model vertices, highlights. A dead one has radius 0.
struct Disc {
  glm::vec3 center{};
  Color color = 0xff000000u;
  float radius_px = 0;  ///< at pixel scale 1, without the outline
  float room = 0;       ///< how far the next one is: it fades where they crowd; 0: never
};
static_assert(sizeof(Disc) == 24);

/// Things that are pointed at, drawn over the rest: tinted triangles (their normals and flags do
/// not matter), lines and discs.
struct Overlay {
  Patched<Corner> faces;
  Patched<Segment> lines;
  Patched<Disc> discs;
  void clear() {
    if (!faces.empty()) faces.assign({});
    if (!lines.empty()) lines.assign({});
    if (!discs.empty()) discs.assign({});
  }
};

/// A picture's content. Positions are float and relative to `origin`, which is double, so that a
/// small part far from the world's origin keeps its shape. `bounds` is in world coordinates and
/// encloses everything.
struct Drawable {
  glm::dvec3 origin{0};
  Box bounds;
  Patched<Corner> corners;    ///< 3 a face slot
  Patched<glm::vec2> places;  ///< of corners in the picture on their face; empty: there are none
  std::shared_ptr<const Pictures> pictures;
  Patched<Corner>
      cells;  ///< what a volume shows besides: sections, shrunken regions; never clipped
  Patched<Segment> interior_edges;   ///< drawn when RenderSettings::glass
  Patched<Segment> model_edges;      ///< drawn when RenderSettings::show_model_edges
  Patched<Disc> model_vertices;      ///< drawn when RenderSettings::show_model_vertices
  Patched<Segment> highlight_lines;  ///< always drawn, over the model's
  Patched<Disc> highlight_discs;     ///< always drawn, over the model's
  Overlay before;             ///< of a step, what stood there: also where the surface hides it
  Overlay selected, hovered;  ///< on the surface
  Overlay preview;            ///< of an operation: also drawn where the surface hides it
  Overlay rulers;             ///< along what is measured: likewise
  Overlay ground;             ///< below it, seen from above
  Box ground_bounds;          ///< of that and the rest
};

/// A unit normal as signed 10:10:10:2, x in the lowest bits; error below 0.1 degrees.
[[nodiscard]] inline std::uint32_t pack_normal(const glm::vec3& n) {
  const glm::vec3 scaled = glm::round(glm::clamp(n, -1.0f, 1.0f) * 511.0f);
  const auto bits = [](float v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(v)) & 0x3ffu;
  };
  return bits(scaled.x) | bits(scaled.y) << 10 | bits(scaled.z) << 20;
}

/// The inverse of pack_normal, not normalised.
[[nodiscard]] inline glm::vec3 unpack_normal(std::uint32_t packed) {
  const auto part = [&](int shift) {
    return static_cast<float>(static_cast<std::int32_t>(packed << (22 - shift)) >> 22) / 511.0f;
  };
  return {part(0), part(10), part(20)};
}

}  // namespace aomd::scene
