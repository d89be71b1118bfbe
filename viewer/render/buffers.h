#pragma once
// Vertex buffers that follow the arrays of a Drawable.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "viewer/drawing/drawable.h"
#include "viewer/drawing/surface_texture.h"
#include "viewer/render/gl.h"

namespace aomd::render {

/// A buffer object that grows; its context must be current whenever a member runs.
class GrowingBuffer {
 public:
  explicit GrowingBuffer(const Gl& gl) : gl_(gl) { gl_.GenBuffers(1, &buffer_); }
  ~GrowingBuffer() { gl_.DeleteBuffers(1, &buffer_); }
  GrowingBuffer(const GrowingBuffer&) = delete;
  GrowingBuffer& operator=(const GrowingBuffer&) = delete;

  void bind() const { gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_); }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// See VertexBuffer::upload().
  template <typename T>
  std::size_t upload(scene::Patched<T>& array) {
    const std::size_t bytes = update(array.values().data(), array.size(), sizeof(T), array.dirty());
    array.clean();
    return bytes;
  }

 private:
  std::size_t update(const void* data, std::size_t count, std::size_t element_bytes,
                     std::span<const scene::ElementRange> dirty);

  const Gl& gl_;
  GLuint buffer_ = 0;
  std::size_t capacity_ = 0;
  std::size_t count_ = 0;
};

/// A buffer object with its vertex array; the context must be current whenever a member runs.
class VertexBuffer {
 public:
  explicit VertexBuffer(const Gl& gl);
  ~VertexBuffer();
  VertexBuffer(const VertexBuffer&) = delete;
  VertexBuffer& operator=(const VertexBuffer&) = delete;

  /// Brings the buffer up to date and makes the array clean. Uploads only the dirty ranges; all of
  /// it where the buffer had to grow (by half at least, so that growing is rare). Returns the bytes
  /// that travelled.
  template <typename T>
  std::size_t upload(scene::Patched<T>& array) {
    return elements_.upload(array);
  }
  void bind() const { gl_.BindVertexArray(vertex_array_); }
  [[nodiscard]] GLsizei count() const { return static_cast<GLsizei>(elements_.count()); }

 protected:
  /// For the constructors of derived classes: float or normalised components of an attribute.
  struct Attribute {
    GLuint index;
    GLint components;
    GLenum type;
    std::size_t offset;
  };
  void add(const Attribute& attribute, std::size_t stride, GLuint divisor) const;
  void add_integer(const Attribute& attribute, std::size_t stride) const;

  const Gl& gl_;

 private:
  GLuint vertex_array_ = 0;
  GrowingBuffer elements_;
};

class CornerBuffer : public VertexBuffer {
 public:
  explicit CornerBuffer(const Gl& gl);

  /// Places in pictures, of every corner or of none.
  std::size_t upload_places(scene::Patched<glm::vec2>& places);
  [[nodiscard]] bool has_places() const { return places_.count() > 0; }

 private:
  GrowingBuffer places_;
};

/// The pictures of one Drawable on the GPU, repeated beyond their rims.
class PictureTextures {
 public:
  explicit PictureTextures(const Gl& gl) : gl_(gl) {}
  ~PictureTextures() { clear(); }
  PictureTextures(const PictureTextures&) = delete;
  PictureTextures& operator=(const PictureTextures&) = delete;

  /// Uploads all of them where they are others than before.
  void upload(const std::shared_ptr<const scene::Pictures>& pictures);
  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  void bind(std::size_t i) const { gl_.BindTexture(GL_TEXTURE_2D, ids_[i]); }

 private:
  void clear();
  void add(const io::Image& image);

  const Gl& gl_;
  std::shared_ptr<const scene::Pictures> shown_;
  std::vector<GLuint> ids_;
};

class SegmentBuffer : public VertexBuffer {
 public:
  explicit SegmentBuffer(const Gl& gl);
};

class DiscBuffer : public VertexBuffer {
 public:
  explicit DiscBuffer(const Gl& gl);
};

/// The GPU's copy of an overlay.
struct OverlayBuffers {
  explicit OverlayBuffers(const Gl& gl) : faces(gl), lines(gl), discs(gl) {}
  std::size_t upload(scene::Overlay& overlay) {
    return faces.upload(overlay.faces) + lines.upload(overlay.lines) + discs.upload(overlay.discs);
  }
  CornerBuffer faces;
  SegmentBuffer lines;
  DiscBuffer discs;
};

/// The GPU's copy of one Drawable.
class DrawableBuffers {
 public:
  explicit DrawableBuffers(const Gl& gl);

  /// A surface of fewer faces is always drawn as it is.
  static constexpr std::size_t coarse_faces = 50'000;

  /// Uploads what changed since the last call; cost and traffic are proportional to that. The
  /// Drawable must be the same one at every call. With `coarse` a surface of many more faces than
  /// coarse_faces is drawn by about so many, made anew after each change; not where pictures lie on
  /// it.
  void upload(scene::Drawable& drawable, bool coarse = false);
  /// What is drawn of the surface.
  [[nodiscard]] const CornerBuffer& surface() const { return shows_coarse_ ? coarse_ : corners; }
  /// Bytes that the last upload sent.
  [[nodiscard]] std::size_t uploaded_bytes() const { return uploaded_bytes_; }

  CornerBuffer corners;
  PictureTextures pictures;
  CornerBuffer cells;
  SegmentBuffer interior_edges;
  SegmentBuffer model_edges;
  DiscBuffer model_vertices;
  SegmentBuffer highlight_lines;
  DiscBuffer highlight_discs;
  OverlayBuffers before, selected, hovered, preview, rulers, ground;
  glm::dvec3 origin{0};
  scene::Box bounds;

 private:
  [[nodiscard]] std::size_t upload_surface(scene::Drawable& drawable, bool coarse);

  CornerBuffer coarse_;
  bool shows_coarse_ = false;
  std::optional<std::uint64_t> coarse_of_;  ///< revision of the surface
  std::size_t uploaded_bytes_ = 0;
};

}  // namespace aomd::render
