#pragma once
// What became of a case.

#include <filesystem>
#include <string>
#include <vector>

#include "core/measure/picture_verdict.h"
#include "viewer/suite/suite.h"

namespace aomd::suite {

enum class Outcome {
  Same,
  New,      ///< a baseline was made that was not there
  Updated,  ///< the baseline was made anew
  Differs,
  Missed,   ///< an expectation does not hold
  Missing,  ///< there is no baseline
  Broken,   ///< it could not be drawn
};

/// "same", "differs": one word.
[[nodiscard]] std::string_view outcome_word(Outcome outcome);

/// What a part of the picture that is judged by itself came to.
struct Judged {
  std::string part;  ///< "scene", "panels"; empty: the whole picture
  measure::PictureVerdict verdict;
};

struct CaseResult {
  Outcome outcome = Outcome::Broken;
  int exit_code = 0;           ///< what this case alone ends the program with
  std::string why;             ///< one line; empty where all is well
  std::vector<Judged> judged;  ///< empty where nothing was compared
  double seconds = 0;
  /// Pictures, as files: what was drawn, and where it departs from the baseline; empty: none.
  std::filesystem::path picture, difference;

  [[nodiscard]] bool well() const { return exit_code == 0; }
  /// Over all parts: the least similarity of a tile, the largest difference, the share of pixels.
  [[nodiscard]] double worst_tile() const;
  [[nodiscard]] int largest() const;
  [[nodiscard]] double share() const;
};

/// Judges a picture against its baseline: as a whole, or `scene` (in pixels) and the panels around
/// it apart.
[[nodiscard]] std::vector<Judged> judge(const Case& each, const io::Image& baseline,
                                        const io::Image& picture, const measure::PixelArea& scene);

/// "in the scene the tile at ..., in the panels ...": why a picture is not as its baseline; empty
/// where it is.
[[nodiscard]] std::string why_differs(const std::vector<Judged>& judged);

/// A result as another process of this program reads it.
[[nodiscard]] std::string to_json(const CaseResult& result);
[[nodiscard]] CaseResult from_json(const std::string& text);

}  // namespace aomd::suite
