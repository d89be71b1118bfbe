#pragma once
// What the windows without a window share.

#include <imgui.h>

#include "viewer/app/window.h"

namespace aomd::app {

/// A fixed size and no input. Derived classes own the context.
class HeadlessWindow : public Window {
 public:
  explicit HeadlessWindow(glm::ivec2 size) : size_(size) {}

  [[nodiscard]] glm::ivec2 size() const override { return size_; }
  [[nodiscard]] glm::ivec2 framebuffer_size() const override { return size_; }
  [[nodiscard]] float content_scale() const override { return 1.0f; }
  Events poll(ImGuiIO& io, double) override {
    io.DisplaySize = ImVec2(static_cast<float>(size_.x), static_cast<float>(size_.y));
    io.DisplayFramebufferScale = ImVec2(1, 1);
    io.DeltaTime = 1.0f / 60.0f;
    return {};
  }
  void present() override {}
  [[nodiscard]] bool should_close() const override { return false; }
  void cancel_close() override {}
  void set_title(const std::string&) override {}

 private:
  glm::ivec2 size_;
};

}  // namespace aomd::app
