#include "viewer/drawing/picture_series.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "core/io/error.h"

namespace aomd::scene {
namespace {

std::string file_name(PictureSeries::Kind kind, int number) {
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return (kind == PictureSeries::Kind::Turntable ? "turn-" : "history-") + digits + ".png";
}

}  // namespace

PictureSeries::PictureSeries(Kind kind, std::filesystem::path folder, int count,
                             std::optional<glm::ivec2> size, const Document& document,
                             const View& view)
    : kind_(kind),
      folder_(std::move(folder)),
      count_(count),
      size_(size),
      camera_(view.camera),
      step_(document.journal().cursor()),
      operation_(view.operation) {
  if (kind == Kind::History)
    count_ = static_cast<int>(
        std::min<std::size_t>(static_cast<std::size_t>(count), document.journal().size() + 1));
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw io::WriteError(folder_.string(), {}, "this folder cannot be made: " + error.message());
}

std::optional<ScreenshotRequest> PictureSeries::next(Document& document, View& view) {
  if (made_ == count_) return {};
  if (kind_ == Kind::Turntable) {
    view.camera = camera_;
    view.camera.orbit(360.0 * made_ / count_, 0);
  } else {
    view.operation = false;  // a mark that jumps about says nothing
    const double part = count_ > 1 ? static_cast<double>(made_) / (count_ - 1) : 1.0;
    document.seek(static_cast<std::size_t>(
        std::llround(part * static_cast<double>(document.journal().size()))));
  }
  ++made_;
  return ScreenshotRequest{folder_ / file_name(kind_, made_), size_, false, false};
}

void PictureSeries::put_back(Document& document, View& view) const {
  view.camera = camera_;
  view.operation = operation_;
  if (document.journal().cursor() != step_) document.seek(step_);
}

}  // namespace aomd::scene
