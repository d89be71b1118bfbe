#pragma once
// What a mesh is made from.

#include <filesystem>
#include <memory>
#include <string>

#include "core/mesh/mesh_data.h"
#include "core/model/classify.h"

namespace aomd::scene {

struct SavedWork;

/// What to load: a file, or a sample where `file` is empty.
struct LoadRequest {
  std::filesystem::path file;
  std::string sample;                         ///< or the name of `data`
  std::shared_ptr<const MeshData> data = {};  ///< instead of a sample; null: none
  bool practice = false;                      ///< of a lesson: changes to it are no work to keep
  int sample_size = 0;                        ///< 0 is the sample's own
  ClassifyOptions classify;
  bool recoverable = false;                    ///< takes the fingerprint that saved work needs
  std::shared_ptr<const SavedWork> work = {};  ///< what had been done to it; null: nothing
};

}  // namespace aomd::scene
