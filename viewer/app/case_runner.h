#pragma once
// Draws a case of a suite and judges it.

#include <filesystem>
#include <memory>

#include "viewer/app/graphics.h"
#include "viewer/document/spare_mesh.h"
#include "viewer/suite/case_result.h"

namespace aomd::app {

/// Each case is carried out as if the program had been started for it alone, with a session and a
/// viewer of its own. Cases of one size that follow one another share the context and the shaders,
/// those of one mesh the mesh, as long as they leave it as it was loaded.
class CaseRunner {
 public:
  /// Pictures go into the folder `work`, an absolute path. `update`: baselines are made.
  CaseRunner(const suite::Suite& suite, std::filesystem::path work, bool update)
      : suite_(suite), work_(std::move(work)), update_(update) {}

  /// Leaves its pictures as NAME.png and NAME.diff.png, and this process in the case's folder.
  /// Never throws.
  [[nodiscard]] suite::CaseResult run(const suite::Case& each);

 private:
  struct Drawn;

  [[nodiscard]] suite::CaseResult draw_and_judge(const suite::Case& each);
  void provide_window(glm::ivec2 size);
  void compare(const suite::Case& each, const Drawn& drawn, suite::CaseResult& result) const;
  void make_baseline(const suite::Case& each, const Drawn& drawn, suite::CaseResult& result) const;
  void keep_pictures(const suite::Case& each, const Drawn& drawn, const io::Image* baseline,
                     suite::CaseResult& result) const;

  const suite::Suite& suite_;
  std::filesystem::path work_;
  bool update_;
  std::unique_ptr<Window> window_;  ///< of the last case
  std::shared_ptr<Graphics> graphics_;
  scene::SpareMesh spare_;  ///< of the last case
};

}  // namespace aomd::app
