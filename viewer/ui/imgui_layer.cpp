#include "viewer/ui/imgui_layer.h"

#include <cstddef>
#include <cstdint>

namespace aomd::ui {
namespace {

// NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes offsets as pointers
const void* as_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

// ImTextureID is a pointer up to ImGui 1.91.3 and an integer afterwards; only this kind of cast
// fits both.
// NOLINTBEGIN(performance-no-int-to-ptr,cppcoreguidelines-pro-type-cstyle-cast)
ImTextureID to_id(GLuint texture) { return (ImTextureID)(std::intptr_t)texture; }
GLuint from_id(ImTextureID id) { return (GLuint)(std::intptr_t)id; }
// NOLINTEND(performance-no-int-to-ptr,cppcoreguidelines-pro-type-cstyle-cast)

}  // namespace

ImGuiLayer::ImGuiLayer(const render::Gl& gl, render::ShaderProgram& program)
    : gl_(gl), program_(program) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "aomd";
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(1, &vertices_);
  gl_.GenBuffers(1, &indices_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  constexpr GLsizei stride = sizeof(ImDrawVert);
  for (GLuint i = 0; i < 3; ++i) gl_.EnableVertexAttribArray(i);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, as_offset(offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, as_offset(offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          as_offset(offsetof(ImDrawVert, col)));
  update_fonts();
}

ImGuiLayer::~ImGuiLayer() {
  gl_.DeleteTextures(1, &font_texture_);
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteBuffers(1, &indices_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

void ImGuiLayer::update_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  if (font_texture_ == 0) gl_.GenTextures(1, &font_texture_);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, font_texture_);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  atlas.SetTexID(to_id(font_texture_));
  atlas.ClearTexData();
}

void ImGuiLayer::draw(const ImDrawData& data, GLuint destination) {
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, destination);
  set_state(data);
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

void ImGuiLayer::set_state(const ImDrawData& data) {
  gl_.Viewport(0, 0, static_cast<GLsizei>(data.DisplaySize.x * data.FramebufferScale.x),
               static_cast<GLsizei>(data.DisplaySize.y * data.FramebufferScale.y));
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.ActiveTexture(GL_TEXTURE0);
  program_.use();
  program_.set("atlas", 0);
  const glm::vec2 scale(2.0f / data.DisplaySize.x, -2.0f / data.DisplaySize.y);
  program_.set("scale_offset", glm::vec4(scale, -1.0f - data.DisplayPos.x * scale.x,
                                         1.0f - data.DisplayPos.y * scale.y));
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
}

void ImGuiLayer::draw_list(const ImDrawList& list, const ImDrawData& data) {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data,
                 GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                 GL_STREAM_DRAW);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback == nullptr)
      draw_command(command, data);
    else if (command.UserCallback == ImDrawCallback_ResetRenderState)
      set_state(data);
    else
      command.UserCallback(&list, &command);
  }
}

void ImGuiLayer::draw_command(const ImDrawCmd& command, const ImDrawData& data) const {
  const ImVec2 scale = data.FramebufferScale;
  const int height = static_cast<int>(data.DisplaySize.y * scale.y);
  const int left = static_cast<int>((command.ClipRect.x - data.DisplayPos.x) * scale.x);
  const int top = static_cast<int>((command.ClipRect.y - data.DisplayPos.y) * scale.y);
  const int right = static_cast<int>((command.ClipRect.z - data.DisplayPos.x) * scale.x);
  const int bottom = static_cast<int>((command.ClipRect.w - data.DisplayPos.y) * scale.y);
  if (right <= left || bottom <= top) return;
  gl_.Scissor(left, height - bottom, right - left, bottom - top);
  gl_.BindTexture(GL_TEXTURE_2D, from_id(command.GetTexID()));
  gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                             sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                             as_offset(command.IdxOffset * sizeof(ImDrawIdx)),
                             static_cast<GLint>(command.VtxOffset));
}

}  // namespace aomd::ui
