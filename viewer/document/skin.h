#pragma once
// What can be seen of a mesh with regions or quads: polygons, found without storing a relation.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
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

/// A triangle of a mesh, in any order.
using TriangleSide = std::array<Vertex, 3>;

/// Whether the middle of an entity is before a plane: dot(xyz, p) + w >= 0.
[[nodiscard]] bool is_before(const Mesh& mesh, EntityRef e, const glm::dvec4& plane);

/// What a skin has on a triangle, where there is something to be seen; with a plane as a SkinCutter
/// finds it. T(0,2) and T(0,3) must be stored. O(regions around a vertex).
[[nodiscard]] std::optional<SkinFace> skin_face_on(const Mesh& mesh, const TriangleSide& side,
                                                   const std::optional<glm::dvec4>& plane);

/// Whether there are no other regions and faces than tetrahedra and triangles. O(1).
[[nodiscard]] bool is_of_tetrahedra(const Mesh& mesh);

/// The outer surface (sides with one region, faces with none), and inside it what separates model
/// regions or lies on a model face. O(regions + faces); of the memory that takes only the result
/// stays.
class Skin {
 public:
  explicit Skin(const Mesh& mesh);
  /// The same, in another order, of a prepared volume (prepare_volume) that is_of_tetrahedra(); as
  /// a SkinCutter leaves it where there is a plane. A fraction of the time.
  [[nodiscard]] static Skin of_tetrahedra(const Mesh& mesh, const std::optional<glm::dvec4>& plane);

  [[nodiscard]] std::span<const SkinFace> faces() const { return faces_; }
  /// How many of them belong to the outer surface.
  [[nodiscard]] std::int64_t outer() const { return outer_; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }

 private:
  friend class SkinCutter;
  Skin() = default;
  void add(const std::optional<SkinFace>& face);
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
