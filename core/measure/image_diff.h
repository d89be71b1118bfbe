#pragma once
// How far one picture is from another as a whole: figures for people. Whether it is the same
// picture is judged by core/measure/picture_verdict.

#include <cstddef>

#include "core/io/png.h"

namespace aomd::measure {

/// The difference of two pictures. Where the sizes differ nothing is compared: ssim is 0, all
/// pixels differ.
struct ImageDifference {
  bool same_size = false;
  double ssim = 0;  ///< mean structural similarity of the luminance: 1 equal, about 0 unrelated
  int largest_channel_difference = 0;  ///< 0..255, over red, green, blue and alpha
  std::size_t differing_pixels = 0;    ///< pixels in which any channel differs
  std::size_t pixels = 0;              ///< pixels of the larger picture

  [[nodiscard]] bool identical() const { return same_size && differing_pixels == 0; }
};

/// Compares two pictures, by the mean of ssim_windows(). Cost: linear in the pixels. Never throws
/// for content; empty pictures are equal.
[[nodiscard]] ImageDifference compare_images(const io::Image& a, const io::Image& b);

/// A picture that shows where `b` departs from `a`: `a` in dimmed grey, differences in red,
/// amplified so that a difference of 16 in any channel is already full red. Where the sizes differ:
/// both in the frame of the larger one, and all that only one of them covers is red.
[[nodiscard]] io::Image difference_picture(const io::Image& a, const io::Image& b);

}  // namespace aomd::measure
