#include "viewer/render/picture_target.h"

#include <string>

#include "viewer/render/framebuffer.h"

namespace aomd::render {

PictureTarget::PictureTarget(const Gl& gl, glm::ivec2 size) : gl_(gl), size_(size) {
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.GenRenderbuffers(1, &color_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, color_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.x, size.y);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  gl_.DeleteRenderbuffers(1, &color_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  throw GlError("cannot draw a picture of " + std::to_string(size.x) + "x" +
                std::to_string(size.y) + " pixels");
}

PictureTarget::~PictureTarget() {
  gl_.DeleteRenderbuffers(1, &color_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
}

io::Image PictureTarget::read(bool transparent) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  return read_pixels(gl_, size_, transparent);
}

}  // namespace aomd::render
