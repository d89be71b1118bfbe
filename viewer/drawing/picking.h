#pragma once
// What lies under a place of the picture, found without the GPU.

#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/camera.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/skin_surface.h"
#include "viewer/drawing/view.h"

namespace aomd::scene {

/// What is shown: the triangles that are drawn, and the mesh whose entities they stand for.
struct Shown {
  const Mesh& drawn;                  ///< stores T(0,1), T(0,2) and T(2,0)
  const Mesh& mesh;                   ///< the same one, for a surface of triangles
  const SkinSurface* skin = nullptr;  ///< leads from one to the other where they differ
  Box bounds;
  std::span<const Corner> cells = {};  ///< sections and shrunken regions, relative to `origin`
  std::span<const Region> cell_regions = {};  ///< of each triangle of those
  glm::dvec3 origin{0};
};

/// From the world to the picture, in pixels from its lower left corner.
class Projector {
 public:
  Projector(const View& view, const Box& bounds);
  /// Invalid (not finite) behind the eye.
  [[nodiscard]] glm::dvec2 operator()(const glm::dvec3& p) const;
  [[nodiscard]] glm::dvec2 pixels(glm::dvec2 ndc) const { return 0.5 * (ndc + 1.0) * size_; }
  [[nodiscard]] glm::dvec2 ndc(glm::dvec2 pixels) const { return 2.0 * pixels / size_ - 1.0; }
  [[nodiscard]] glm::dvec2 size() const { return size_; }

 private:
  glm::dmat4 matrix_;
  glm::dvec2 size_;
};

/// Picks on one shown surface after the other. The tree is built at the first pick; after small
/// changes only the faces that they touched are looked at beside it.
class Picker {
 public:
  /// Another surface is shown, or parts of it have changed: the faces of `changes`.
  void forget();
  void note(const SurfaceChanges& changes);
  /// Other cells are shown.
  void forget_cells() { cells_.reset(); }

  /// The entity at a place (-1..1): what the view's level asks for. An invalid one beside the
  /// surface. Hidden classes and what the clipping plane takes away are looked through; sections
  /// and shrunken regions give their region. O(log n) once the tree is there (0.1 s for 200,000
  /// faces).
  [[nodiscard]] EntityRef at(const Shown& shown, const View& view, glm::dvec2 ndc);
  /// What can be seen in a rectangle, as a whole: of the view's level, Automatic takes faces.
  [[nodiscard]] std::vector<EntityRef> within(const Shown& shown, const View& view, glm::dvec2 low,
                                              glm::dvec2 high);

 private:
  struct Hit {
    Face face;      ///< of what is drawn; invalid: a triangle of `region`
    Region region;  ///< of a section, or shrunken
    double distance = 0;
  };
  void build(const Shown& shown);
  [[nodiscard]] std::optional<Hit> first(const Shown& shown, const View& view,
                                         const Ray& ray) const;
  [[nodiscard]] Hit first_face(const Shown& shown, const View& view, const Ray& ray) const;
  struct Inside {
    Projector project;
    glm::dvec2 low, high;  ///< in pixels
    Column<Vertex, std::uint8_t> vertices;
    [[nodiscard]] bool operator()(const glm::dvec3& p) const {
      const glm::dvec2 at = project(p);
      return at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y;
    }
  };
  [[nodiscard]] bool visible(const Shown& shown, const View& view, const Projector& project,
                             const glm::dvec3& p, Face own) const;
  void add_parts(const Shown& shown, const View& view, const Inside& inside, Face f,
                 std::vector<EntityRef>& found);
  void add_cells(const Shown& shown, const View& view, const Inside& inside,
                 std::vector<EntityRef>& found);
  [[nodiscard]] Edge entity(const Shown& shown, Vertex a, Vertex b);

  std::unique_ptr<const TriangleTree> tree_;
  std::unique_ptr<const TriangleTree> cells_;  ///< of the cells, where there are some
  std::vector<Face> faces_;                    ///< by the tree's source index
  std::vector<std::uint8_t> changed_;          ///< by face: the tree does not know it as it is
  std::vector<Face> loose_;                    ///< those faces
  bool edges_known_ = false;
  std::unordered_map<std::uint64_t, Edge> edges_;  ///< of a mesh that does not store T(0,1)
};

}  // namespace aomd::scene
