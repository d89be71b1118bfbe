#include "viewer/app/imgui_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>
#include <cctype>
#include <string>

namespace aomd::app {
namespace {

#if IMGUI_VERSION_NUM >= 18700
constexpr ImGuiKey keypad_enter = ImGuiKey_KeypadEnter;
#else
constexpr ImGuiKey keypad_enter = ImGuiKey_KeyPadEnter;
#endif

struct KeyRow {
  int glfw;
  ImGuiKey imgui;
  const char* name;  ///< in chords; null where the key prints something
};

// The keys that ImGui's widgets use and that every version knows.
constexpr std::array<KeyRow, 22> keys = {{
    {GLFW_KEY_TAB, ImGuiKey_Tab, "Tab"},
    {GLFW_KEY_LEFT, ImGuiKey_LeftArrow, "Left"},
    {GLFW_KEY_RIGHT, ImGuiKey_RightArrow, "Right"},
    {GLFW_KEY_UP, ImGuiKey_UpArrow, "Up"},
    {GLFW_KEY_DOWN, ImGuiKey_DownArrow, "Down"},
    {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown, "PageDown"},
    {GLFW_KEY_HOME, ImGuiKey_Home, "Home"},
    {GLFW_KEY_END, ImGuiKey_End, "End"},
    {GLFW_KEY_INSERT, ImGuiKey_Insert, "Insert"},
    {GLFW_KEY_DELETE, ImGuiKey_Delete, "Delete"},
    {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace, "Backspace"},
    {GLFW_KEY_SPACE, ImGuiKey_Space, "Space"},
    {GLFW_KEY_ENTER, ImGuiKey_Enter, "Enter"},
    {GLFW_KEY_KP_ENTER, keypad_enter, "Enter"},
    {GLFW_KEY_ESCAPE, ImGuiKey_Escape, "Escape"},
    {GLFW_KEY_A, ImGuiKey_A, nullptr},
    {GLFW_KEY_C, ImGuiKey_C, nullptr},
    {GLFW_KEY_V, ImGuiKey_V, nullptr},
    {GLFW_KEY_X, ImGuiKey_X, nullptr},
    {GLFW_KEY_Y, ImGuiKey_Y, nullptr},
    {GLFW_KEY_Z, ImGuiKey_Z, nullptr},
}};

const KeyRow* find_key(int glfw_key) {
  for (const KeyRow& row : keys)
    if (row.glfw == glfw_key) return &row;
  return nullptr;
}

std::string key_name(int glfw_key, const char* printed) {
  const KeyRow* row = find_key(glfw_key);
  if (row != nullptr && row->name != nullptr) return row->name;
  if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12)
    return std::string("F").append(std::to_string(glfw_key - GLFW_KEY_F1 + 1));
  if (printed == nullptr) return {};
  std::string name = printed;
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

}  // namespace

#if IMGUI_VERSION_NUM >= 18700

void prepare_keys(ImGuiIO&) {}

void send_key(ImGuiIO& io, int glfw_key, bool down) {
  if (const KeyRow* row = find_key(glfw_key)) io.AddKeyEvent(row->imgui, down);
}

void send_modifiers(ImGuiIO& io, int modifiers) {
#if IMGUI_VERSION_NUM >= 18900
  constexpr std::array modifier_keys = {ImGuiMod_Ctrl, ImGuiMod_Shift, ImGuiMod_Alt,
                                        ImGuiMod_Super};
#else
  constexpr std::array modifier_keys = {ImGuiKey_ModCtrl, ImGuiKey_ModShift, ImGuiKey_ModAlt,
                                        ImGuiKey_ModSuper};
#endif
  constexpr std::array bits = {GLFW_MOD_CONTROL, GLFW_MOD_SHIFT, GLFW_MOD_ALT, GLFW_MOD_SUPER};
  for (std::size_t i = 0; i < bits.size(); ++i)
    io.AddKeyEvent(static_cast<ImGuiKey>(modifier_keys[i]), (modifiers & bits[i]) != 0);
}

#else

void prepare_keys(ImGuiIO& io) {
  for (const KeyRow& row : keys) io.KeyMap[row.imgui] = row.glfw;
}

void send_key(ImGuiIO& io, int glfw_key, bool down) {
  if (glfw_key >= 0 && glfw_key < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[glfw_key] = down;
}

void send_modifiers(ImGuiIO& io, int modifiers) {
  io.KeyCtrl = (modifiers & GLFW_MOD_CONTROL) != 0;
  io.KeyShift = (modifiers & GLFW_MOD_SHIFT) != 0;
  io.KeyAlt = (modifiers & GLFW_MOD_ALT) != 0;
  io.KeySuper = (modifiers & GLFW_MOD_SUPER) != 0;
}

#endif

bool is_imgui_key(int glfw_key) { return find_key(glfw_key) != nullptr; }

std::string chord_name(int glfw_key, const char* printed, int modifiers) {
  std::string name = key_name(glfw_key, printed);
  if (name.empty()) return name;
  std::string prefix;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) prefix += "Ctrl+";
  if ((modifiers & GLFW_MOD_ALT) != 0) prefix += "Alt+";
  if ((modifiers & GLFW_MOD_SHIFT) != 0) prefix += "Shift+";
  if ((modifiers & GLFW_MOD_SUPER) != 0) prefix += "Super+";
  prefix += name;
  return prefix;
}

}  // namespace aomd::app
