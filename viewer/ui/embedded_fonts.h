#pragma once
// The fonts that are part of the program: what the machine that built it has of those that panels
// are made for (cmake/EmbedFonts.cmake).

#include <span>
#include <string_view>

namespace aomd::ui {

/// The bytes of the font file for "text", "heading" or "mono"; empty where it was missing.
[[nodiscard]] std::span<const unsigned char> embedded_font(std::string_view name);

}  // namespace aomd::ui
