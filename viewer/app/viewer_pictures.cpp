// Pictures of a viewer: with panels, or of the scene alone.

#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "core/io/png.h"
#include "viewer/app/viewer.h"
#include "viewer/render/picture_target.h"

namespace aomd::app {
namespace {

constexpr int frames_of_picture = 3;
constexpr double usual_height_px = 1080;

/// Lines of one pixel are lost in a picture that is looked at as a whole and has many.
double scale_for(glm::ivec2 size) {
  return std::max(1.0, std::min(size.x, size.y) / usual_height_px);
}

}  // namespace

/// Other than in a window that grows, nothing that was in sight may be cut off in a picture.
scene::Camera Viewer::camera_for(double before, double now) const {
  scene::Camera camera = session_.view.camera;
  camera.distance *= std::max(1.0, farther(before, now));
  return camera;
}

io::Image Viewer::picture(glm::ivec2 size, bool transparent, double scale) {
  ImGuiIO& io = ImGui::GetIO();
  picture_scale_ = scale;
  moving_ = false;
  const scene::Camera camera = session_.view.camera;
  const double aspect = session_.view.aspect;
  const ImVec2 display = io.DisplaySize;
  const ImVec2 framebuffer = io.DisplayFramebufferScale;
  const ImVec2 mouse = io.MousePos;
  io.DisplaySize = ImVec2(static_cast<float>(size.x) / framebuffer.x,
                          static_cast<float>(size.y) / framebuffer.y);
  io.MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
  const render::PictureTarget target(gl_, size);
  for (int i = 1; i < frames_of_picture; ++i) lay_out_frame();
  const double now = session_.view.aspect;
  session_.view.camera = camera;
  session_.view.camera = camera_for(aspect, now);
  draw_frame(size, target.framebuffer(), transparent);
  lines_.clear();
  io::Image image = target.read(transparent);
  session_.view.camera = camera;
  session_.view.aspect = aspect;
  picture_scale_ = 1;
  io.DisplaySize = display;
  io.MousePos = mouse;
  return image;
}

io::Image Viewer::scene_picture(glm::ivec2 size, bool transparent, double scale) {
  session_.refresh();
  picture_scale_ = scale;
  moving_ = false;
  const double aspect = static_cast<double>(size.x) / size.y;
  const scene::Camera before = session_.view.camera;
  session_.view.camera = camera_for(session_.view.aspect, aspect);
  const render::PictureTarget target(gl_, size);
  draw_scene(session_.view.camera, {0, 0, size.x, size.y}, target.framebuffer(), transparent);
  draw_scales(size, target.framebuffer());
  picture_scale_ = 1;
  session_.view.camera = before;
  return target.read(transparent);
}

/// What belongs to a picture though panels do not.
void Viewer::draw_scales(glm::ivec2 size, GLuint destination) {
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 display = io.DisplaySize;
  io.DisplaySize = ImVec2(static_cast<float>(size.x) / io.DisplayFramebufferScale.x,
                          static_cast<float>(size.y) / io.DisplayFramebufferScale.y);
  update_look();
  ImGui::NewFrame();
  interface_.draw_scales(session_, fonts_);
  ImGui::Render();
  layer_.draw(*ImGui::GetDrawData(), destination);
  io.DisplaySize = display;
}

void Viewer::take_screenshots() {
  while (!session_.screenshots.empty()) {
    const scene::ScreenshotRequest request = session_.screenshots.front();
    session_.screenshots.pop_front();
    const glm::ivec2 size = request.size.value_or(window_.framebuffer_size());
    const double scale = request.scale.value_or(request.interface ? 1 : scale_for(size));
    io::write_png(request.file,
                  request.interface ? picture(size, request.transparent, scale)
                                    : scene_picture(size, request.transparent, scale));
    if (session_.series() == nullptr) session_.status = "Saved " + request.file.string();
  }
  session_.advance_series();
}

void Viewer::take_screenshots_or_tell() {
  try {
    take_screenshots();
  } catch (const std::exception& error) {
    session_.cancel_series();
    session_.screenshots.clear();
    session_.error = error.what();
  }
}

}  // namespace aomd::app
