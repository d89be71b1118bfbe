#pragma once
// Structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004) of the luminance of two pictures.

#include <vector>

#include "core/io/png.h"

namespace aomd::measure {

/// The index over each window of 8x8 pixels, smaller at pictures below 8 pixels. Windows step by 4
/// pixels; the last of a row or a column touches the far border.
struct SsimWindows {
  static constexpr int size = 8;
  static constexpr int step = 4;

  std::vector<int> columns;    ///< where windows begin, from the left
  std::vector<int> rows;       ///< from the top
  std::vector<double> values;  ///< row by row

  [[nodiscard]] double mean() const;
};

/// Two pictures of one size that are not empty. Luminance after Rec. 709, on black where a picture
/// is transparent.
[[nodiscard]] SsimWindows ssim_windows(const io::Image& a, const io::Image& b);

}  // namespace aomd::measure
