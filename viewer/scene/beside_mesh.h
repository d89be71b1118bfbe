#pragma once
// A mesh that is looked at beside the present one.

#include <array>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// A copy that can be drawn and counted: it stores T(2,0), T(0,1), T(0,2) and lists what lies on each model
/// entity. Not movable.
class BesideMesh {
 public:
  /// O(size).
  explicit BesideMesh(const MeshData& data) : mesh_(data) {
    needs_ = {mesh_.request(2, 0, "drawing"), mesh_.request(0, 1, "drawing"), mesh_.request(0, 2, "drawing")};
    mesh_.keep_class_lists(true);
  }
  BesideMesh(const BesideMesh&) = delete;
  BesideMesh& operator=(const BesideMesh&) = delete;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

 private:
  Mesh mesh_;
  std::array<Request, 3> needs_;
};

}  // namespace aomd::scene
