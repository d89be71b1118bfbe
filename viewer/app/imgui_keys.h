#pragma once
// Keys: from GLFW to ImGui, before and after ImGui 1.87, and to the names that shortcuts are
// written in.

#include <string>

struct ImGuiIO;

namespace aomd::app {

/// Once per ImGui context. Does nothing from ImGui 1.87 on.
void prepare_keys(ImGuiIO& io);

/// Whether ImGui looks at this key; all others matter as text or as chords only.
[[nodiscard]] bool is_imgui_key(int glfw_key);

/// Tells ImGui that a key went down or up.
void send_key(ImGuiIO& io, int glfw_key, bool down);

/// Tells ImGui which modifiers are held: a set of GLFW_MOD bits.
void send_modifiers(ImGuiIO& io, int modifiers);

/// "Ctrl+Shift+Z", "Space", "F1"; empty for a modifier alone and for keys without a name. `printed`
/// is what the key prints without modifiers in the user's layout (glfwGetKeyName), or null.
/// Modifiers come in the order Ctrl, Alt, Shift, Super. Named keys: Tab Left Right Up Down PageUp
/// PageDown Home End Insert Delete Backspace Space Enter Escape F1 to F12.
[[nodiscard]] std::string chord_name(int glfw_key, const char* printed, int modifiers);

}  // namespace aomd::app
