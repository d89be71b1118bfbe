#pragma once
// A plain framebuffer of any size, for pictures that are not the window's.

#include <glm/vec2.hpp>

#include "core/io/png.h"
#include "viewer/render/gl.h"

namespace aomd::render {

/// Colour only. Throws GlError where the context refuses the size.
class PictureTarget {
 public:
  PictureTarget(const Gl& gl, glm::ivec2 size);
  ~PictureTarget();
  PictureTarget(const PictureTarget&) = delete;
  PictureTarget& operator=(const PictureTarget&) = delete;

  [[nodiscard]] GLuint framebuffer() const { return framebuffer_; }
  /// What was drawn, rows from top to bottom; see read_pixels().
  [[nodiscard]] io::Image read(bool transparent = false) const;

 private:
  const Gl& gl_;
  glm::ivec2 size_;
  GLuint framebuffer_ = 0;
  GLuint color_ = 0;
};

}  // namespace aomd::render
