#include "tools/python/images.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "core/measure/image_diff.h"
#include "core/measure/picture_verdict.h"

namespace aomd::python {
namespace {

using Pixels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

io::Image image_from(const Pixels& pixels) {
  if (pixels.ndim() != 3 || pixels.shape(2) != 4)
    throw std::invalid_argument("a picture has the shape (height, width, 4)");
  io::Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
  std::copy_n(pixels.data(), image.rgba.size(), image.rgba.begin());
  return image;
}

py::dict image_difference(const Pixels& first, const Pixels& second) {
  const auto found = measure::compare_images(image_from(first), image_from(second));
  py::dict result;
  result["same_size"] = found.same_size;
  result["ssim"] = found.ssim;
  result["differing_pixels"] = found.differing_pixels;
  result["largest_channel_difference"] = found.largest_channel_difference;
  return result;
}

py::array difference_picture(const Pixels& first, const Pixels& second) {
  return array_of(measure::difference_picture(image_from(first), image_from(second)));
}

using Area = std::array<int, 4>;
Area corners_of(const measure::PixelArea& area) {
  return {area.x, area.y, area.width, area.height};
}

measure::PictureLimits limits_from(double threshold, int largest, double share, int noise,
                                   bool edges, const std::vector<Area>& masks) {
  auto limits = measure::PictureLimits::with_threshold(threshold);
  if (threshold < 1) {
    limits.largest = largest;
    limits.share = share;
    limits.noise = noise;
    limits.edges = edges;
  }
  for (const auto& [x, y, width, height] : masks) limits.masks.push_back({x, y, width, height});
  return limits;
}

py::dict judged(const Pixels& baseline, const Pixels& result, double threshold, int largest,
                double share, int noise, bool edges, const std::vector<Area>& masks) {
  const auto found =
      measure::judge_pictures(image_from(baseline), image_from(result),
                              limits_from(threshold, largest, share, noise, edges, masks));
  py::dict verdict;
  verdict["same"] = found.same;
  verdict["why"] = found.why;
  verdict["worst_tile"] = found.worst_tile;
  verdict["tile"] = corners_of(found.tile);
  verdict["largest"] = found.largest;
  verdict["largest_at"] = std::array{found.largest_at.x, found.largest_at.y};
  verdict["differing"] = found.differing;
  verdict["judged"] = found.judged;
  return verdict;
}

}  // namespace

py::array array_of(io::Image image) {
  const std::array shape{image.height, image.width, 4};
  auto* const pixels = new std::vector<std::uint8_t>(std::move(image.rgba));
  const py::capsule owner(pixels,
                          [](void* p) { delete static_cast<std::vector<std::uint8_t>*>(p); });
  return py::array_t<std::uint8_t>(shape, pixels->data(), owner);
}

void add_images(py::module_& module) {
  module.def("image_difference", &image_difference);
  module.def("difference_picture", &difference_picture);
  module.def("judge_pictures", &judged);
  module.def("to_png",
             [](const Pixels& pixels) { return py::bytes(io::to_png(image_from(pixels))); });
  module.def("read_png",
             [](const std::filesystem::path& file) { return array_of(io::read_png(file)); });
  module.def("write_png", [](const std::filesystem::path& file, const Pixels& pixels) {
    io::write_png(file, image_from(pixels));
  });
}

}  // namespace aomd::python
