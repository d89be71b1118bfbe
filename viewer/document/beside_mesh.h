#pragma once
// A mesh that is looked at beside the present one.

#include "viewer/document/drawing_needs.h"

namespace aomd::scene {

/// A copy that can be drawn and counted: it lists what lies on each model entity, and a surface
/// stores T(2,0), T(0,1), T(0,2). Not movable.
class BesideMesh {
 public:
  /// O(size).
  explicit BesideMesh(const MeshData& data) : mesh_(data) {
    if (mesh_.count(3) == 0) needs_ = request_for_drawing(mesh_);
    mesh_.keep_class_lists(true);
  }
  BesideMesh(const BesideMesh&) = delete;
  BesideMesh& operator=(const BesideMesh&) = delete;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

 private:
  Mesh mesh_;
  DrawingNeeds needs_;
};

}  // namespace aomd::scene
