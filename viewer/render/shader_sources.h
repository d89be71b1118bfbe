#pragma once
// The shaders' texts: embedded at build time, or read from a folder while they are being worked on.

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "viewer/base/embedded_text.h"

namespace aomd::render {

/// What cmake/EmbedText.cmake made of shaders/.
[[nodiscard]] std::span<const scene::EmbeddedText> embedded_texts();

/// From a file's name ("surface.vert") to its text.
using ShaderSources = std::map<std::string, std::string, std::less<>>;

/// The embedded shaders, or those of a folder. Throws GlError naming the file that is missing
/// there.
[[nodiscard]] ShaderSources load_shader_sources(
    const std::optional<std::filesystem::path>& folder = {});

}  // namespace aomd::render
