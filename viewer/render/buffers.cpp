#include "viewer/render/buffers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "viewer/drawing/coarse_surface.h"

namespace aomd::render {
namespace {

// NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes offsets as pointers
const void* as_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

VertexBuffer::VertexBuffer(const Gl& gl) : gl_(gl) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(1, &buffer_);
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
}

VertexBuffer::~VertexBuffer() {
  gl_.DeleteBuffers(1, &buffer_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

void VertexBuffer::add(const Attribute& attribute, std::size_t stride, GLuint divisor) const {
  const GLboolean normalized = attribute.type == GL_FLOAT ? GL_FALSE : GL_TRUE;
  gl_.EnableVertexAttribArray(attribute.index);
  gl_.VertexAttribPointer(attribute.index, attribute.components, attribute.type, normalized,
                          static_cast<GLsizei>(stride), as_offset(attribute.offset));
  gl_.VertexAttribDivisor(attribute.index, divisor);
}

void VertexBuffer::add_integer(const Attribute& attribute, std::size_t stride) const {
  gl_.EnableVertexAttribArray(attribute.index);
  gl_.VertexAttribIPointer(attribute.index, attribute.components, attribute.type,
                           static_cast<GLsizei>(stride), as_offset(attribute.offset));
}

std::size_t VertexBuffer::update(const void* data, std::size_t count, std::size_t element_bytes,
                                 std::span<const scene::ElementRange> dirty) {
  count_ = count;
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  const auto* bytes = static_cast<const std::byte*>(data);
  const auto send = [&](scene::ElementRange range) {
    gl_.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(range.begin * element_bytes),
                      static_cast<GLsizeiptr>(range.size() * element_bytes),
                      bytes + range.begin * element_bytes);
    return range.size() * element_bytes;
  };
  if (count > capacity_) {
    capacity_ = capacity_ == 0 ? count : std::max(count, capacity_ + capacity_ / 2);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capacity_ * element_bytes), nullptr,
                   GL_DYNAMIC_DRAW);
    return send({0, count});
  }
  std::size_t sent = 0;
  for (const scene::ElementRange& range : dirty) sent += send(range);
  return sent;
}

CornerBuffer::CornerBuffer(const Gl& gl) : VertexBuffer(gl) {
  using scene::Corner;
  add({0, 3, GL_FLOAT, offsetof(Corner, position)}, sizeof(Corner), 0);
  add({1, 4, GL_INT_2_10_10_10_REV, offsetof(Corner, normal)}, sizeof(Corner), 0);
  add({2, 4, GL_UNSIGNED_BYTE, offsetof(Corner, color)}, sizeof(Corner), 0);
  add_integer({3, 1, GL_UNSIGNED_INT, offsetof(Corner, flags)}, sizeof(Corner));
}

SegmentBuffer::SegmentBuffer(const Gl& gl) : VertexBuffer(gl) {
  using scene::Segment;
  add({0, 3, GL_FLOAT, offsetof(Segment, a)}, sizeof(Segment), 1);
  add({1, 3, GL_FLOAT, offsetof(Segment, b)}, sizeof(Segment), 1);
  add({2, 4, GL_UNSIGNED_BYTE, offsetof(Segment, color)}, sizeof(Segment), 1);
  add({3, 1, GL_FLOAT, offsetof(Segment, width_px)}, sizeof(Segment), 1);
}

// A disc is a line from its centre to its centre.
DiscBuffer::DiscBuffer(const Gl& gl) : VertexBuffer(gl) {
  using scene::Disc;
  for (const GLuint end : {0u, 1u})
    add({end, 3, GL_FLOAT, offsetof(Disc, center)}, sizeof(Disc), 1);
  add({2, 4, GL_UNSIGNED_BYTE, offsetof(Disc, color)}, sizeof(Disc), 1);
  add({3, 1, GL_FLOAT, offsetof(Disc, radius_px)}, sizeof(Disc), 1);
  add({4, 1, GL_FLOAT, offsetof(Disc, room)}, sizeof(Disc), 1);
}

DrawableBuffers::DrawableBuffers(const Gl& gl)
    : corners(gl),
      cells(gl),
      interior_edges(gl),
      model_edges(gl),
      model_vertices(gl),
      highlight_lines(gl),
      highlight_discs(gl),
      before(gl),
      selected(gl),
      hovered(gl),
      preview(gl),
      rulers(gl),
      ground(gl),
      coarse_(gl) {}

std::size_t DrawableBuffers::upload_surface(scene::Drawable& drawable, bool coarse) {
  const std::size_t faces = drawable.corners.size() / 3;
  shows_coarse_ = coarse && faces > 2 * coarse_faces;
  if (!shows_coarse_) return corners.upload(drawable.corners);
  if (coarse_of_ == drawable.corners.revision()) return 0;
  coarse_of_ = drawable.corners.revision();
  scene::Patched<scene::Corner> fewer;
  fewer.assign(scene::coarse_corners(drawable.corners.values(), coarse_faces));
  return coarse_.upload(fewer);
}

void DrawableBuffers::upload(scene::Drawable& drawable, bool coarse) {
  origin = drawable.origin;
  bounds = drawable.ground.lines.empty() ? drawable.bounds : drawable.ground_bounds;
  uploaded_bytes_ = upload_surface(drawable, coarse) + cells.upload(drawable.cells) +
                    interior_edges.upload(drawable.interior_edges) +
                    model_edges.upload(drawable.model_edges) +
                    model_vertices.upload(drawable.model_vertices) +
                    highlight_lines.upload(drawable.highlight_lines) +
                    highlight_discs.upload(drawable.highlight_discs) +
                    before.upload(drawable.before) + selected.upload(drawable.selected) +
                    hovered.upload(drawable.hovered) + preview.upload(drawable.preview) +
                    rulers.upload(drawable.rulers) + ground.upload(drawable.ground);
}

}  // namespace aomd::render
