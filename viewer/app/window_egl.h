#pragma once
// A context without a surface by EGL.

#include "viewer/app/window.h"

namespace aomd::app {

/// Mesa's surfaceless platform first, then the default display; a pbuffer stands in for the window.
/// Pins llvmpipe's vector width as make_osmesa_window() does. Throws WindowError.
[[nodiscard]] std::unique_ptr<Window> make_egl_window(glm::ivec2 size);

}  // namespace aomd::app
