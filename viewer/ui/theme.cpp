#include "viewer/ui/theme.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>

#include "viewer/ui/embedded_fonts.h"

namespace aomd::ui {
namespace {

constexpr float text_px = 15.5f;
constexpr float heading_px = 16.5f;
constexpr float mono_px = 14.0f;
constexpr float small_px = 12.5f;

/// Where Debian, Ubuntu, Fedora and Arch put a font, best first.
constexpr std::array text_files = {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
                                   "/usr/share/fonts/inter/Inter-Regular.otf",
                                   "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf",
                                   "/usr/share/fonts/open-sans/OpenSans-Regular.ttf",
                                   "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                   "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                   "/usr/share/fonts/TTF/DejaVuSans.ttf"};
constexpr std::array heading_files = {"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
                                      "/usr/share/fonts/inter/Inter-SemiBold.otf",
                                      "/usr/share/fonts/truetype/open-sans/OpenSans-Semibold.ttf",
                                      "/usr/share/fonts/open-sans/OpenSans-Semibold.ttf",
                                      "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
                                      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf",
                                      "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"};
constexpr std::array mono_files = {
    "/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
    "/usr/share/fonts/TTF/DejaVuSansMono.ttf"};

// Latin, punctuation, arrows, and the signs that panels use. ImGui keeps the pointer.
constexpr std::array<ImWchar, 17> glyph_ranges = {0x0020, 0x00ff, 0x0394, 0x0394, 0x03b1, 0x03b8,
                                                  0x2010, 0x2026, 0x2070, 0x2089, 0x2190, 0x2193,
                                                  0x2212, 0x2212, 0x2248, 0x2265, 0};

/// The font that is part of the program, else the first file that is there, else ImGui's own.
template <std::size_t N>
ImFont* add_font(ImFontAtlas& atlas, std::string_view name, const std::array<const char*, N>& files,
                 float size_px) {
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  if (const auto bytes = embedded_font(name); !bytes.empty()) {
    config.FontDataOwnedByAtlas = false;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): ImGui reads it only
    void* data = const_cast<unsigned char*>(bytes.data());
    return atlas.AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()), size_px, &config,
                                      glyph_ranges.data());
  }
  std::error_code ignored;
  for (const char* file : files)
    if (std::filesystem::is_regular_file(file, ignored))
      if (ImFont* font = atlas.AddFontFromFileTTF(file, size_px, &config, glyph_ranges.data()))
        return font;
  config = ImFontConfig();
  config.SizePixels = std::round(size_px * 13.0f / text_px);
  return atlas.AddFontDefault(&config);
}

ImVec4 color(unsigned hex, float alpha = 1.0f) {
  return {static_cast<float>(hex >> 16 & 0xffu) / 255.0f,
          static_cast<float>(hex >> 8 & 0xffu) / 255.0f, static_cast<float>(hex & 0xffu) / 255.0f,
          alpha};
}

ImVec4 fade(ImVec4 c, float alpha) { return {c.x, c.y, c.z, alpha}; }

ImVec4 mix(ImVec4 a, ImVec4 b, float t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t,
          a.w + (b.w - a.w) * t};
}

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {12, 10};
  style.FramePadding = {9, 5};
  style.CellPadding = {6, 4};
  style.ItemSpacing = {8, 7};
  style.ItemInnerSpacing = {7, 5};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 12;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.ChildBorderSize = 0;
  style.FrameBorderSize = 1;
  style.WindowRounding = 6;
  style.ChildRounding = 6;
  style.PopupRounding = 6;
  style.FrameRounding = 5;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.TabRounding = 5;
  style.WindowTitleAlign = {0.0f, 0.5f};
  style.SelectableTextAlign = {0.0f, 0.5f};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.DisabledAlpha = 0.45f;
}

/// What differs between light and dark beyond ThemeColors.
struct Surfaces {
  ImVec4 window;  ///< behind panels' content
  ImVec4 popup;
  ImVec4 field;  ///< an input, a slider's groove
  ImVec4 button;
  ImVec4 title;
  ImVec4 on_accent;  ///< a mark drawn on the accent colour
};

Surfaces surfaces(ThemeKind kind) {
  if (kind == ThemeKind::Light)
    return {color(0xfbfcfd, 0.97f), color(0xffffff), color(0xeef1f5),
            color(0xffffff),        color(0xf1f4f7), color(0xffffff)};
  return {color(0x1c2026, 0.96f), color(0x22272e), color(0x14171b),
          color(0x2b313a),        color(0x181b20), color(0xffffff)};
}

void set_text_colors(ImVec4* c, const ThemeColors& t) {
  c[ImGuiCol_Text] = t.text;
  c[ImGuiCol_TextDisabled] = t.text_muted;
  c[ImGuiCol_TextSelectedBg] = fade(t.accent, 0.30f);
  c[ImGuiCol_Border] = t.border;
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_Separator] = t.border;
  c[ImGuiCol_SeparatorHovered] = fade(t.accent, 0.6f);
  c[ImGuiCol_SeparatorActive] = t.accent;
  c[ImGuiCol_DragDropTarget] = t.accent;
  c[ImGuiCol_PlotLines] = t.accent;
  c[ImGuiCol_PlotLinesHovered] = t.warning;
  c[ImGuiCol_PlotHistogram] = t.accent;
  c[ImGuiCol_PlotHistogramHovered] = t.warning;
}

