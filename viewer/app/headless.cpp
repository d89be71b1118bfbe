// Chooses a context without a window.

#include <array>

#include "core/io/png.h"
#include "viewer/app/window.h"
#include "viewer/app/window_egl.h"
#include "viewer/app/window_osmesa.h"

namespace aomd::app {
namespace {

constexpr int largest_side = 16384;

bool fits(glm::ivec2 size) {
  return size.x >= 1 && size.y >= 1 && size.x <= largest_side && size.y <= largest_side &&
         static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) <=
             io::max_image_pixels;
}

std::unique_ptr<Window> make_one(HeadlessKind kind, glm::ivec2 size) {
#ifdef AOMD_HAVE_OSMESA
  if (kind == HeadlessKind::OsMesa) return make_osmesa_window(size);
#endif
#ifdef AOMD_HAVE_EGL
  if (kind == HeadlessKind::Egl) return make_egl_window(size);
#endif
  throw WindowError(kind == HeadlessKind::OsMesa ? "OSMesa: not built in" : "EGL: not built in");
}

}  // namespace

std::unique_ptr<Window> make_headless_window(HeadlessKind kind, glm::ivec2 size) {
  if (!fits(size))
    throw WindowError("a picture is 1 to 16384 pixels wide and high, and has 64 million at most");
  if (kind != HeadlessKind::Auto) return make_one(kind, size);
  std::string reasons;
  for (const HeadlessKind each : std::array{HeadlessKind::OsMesa, HeadlessKind::Egl}) {
    try {
      return make_one(each, size);
    } catch (const WindowError& error) {
      reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  throw WindowError("no way to draw without a window: " + reasons);
}

}  // namespace aomd::app
