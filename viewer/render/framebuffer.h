#pragma once
// An offscreen target with several samples a pixel, and the way back to main memory.

#include <glm/vec2.hpp>

#include "core/io/png.h"
#include "viewer/render/gl.h"

namespace aomd::render {

/// A rectangle of a framebuffer in pixels, from its lower left corner, as GL counts.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] double aspect() const {
    return height > 0 ? static_cast<double>(width) / height : 1.0;
  }
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Colour and depth with up to `samples` samples. Window and screenshot both draw the scene here,
/// so that they agree whatever the window's own framebuffer can do.
class MultisampleTarget {
 public:
  MultisampleTarget(const Gl& gl, int samples);
  ~MultisampleTarget();
  MultisampleTarget(const MultisampleTarget&) = delete;
  MultisampleTarget& operator=(const MultisampleTarget&) = delete;

  /// Binds it for drawing, made anew where the size changed. Throws GlError where the context
  /// refuses.
  void begin(glm::ivec2 size);
  /// Resolves the samples into `rect` of framebuffer `destination`, which stays bound for drawing.
  /// rect's size is that of begin().
  void resolve(GLuint destination, const PixelRect& rect);
  /// Samples a pixel that the context gives, 1 where it has no multisampling.
  [[nodiscard]] int samples() const { return samples_; }

 private:
  void allocate(glm::ivec2 size);

  const Gl& gl_;
  int samples_ = 1;
  glm::ivec2 size_{0};
  GLuint framebuffer_ = 0;
  GLuint color_ = 0;
  GLuint depth_ = 0;
};

/// Reads the framebuffer that is bound for reading. Rows from top to bottom. Opaque whatever its
/// alpha says, unless `transparent`: then its colours, which are multiplied by alpha, are divided
/// by it.
[[nodiscard]] io::Image read_pixels(const Gl& gl, glm::ivec2 size, bool transparent = false);

}  // namespace aomd::render
