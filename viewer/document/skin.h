#pragma once
// What can be seen of a mesh with regions or quads: polygons, found without storing a relation.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "core/mesh/mesh.h"
#include "viewer/base/box.h"

namespace aomd::scene {

/// A side of one region or of two, or a face that no region uses.
struct SkinFace {
  std::array<std::uint32_t, max_face_vertices> vertices{};  ///< they look out of `inside`
  std::uint8_t count = 0;                                   ///< how many vertices
  bool has_inside = false;                                  ///< there is a region behind it
  bool has_outside = false;                                 ///< and one in front of it
  ModelRef inside, outside;  ///< what these regions are classified on
  ModelRef model;            ///< what the face itself is classified on, where the mesh has it
  Face face;                 ///< invalid where the mesh does not have it
  Region inside_region, outside_region;  ///< invalid where there is none

  [[nodiscard]] std::span<const std::uint32_t> corners() const { return {vertices.data(), count}; }
  /// Part of the outer surface.
  [[nodiscard]] bool outer() const { return !has_outside; }
};

/// The outer surface (sides with one region, faces with none), and inside it what separates model
/// regions or lies on a model face. O(regions + faces); of the memory that takes only the result
/// stays.
class Skin {
 public:
  explicit Skin(const Mesh& mesh);

  [[nodiscard]] std::span<const SkinFace> faces() const { return faces_; }
  /// How many of them belong to the outer surface.
  [[nodiscard]] std::int64_t outer() const { return outer_; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }

 private:
  friend class SkinCutter;
  Skin() = default;
  void finish(const Mesh& mesh);

  std::vector<SkinFace> faces_;
  std::int64_t outer_ = 0;
  Box bounds_;
};

class SideMatcher;

/// Skins of parts of one mesh, which must outlive it and not change. O(sides log sides) once, and
/// about 20 bytes a side.
class SkinCutter {
 public:
  explicit SkinCutter(const Mesh& mesh);
  ~SkinCutter();
  /// As if regions, and faces without one, were not there whose middle is behind the plane:
  /// dot(xyz, p) + w < 0. O(regions + faces), several times as fast as a Skin.
  [[nodiscard]] Skin before(const glm::dvec4& plane) const;

 private:
  const Mesh& mesh_;
  std::unique_ptr<SideMatcher> sides_;
};

}  // namespace aomd::scene
