#pragma once
// A suite: pictures of meshes that are to stay what they are, as a TOML file lists them
// (docs/REGRESSION.md).

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/measure/picture_verdict.h"

namespace aomd::suite {

/// A picture: what is shown, how, and what it may differ by from its baseline. Paths are as the
/// suite has them, relative to `folder`.
struct Case {
  std::string name;
  int line = 0;         ///< where in the suite it begins, or what is wrong with it stands
  std::string problem;  ///< what is wrong with the entry; it is not drawn then

  std::filesystem::path folder;  ///< in which it is carried out
  std::string mesh;
  std::string model;
  std::string script;
  std::vector<std::string> commands;  ///< carried out after the script
  std::vector<std::string> expect;    ///< after these: what the mesh must fulfil

  glm::ivec2 size{640, 480};
  std::string camera;
  bool dark = false;
  double scale = 1;          ///< of text, lines and points
  bool panels = false;       ///< the whole window, not the mesh alone
  bool transparent = false;  ///< without what is behind the mesh

  measure::PictureLimits limits;
  double panels_threshold = 0.98;  ///< least similarity of a tile of the panels
};

struct Suite {
  std::filesystem::path file;       ///< as it was named
  std::filesystem::path baselines;  ///< the folder of the baselines
  std::vector<Case> cases;          ///< in the order of the file

  [[nodiscard]] std::filesystem::path baseline_of(const Case& each) const {
    return baselines / (each.name + ".png");
  }
  /// "suite.toml:12"
  [[nodiscard]] std::string place_of(const Case& each) const {
    return file.string() + ":" + std::to_string(each.line);
  }
};

/// Reads a suite. What is wrong with one case is its `problem`, and the others stand. Throws
/// io::ReadError, with file and line, for what is wrong with the suite as a whole.
[[nodiscard]] Suite read_suite(const std::filesystem::path& file);

}  // namespace aomd::suite
