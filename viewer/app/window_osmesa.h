#pragma once
// A context in main memory by Mesa's OSMesa (up to Mesa 25.0).

#include "viewer/app/window.h"

namespace aomd::app {

/// Pins llvmpipe's vector width (LP_NATIVE_VECTOR_WIDTH=128, unless the environment says
/// otherwise), because it changes pixels slightly. Throws WindowError.
[[nodiscard]] std::unique_ptr<Window> make_osmesa_window(glm::ivec2 size);

}  // namespace aomd::app
