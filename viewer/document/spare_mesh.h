#pragma once
// A mesh that has been shown and not been changed, for whoever opens the same file next.

#include <filesystem>
#include <memory>

#include "viewer/document/loaded_mesh.h"

namespace aomd::scene {

class SpareMesh {
 public:
  /// One that was read from a file, instead of the one before. Null: none.
  void keep(std::unique_ptr<LoadedMesh> mesh);
  /// What loading would lead to, once; null where that is not at hand.
  [[nodiscard]] std::unique_ptr<LoadedMesh> take(const LoadRequest& request);

 private:
  [[nodiscard]] bool answers(const LoadRequest& request) const;

  std::unique_ptr<LoadedMesh> mesh_;
  std::filesystem::path file_;  ///< absolute
};

}  // namespace aomd::scene
