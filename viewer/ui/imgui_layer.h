#pragma once
// Draws ImGui's lists with our own GL table: the same in a window and without one.

#include <imgui.h>

#include "viewer/render/framebuffer.h"
#include "viewer/render/gl.h"
#include "viewer/render/shader_program.h"

namespace aomd::ui {

/// The back end that draws: buffers and the font atlas of the current ImGui context. Both
/// contexts must be current whenever a member runs. Works with ImGui 1.86 to 1.91; callbacks in
/// draw lists are called, ImDrawCallback_ResetRenderState sets our state again.
class ImGuiLayer {
 public:
  /// Builds and uploads the font atlas as it is now. `program` is that of the shader "ui".
  ImGuiLayer(const render::Gl& gl, render::ShaderProgram& program);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  /// Uploads the atlas again: after fonts or the scale changed.
  void update_fonts();
  /// Draws over what framebuffer `destination` holds. Takes what ImGui::GetDrawData() returns after
  /// ImGui::Render().
  void draw(const ImDrawData& data, GLuint destination = 0);

 private:
  void set_state(const ImDrawData& data);
  void draw_list(const ImDrawList& list, const ImDrawData& data);
  void draw_command(const ImDrawCmd& command, const ImDrawData& data) const;

  const render::Gl& gl_;
  render::ShaderProgram& program_;
  GLuint vertex_array_ = 0;
  GLuint vertices_ = 0;
  GLuint indices_ = 0;
  GLuint font_texture_ = 0;
};

}  // namespace aomd::ui
