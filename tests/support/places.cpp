#include "tests/support/places.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/ui/interface.h"

namespace aomd::test {
namespace {

/// An interface with a mouse and no picture.
class Twin {
 public:
  Twin(scene::Session& session, glm::ivec2 size)
      : session_(session), context_(ImGui::CreateContext()), fonts_(ui::load_fonts(1)) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(static_cast<float>(size.x), static_cast<float>(size.y));
    io.DeltaTime = 1.0f / 60.0f;
    io.MouseDoubleClickTime = 0;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    ui::apply_theme(ui::theme_kind(session.view.theme), 1);
    session.refresh();
    for (int i = 0; i < 3; ++i) (void)frame({-1, -1}, false);
  }
  ~Twin() { ImGui::DestroyContext(context_); }
  Twin(const Twin&) = delete;
  Twin& operator=(const Twin&) = delete;

  std::vector<std::string> frame(glm::ivec2 mouse, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    const ImVec2 at(static_cast<float>(mouse.x), static_cast<float>(mouse.y));
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(at.x, at.y);
    io.AddMouseButtonEvent(0, down);
#else
    io.MousePos = at;
    io.MouseDown[0] = down;
#endif
    ImGui::NewFrame();
    std::vector<std::string> lines = interface_.draw(session_, fonts_);
    ImGui::Render();
    return lines;
  }

  bool click_emits(glm::ivec2 at, std::string_view line) {
    bool found = false;
    // A click beside it has closed the picture's menu: it opens again.
    for (int i = 0; i < 3 && session_.view.menu; ++i) (void)frame(at, false);
    for (const bool down : {false, true, false}) {
      const std::vector<std::string> lines = frame(at, down);
      found = found || std::find(lines.begin(), lines.end(), line) != lines.end();
    }
    return found;
  }

  [[nodiscard]] const ui::Layout& layout() const { return interface_.layout(); }

 private:
  scene::Session& session_;
  ImGuiContext* context_;
  ui::Fonts fonts_;
  ui::Interface interface_;
};

}  // namespace

ui::Layout layout_of(scene::Session& session, glm::ivec2 size) {
  return Twin(session, size).layout();
}

std::optional<glm::ivec2> place_of(scene::Session& session, glm::ivec2 size, std::string_view line,
                                   const ui::Area& area) {
  constexpr glm::ivec2 step{24, 9};  // smaller than any button
  Twin twin(session, size);
  const glm::ivec2 from(static_cast<int>(area.position.x), static_cast<int>(area.position.y));
  const glm::ivec2 extent(static_cast<int>(area.size.x), static_cast<int>(area.size.y));
  for (int y = step.y; y < extent.y; y += step.y)
    for (int x = step.x; x < extent.x; x += step.x)
      if (twin.click_emits(from + glm::ivec2(x, y), line)) return from + glm::ivec2(x, y);
  return {};
}

}  // namespace aomd::test
