#pragma once
// Whether a picture is still its baseline, as a person who looks at both would say: small losses
// count, what no two drivers draw alike does not.

#include <cstddef>
#include <string>
#include <vector>

#include "core/io/png.h"

namespace aomd::measure {

/// A rectangle of pixels, from the upper left corner of the picture.
struct PixelArea {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  friend bool operator==(const PixelArea&, const PixelArea&) = default;
};

/// What two pictures of the same thing may differ by.
struct PictureLimits {
  double threshold = 0.98;       ///< least structural similarity of a tile, -1..1
  int largest = 48;              ///< largest difference of a channel in a pixel, 0..255
  double share = 0.0005;         ///< of the pixels that are judged, how many may differ
  int noise = 2;                 ///< differences up to it are none
  bool edges = true;             ///< forgives single pixels that an edge nearby explains
  std::vector<PixelArea> masks;  ///< not judged; what lies outside of the picture is ignored

  /// Nothing differs, but in what is masked.
  [[nodiscard]] static PictureLimits exact();
  /// The usual limits with another threshold; exact() for 1.
  [[nodiscard]] static PictureLimits with_threshold(double threshold);
};

/// What was found. Figures are those after forgiving: 1 and 0 where all was forgiven.
struct PictureVerdict {
  static constexpr int tile_size = 32;

  bool same = false;
  bool same_size = false;
  double worst_tile = 0;      ///< structural similarity of the tile that fits least
  PixelArea tile;             ///< that tile
  int largest = 255;          ///< largest difference of a channel
  PixelArea largest_at;       ///< the pixel
  std::size_t differing = 0;  ///< pixels
  std::size_t judged = 0;     ///< pixels that are not masked
  std::string why;            ///< one line for people; empty where the pictures are the same

  [[nodiscard]] double share() const {
    return judged == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(judged);
  }
};

/// Judges `result` against `baseline`, in this order:
///
/// 1. Forgiven are pixels that are masked, those whose channels differ by the noise at most, and
///    along edges those that what the other picture has within one pixel explains, both ways, as
///    long as what such pixels of a tile differ by comes to 1/256 of the tile at most: a few steps
///    of a line drawn otherwise, but no line that moved.
/// 2. In what is left no tile of 32x32 pixels may be less similar than the threshold (the mean of
///    its ssim_windows()), no pixel may differ by more than `largest`, and no more than `share` of
///    all pixels at all.
///
/// Pictures of different sizes are never the same; empty ones are. Cost: linear in the pixels.
[[nodiscard]] PictureVerdict judge_pictures(const io::Image& baseline, const io::Image& result,
                                            const PictureLimits& limits = {});

}  // namespace aomd::measure
