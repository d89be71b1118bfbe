#pragma once

namespace aomd::scene {

/// Which axis of a mesh points up.
enum class UpAxis { Y, Z };

}  // namespace aomd::scene
