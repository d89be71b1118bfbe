#pragma once
// The pictures on a surface, as its file has them.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/io/png.h"
#include "core/mesh/mesh_data.h"
#include "viewer/drawing/palette.h"

namespace aomd::scene {

/// Pictures ready to be drawn, and what is to be said of those that are not.
struct Pictures {
  std::vector<io::Image> images;  ///< as Appearance::pictures; empty where one cannot be had
  std::vector<std::string> notes;
};
/// Reads all of them. Those that are missing or damaged are named.
[[nodiscard]] Pictures read_pictures(const Appearance& looks);

/// What lies on one face.
struct PaintedFace {
  std::array<glm::vec2, 3> at{};  ///< the place in the picture of each corner, counted upwards
  Color color = plain_face_color();
  std::uint16_t picture = 0;  ///< from 1; 0: the colour alone
  friend bool operator==(const PaintedFace&, const PaintedFace&) = default;
};

/// By the ids of faces.
struct SurfaceTexture {
  std::shared_ptr<const Pictures> pictures;
  std::vector<PaintedFace> faces;
  std::uint64_t version = 0;  ///< changes when more than faces did that are drawn anew

  [[nodiscard]] PaintedFace of(std::uint32_t face) const {
    return face < faces.size() ? faces[face] : PaintedFace();
  }
};

/// Whether faces have something to show: a picture with places for it, or colours of materials.
[[nodiscard]] bool has_looks(const Appearance& looks);

/// What `data` says of its triangles, in its order.
[[nodiscard]] std::vector<PaintedFace> painted_faces(const MeshData& data);

}  // namespace aomd::scene
