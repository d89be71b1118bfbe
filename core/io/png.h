#pragma once
// Pictures on disk: PNG, eight bits a channel, always as RGBA in memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/error.h"

namespace aomd::io {

/// A picture: rows from top to bottom, 4 bytes a pixel (red, green, blue, alpha; not premultiplied,
/// sRGB). rgba.size() == 4 * width * height.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  /// A transparent black picture of width x height pixels, both >= 0.
  Image(int w, int h)
      : width(w), height(h), rgba(4 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  [[nodiscard]] bool empty() const { return rgba.empty(); }
  [[nodiscard]] std::size_t pixel_count() const { return rgba.size() / 4; }
  /// The 4 bytes of the pixel in column x (0..width-1) and row y (0 at the top).
  [[nodiscard]] std::uint8_t* pixel(int x, int y) { return rgba.data() + offset(x, y); }
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const { return rgba.data() + offset(x, y); }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};

/// The largest picture that read_png accepts, in pixels.
inline constexpr std::uint64_t max_image_pixels = std::uint64_t{1} << 26;

/// Reads a PNG of any colour type and depth. Throws ReadError (missing, not a PNG, damaged) or
/// LimitError.
[[nodiscard]] Image read_png(const std::filesystem::path& path);

/// The bytes of a PNG. The same picture gives the same ones: no time, no name. Throws WriteError
/// for an empty picture.
[[nodiscard]] std::string to_png(const Image& image);

/// Writes a PNG with the guarantees of write_file(). Throws WriteError, also for an empty picture.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace aomd::io