void set_surface_colors(ImVec4* c, const ThemeColors& t, const Surfaces& s) {
  c[ImGuiCol_WindowBg] = s.window;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = s.popup;
  c[ImGuiCol_MenuBarBg] = s.title;
  c[ImGuiCol_TitleBg] = s.title;
  c[ImGuiCol_TitleBgActive] = s.title;
  c[ImGuiCol_TitleBgCollapsed] = s.title;
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = fade(t.text_muted, 0.35f);
  c[ImGuiCol_ScrollbarGrabHovered] = fade(t.text_muted, 0.55f);
  c[ImGuiCol_ScrollbarGrabActive] = fade(t.text_muted, 0.75f);
  c[ImGuiCol_TableHeaderBg] = s.title;
  c[ImGuiCol_TableBorderStrong] = t.border;
  c[ImGuiCol_TableBorderLight] = fade(t.border, 0.5f * t.border.w);
  c[ImGuiCol_TableRowBg] = {0, 0, 0, 0};
  c[ImGuiCol_TableRowBgAlt] = fade(t.text_muted, 0.06f);
  c[ImGuiCol_ModalWindowDimBg] = {0.05f, 0.06f, 0.08f, 0.45f};
}

void set_control_colors(ImVec4* c, const ThemeColors& t, const Surfaces& s) {
  c[ImGuiCol_FrameBg] = s.field;
  c[ImGuiCol_FrameBgHovered] = mix(s.field, t.accent, 0.10f);
  c[ImGuiCol_FrameBgActive] = mix(s.field, t.accent, 0.18f);
  c[ImGuiCol_Button] = s.button;
  c[ImGuiCol_ButtonHovered] = mix(s.button, t.accent, 0.14f);
  c[ImGuiCol_ButtonActive] = mix(s.button, t.accent, 0.30f);
  c[ImGuiCol_Header] = fade(t.accent, 0.16f);
  c[ImGuiCol_HeaderHovered] = fade(t.accent, 0.22f);
  c[ImGuiCol_HeaderActive] = fade(t.accent, 0.32f);
  c[ImGuiCol_CheckMark] = t.accent;
  c[ImGuiCol_SliderGrab] = t.accent;
  c[ImGuiCol_SliderGrabActive] = mix(t.accent, s.on_accent, 0.15f);
  c[ImGuiCol_ResizeGrip] = {0, 0, 0, 0};
  c[ImGuiCol_ResizeGripHovered] = fade(t.accent, 0.4f);
  c[ImGuiCol_ResizeGripActive] = fade(t.accent, 0.7f);
  c[ImGuiCol_Tab] = s.title;
  c[ImGuiCol_TabHovered] = fade(t.accent, 0.25f);
  c[ImGuiCol_NavWindowingHighlight] = fade(t.accent, 0.7f);
  c[ImGuiCol_NavWindowingDimBg] = {0, 0, 0, 0.2f};
#if IMGUI_VERSION_NUM >= 19140
  c[ImGuiCol_NavCursor] = t.accent;
#else
  c[ImGuiCol_NavHighlight] = t.accent;
#endif
#if IMGUI_VERSION_NUM >= 19090
  c[ImGuiCol_TabSelected] = mix(s.title, t.accent, 0.22f);
  c[ImGuiCol_TabDimmed] = s.title;
  c[ImGuiCol_TabDimmedSelected] = mix(s.title, t.accent, 0.14f);
#else
  c[ImGuiCol_TabActive] = mix(s.title, t.accent, 0.22f);
  c[ImGuiCol_TabUnfocused] = s.title;
  c[ImGuiCol_TabUnfocusedActive] = mix(s.title, t.accent, 0.14f);
#endif
}

}  // namespace

Fonts load_fonts(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  Fonts fonts;
  fonts.text = add_font(atlas, "text", text_files, std::round(text_px * scale * 2.0f) / 2.0f);
  fonts.heading =
      add_font(atlas, "heading", heading_files, std::round(heading_px * scale * 2.0f) / 2.0f);
  fonts.mono = add_font(atlas, "mono", mono_files, std::round(mono_px * scale * 2.0f) / 2.0f);
  fonts.small = add_font(atlas, "text", text_files, std::round(small_px * scale * 2.0f) / 2.0f);
  ImGui::GetIO().FontDefault = fonts.text;
  return fonts;
}

void apply_theme(ThemeKind kind, float scale) {
  ImGuiStyle style;
  set_sizes(style);
  style.ScaleAllSizes(scale);
  const ThemeColors theme = theme_colors(kind);
  const Surfaces s = surfaces(kind);
  kind == ThemeKind::Light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
  set_text_colors(style.Colors, theme);
  set_surface_colors(style.Colors, theme, s);
  set_control_colors(style.Colors, theme, s);
  ImGui::GetStyle() = style;
}

ThemeColors theme_colors(ThemeKind kind) {
  if (kind == ThemeKind::Light)
    return {.accent = color(0x1769aa),
            .text = color(0x1c2430),
            .text_muted = color(0x667181),
            .panel = color(0xfbfcfd),
            .border = color(0xcfd6de),
            .good = color(0x00805c),
            .warning = color(0xb36b00),
            .bad = color(0xb83a1b)};
  return {.accent = color(0x4fa8e8),
          .text = color(0xe4e8ed),
          .text_muted = color(0x8b95a3),
          .panel = color(0x1c2026),
          .border = color(0x363d47),
          .good = color(0x3cc69a),
          .warning = color(0xf0b043),
          .bad = color(0xf0795a)};
}

render::SceneTheme scene_theme(ThemeKind kind) {
  return kind == ThemeKind::Light ? render::light_scene_theme() : render::dark_scene_theme();
}

}  // namespace aomd::ui
