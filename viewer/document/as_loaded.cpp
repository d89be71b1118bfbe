#include "viewer/document/as_loaded.h"

#include <algorithm>
#include <cmath>

#include "core/decimate/spacing/curvature.h"
#include "viewer/document/skin.h"

namespace aomd::scene {

AsLoaded::AsLoaded(const Mesh& mesh) : copy_(to_data(mesh)) {}

bool AsLoaded::has(const Mesh& mesh, Face face) const {
  if (face.index >= this->mesh().capacity(2)) return false;
  const auto now = mesh.triangle(face);
  if (now != this->mesh().triangle(face)) return false;
  return std::all_of(now.begin(), now.end(),
                     [&](Vertex v) { return mesh.position(v) == this->mesh().position(v); });
}

const TriangleTree& AsLoaded::tree() {
  if (!tree_) tree_.emplace(triangles_of(mesh()).corners);
  return *tree_;
}

const TriangleTree* AsLoaded::tree_of(ModelRef model_face) {
  if (skin_trees_.empty()) plant_skin();
  const auto found = skin_trees_.find(model_face);
  return found == skin_trees_.end() ? nullptr : &found->second;
}

/// Polygons as fans.
void AsLoaded::plant_skin() {
  std::map<ModelRef, std::vector<Triangle>> triangles;
  const auto at = [&](std::uint32_t v) { return mesh().position(Vertex(v)); };
  const Skin skin(mesh());
  for (const SkinFace& face : skin.faces()) {
    if (face.model.dimension() != 2) continue;
    const auto v = face.corners();
    for (std::size_t k = 1; k + 1 < v.size(); ++k)
      triangles[face.model].push_back({at(v[0]), at(v[k]), at(v[k + 1])});
  }
  for (const auto& [model, of_model] : triangles) skin_trees_.try_emplace(model, of_model);
}

const Column<Vertex, double>& AsLoaded::curvatures() {
  if (!curvatures_) curvatures_ = vertex_curvatures(mesh());
  return *curvatures_;
}

double face_distance(const Mesh& mesh, Face face, const TriangleTree& original) {
  constexpr int parts = 4;
  const auto v = mesh.triangle(face);
  const glm::dvec3 a = mesh.position(v[0]), u = mesh.position(v[1]) - a,
                   w = mesh.position(v[2]) - a;
  double worst2 = 0;
  std::uint32_t near = no_index;
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j) {
      const auto found =
          original.nearest(a + u * (double(i) / parts) + w * (double(j) / parts), near);
      near = found.triangle;
      worst2 = std::max(worst2, found.distance2);
    }
  return std::sqrt(worst2);
}

}  // namespace aomd::scene
