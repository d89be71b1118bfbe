#include "viewer/render/framebuffer.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace aomd::render {

MultisampleTarget::MultisampleTarget(const Gl& gl, int samples) : gl_(gl) {
  GLint most = 1;
  gl_.GetIntegerv(GL_MAX_SAMPLES, &most);
  samples_ = std::clamp(samples, 1, std::max(1, most));
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.GenRenderbuffers(1, &color_);
  gl_.GenRenderbuffers(1, &depth_);
}

MultisampleTarget::~MultisampleTarget() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &color_);
  gl_.DeleteRenderbuffers(1, &depth_);
}

void MultisampleTarget::begin(glm::ivec2 size) {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (size != size_) allocate(size);
  gl_.Viewport(0, 0, size.x, size.y);
}

void MultisampleTarget::resolve(GLuint destination, const PixelRect& rect) {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, destination);
  gl_.BlitFramebuffer(0, 0, size_.x, size_.y, rect.x, rect.y, rect.x + rect.width,
                      rect.y + rect.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, destination);
}

void MultisampleTarget::allocate(glm::ivec2 size) {
  const auto storage = [&](GLuint renderbuffer, GLenum format, GLenum attachment) {
    const GLsizei samples = samples_ > 1 ? samples_ : 0;
    gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
  };
  storage(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  storage(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw GlError("this context cannot draw into a framebuffer with " + std::to_string(samples_) +
                  " samples");
  size_ = size;
}

namespace {

void divide_by_alpha(std::uint8_t* pixel) {
  const unsigned alpha = pixel[3];
  for (int c = 0; c < 3 && alpha > 0; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::min(255u, (255u * pixel[c] + alpha / 2) / alpha));
}

}  // namespace

io::Image read_pixels(const Gl& gl, glm::ivec2 size, bool transparent) {
  io::Image upside_down(size.x, size.y);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.rgba.data());
  io::Image image(size.x, size.y);
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(size.x);
  for (int y = 0; y < size.y; ++y)
    std::memcpy(image.pixel(0, y), upside_down.pixel(0, size.y - 1 - y), row_bytes);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (transparent)
      divide_by_alpha(&image.rgba[i]);
    else
      image.rgba[i + 3] = 255;
  }
  return image;
}

}  // namespace aomd::render
