#pragma once
// A skin's surface brought up to a volume of which a few tetrahedra have changed.

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

#include "viewer/base/id_set.h"
#include "viewer/document/volume_changes.h"
#include "viewer/drawing/skin_surface.h"

namespace aomd::scene {

/// One patch: afterwards the surface is what make_skin_surface() would make, in another order. The
/// mesh must store T(0,1), T(0,2) and T(0,3).
class SkinPatch {
 public:
  /// `plane`: behind it whole regions are gone.
  SkinPatch(const Mesh& mesh, const SkinStyle& style, const std::optional<glm::dvec4>& plane,
            SkinSurface& surface)
      : mesh_(mesh), style_(style), plane_(plane), surface_(surface) {}
  /// What of the surface is another one than before. O(changes).
  [[nodiscard]] SurfaceChanges apply(const VolumeChanges& changes);

 private:
  using Ends = std::array<Vertex, 2>;
  void follow_vertices(const std::vector<Vertex>& touched);
  void patch_side(const TriangleSide& side);
  void patch_edge(const Ends& ends);
  void patch_vertex(Vertex v);
  [[nodiscard]] Face drawn_face(const TriangleSide& side) const;
  [[nodiscard]] bool is(Face drawn, const ShownFace& shown) const;
  void add(const ShownFace& shown);
  void remove(Face drawn);
  Vertex draw(Vertex v);
  [[nodiscard]] ModelRef class_of(const Ends& drawn, ModelRef model) const;
  [[nodiscard]] SurfaceChanges changes();

  const Mesh& mesh_;
  const SkinStyle& style_;
  const std::optional<glm::dvec4>& plane_;
  SkinSurface& surface_;
  std::vector<Ends> edges_;  ///< of the mesh, around what was replaced
  IdSet changed_vertices_, changed_edges_, changed_faces_;  ///< of the surface
};

}  // namespace aomd::scene
