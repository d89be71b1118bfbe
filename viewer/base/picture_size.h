#pragma once
// Sizes of pictures, as options and suites have them: "1280x800".

#include <string>

#include <glm/vec2.hpp>

namespace aomd::scene {

/// Reads a size; says what is wrong with it, or nothing.
[[nodiscard]] std::string read_picture_size(const std::string& text, glm::ivec2& size);

}  // namespace aomd::scene
