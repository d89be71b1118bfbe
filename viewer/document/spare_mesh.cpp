#include "viewer/document/spare_mesh.h"

#include <tuple>
#include <utility>

namespace aomd::scene {
namespace {

auto as_tuple(const ClassifyOptions& o) {
  return std::tie(o.feature_angle_deg, o.corner_angle_deg, o.nonmanifold_edges, o.keep_present,
                  o.seams, o.complete);
}

}  // namespace

void SpareMesh::keep(std::unique_ptr<LoadedMesh> mesh) {
  mesh_ = std::move(mesh);
  if (mesh_) file_ = std::filesystem::absolute(mesh_->file);
}

std::unique_ptr<LoadedMesh> SpareMesh::take(const LoadRequest& request) {
  if (!answers(request)) return nullptr;
  mesh_->file = request.file;
  mesh_->source = request;
  return std::move(mesh_);
}

/// Whether this is the same file in the same state, and is to be classified in the same way.
bool SpareMesh::answers(const LoadRequest& request) const {
  if (!mesh_ || request.file.empty() || request.data || request.work || request.practice ||
      request.recoverable)
    return false;
  return std::filesystem::absolute(request.file) == file_ && mesh_->stamp &&
         stamp_of(request.file) == mesh_->stamp &&
         as_tuple(request.classify) == as_tuple(mesh_->source.classify);
}

}  // namespace aomd::scene
