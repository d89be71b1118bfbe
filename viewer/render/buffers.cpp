#include "viewer/render/buffers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "viewer/drawing/coarse_surface.h"

namespace aomd::render {
namespace {

// NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes offsets as pointers
const void* as_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

/// Half as wide and high: each pixel is the mean of four, or of those that there are.
io::Image halved(const io::Image& image) {
  io::Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int k = 0; k < 4; ++k) {
        const int right = std::min(2 * x + 1, image.width - 1);
        const int below = std::min(2 * y + 1, image.height - 1);
        const int sum = image.pixel(2 * x, 2 * y)[k] + image.pixel(right, 2 * y)[k] +
                        image.pixel(2 * x, below)[k] + image.pixel(right, below)[k];
        half.pixel(x, y)[k] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
  return half;
}

}  // namespace

VertexBuffer::VertexBuffer(const Gl& gl) : gl_(gl), elements_(gl) {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.BindVertexArray(vertex_array_);
  elements_.bind();
}

VertexBuffer::~VertexBuffer() { gl_.DeleteVertexArrays(1, &vertex_array_); }

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

std::size_t GrowingBuffer::update(const void* data, std::size_t count, std::size_t element_bytes,
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

CornerBuffer::CornerBuffer(const Gl& gl) : VertexBuffer(gl), places_(gl) {
  using scene::Corner;
  add({0, 3, GL_FLOAT, offsetof(Corner, position)}, sizeof(Corner), 0);
  add({1, 4, GL_INT_2_10_10_10_REV, offsetof(Corner, normal)}, sizeof(Corner), 0);
  add({2, 4, GL_UNSIGNED_BYTE, offsetof(Corner, color)}, sizeof(Corner), 0);
  add_integer({3, 1, GL_UNSIGNED_INT, offsetof(Corner, flags)}, sizeof(Corner));
}

std::size_t CornerBuffer::upload_places(scene::Patched<glm::vec2>& places) {
  constexpr GLuint index = 4;
  const std::size_t sent = places_.upload(places);
  bind();
  places_.bind();
  if (has_places())
    add({index, 2, GL_FLOAT, 0}, sizeof(glm::vec2), 0);
  else
    gl_.DisableVertexAttribArray(index);
  return sent;
}

void PictureTextures::upload(const std::shared_ptr<const scene::Pictures>& pictures) {
  if (pictures == shown_) return;
  clear();
  shown_ = pictures;
  if (!pictures) return;
  GLint most = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  for (const io::Image& image : pictures->images) {
    io::Image smaller;
    const io::Image* shown = &image;
    while (std::max(shown->width, shown->height) > most) {
      smaller = halved(*shown);
      shown = &smaller;
    }
    add(*shown);
  }
}

void PictureTextures::clear() {
  if (!ids_.empty()) gl_.DeleteTextures(static_cast<GLsizei>(ids_.size()), ids_.data());
  ids_.clear();
}

/// One that cannot be had is white, so that the colour of the material shows.
void PictureTextures::add(const io::Image& image) {
  constexpr std::uint8_t white[] = {255, 255, 255, 255};
  const bool known = !image.empty();
  GLuint id = 0;
  gl_.GenTextures(1, &id);
  ids_.push_back(id);
  gl_.BindTexture(GL_TEXTURE_2D, id);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, known ? image.width : 1, known ? image.height : 1, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, known ? image.rgba.data() : white);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.GenerateMipmap(GL_TEXTURE_2D);
  gl_.BindTexture(GL_TEXTURE_2D, 0);
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
      pictures(gl),
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
  shows_coarse_ = coarse && drawable.places.empty() && faces > 2 * coarse_faces;
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
  pictures.upload(drawable.pictures);
  uploaded_bytes_ = upload_surface(drawable, coarse) + corners.upload_places(drawable.places) +
                    cells.upload(drawable.cells) + interior_edges.upload(drawable.interior_edges) +
                    model_edges.upload(drawable.model_edges) +
                    model_vertices.upload(drawable.model_vertices) +
                    highlight_lines.upload(drawable.highlight_lines) +
                    highlight_discs.upload(drawable.highlight_discs) +
                    before.upload(drawable.before) + selected.upload(drawable.selected) +
                    hovered.upload(drawable.hovered) + preview.upload(drawable.preview) +
                    rulers.upload(drawable.rulers) + ground.upload(drawable.ground);
}

}  // namespace aomd::render
