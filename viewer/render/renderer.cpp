#include "viewer/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "viewer/drawing/edge_codes.h"

namespace aomd::render {

using scene::rgb;
using scene::unpack_color;

namespace {

constexpr scene::Color with_alpha(scene::Color color, std::uint32_t alpha) {
  return (color & 0x00ffffffu) | alpha << 24;
}

constexpr float disc_outline_px = 1.25f;
// 128 MB with four samples; a multiple of the stripes' period on backs.
constexpr int largest_piece = 2000;

void draw_instances(const Gl& gl, const VertexBuffer& buffer) {
  if (buffer.count() == 0) return;
  buffer.bind();
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, buffer.count());
}

glm::vec3 opaque(scene::Color color) { return glm::vec3(unpack_color(color)); }

}  // namespace

SceneTheme light_scene_theme() {
  return {.background_top = rgb(0xf7f9fb),
          .background_bottom = rgb(0xd3dae3),
          .edge = with_alpha(rgb(0x1b2430), 150),
          .wire = with_alpha(rgb(0x1b2430), 190),
          .back_face = with_alpha(rgb(0xb4533c), 165),
          .highlight = with_alpha(rgb(0xff2f92), 205),
          .outline = rgb(0xffffff),
          .glass = with_alpha(rgb(0x2f6fd0), 56)};
}

SceneTheme dark_scene_theme() {
  return {.background_top = rgb(0x2b313b),
          .background_bottom = rgb(0x14171c),
          .edge = with_alpha(rgb(0x0b0e13), 165),
          .wire = with_alpha(rgb(0xb9c6d8), 190),
          .back_face = with_alpha(rgb(0x9c4632), 165),
          .highlight = with_alpha(rgb(0xff4da3), 205),
          .outline = rgb(0x0e1116),
          .surface = 0.86f,
          .glass = with_alpha(rgb(0x7fb2ff), 48)};
}

/// What all programs need to know about one picture.
struct Renderer::Frame {
  glm::mat4 view;
  glm::mat4 projection;
  glm::dvec3 origin;
  glm::vec4 clip_plane;
  glm::vec2 size_px;
  float pixel_size;  ///< world units a pixel, at depth 1 in perspective
  float near_depth;  ///< perspective only: lines are cut there
  bool orthographic;
  const RenderSettings& settings;

  Frame(const DrawableBuffers& buffers, const scene::Camera& camera, const RenderSettings& s,
        const Piece& piece)
      : size_px(piece.size), orthographic(camera.orthographic), settings(s) {
    const double aspect = static_cast<double>(piece.whole.x) / piece.whole.y;
    const glm::dmat4 p = camera.projection(aspect, buffers.bounds);
    view = glm::mat4(camera.view() * glm::translate(glm::dmat4(1), buffers.origin));
    projection = glm::mat4(piece_of(piece) * p);
    pixel_size = static_cast<float>(2.0 / (p[1][1] * piece.whole.y));
    near_depth = orthographic ? -std::numeric_limits<float>::max()
                              : static_cast<float>(p[3][2] / (p[2][2] - 1.0));
    origin = buffers.origin;
    set_clip_plane(s.clip_plane.value_or(glm::dvec4(0, 0, 0, 1)));
  }
  void set_clip_plane(const glm::dvec4& plane) {
    clip_plane = glm::vec4(glm::dvec3(plane), plane.w + glm::dot(glm::dvec3(plane), origin));
  }

  /// From the whole's clip space to the piece's.
  static glm::dmat4 piece_of(const Piece& piece) {
    if (piece.whole == piece.size) return glm::dmat4(1);
    const glm::dvec2 scale = glm::dvec2(piece.whole) / glm::dvec2(piece.size);
    const glm::dvec2 middle =
        (2.0 * glm::dvec2(piece.from) + glm::dvec2(piece.size)) / glm::dvec2(piece.whole) - 1.0;
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), {-middle * scale, 0.0});
    return glm::scale(moved, {scale, 1.0});
  }

  void apply(ShaderProgram& program) const {
    program.use();
    program.set("view", view);
    program.set("projection", projection);
    program.set("clip_plane", clip_plane);
    program.set("pixel_scale", settings.pixel_scale);
  }
  void apply_pulled(ShaderProgram& program) const {
    apply(program);
    program.set("pixel_size", pixel_size);
    program.set("orthographic", orthographic ? 1 : 0);
  }
  void apply_strokes(ShaderProgram& program) const {
    apply_pulled(program);
    program.set("size_px", size_px);
    program.set("near_depth", near_depth);
    program.set("outline_color", opaque(settings.theme.outline));
  }
};

Renderer::Renderer(const Gl& gl, const ShaderSources& sources)
    : gl_(gl),
      background_(gl, sources, "background"),
      surface_(gl, sources, "surface"),
      overlay_(gl, sources, "overlay"),
      glass_(gl, sources, "glass"),
      stroke_(gl, sources, "stroke"),
      nothing_(gl),
      target_(gl, wanted_samples),
      draft_target_(gl, 1) {
  static_cast<void>(surface_.get({}));  // nearly every picture needs it
}

void Renderer::render(const DrawableBuffers& buffers, const scene::Camera& camera,
                      const RenderSettings& settings, const PixelRect& rect, GLuint destination) {
  if (rect.empty()) return;
  gl_.Disable(GL_SCISSOR_TEST);
  const glm::ivec2 whole{rect.width, rect.height};
  MultisampleTarget& target = settings.draft ? draft_target_ : target_;
  for (int y = 0; y < whole.y; y += largest_piece)
    for (int x = 0; x < whole.x; x += largest_piece) {
      const glm::ivec2 size = glm::min(whole - glm::ivec2(x, y), glm::ivec2(largest_piece));
      target.begin(size);
      draw_piece(buffers, camera, settings, {whole, {x, y}, size});
      target.resolve(destination, {rect.x + x, rect.y + y, size.x, size.y});
    }
}

void Renderer::draw(const DrawableBuffers& buffers, const scene::Camera& camera,
                    const RenderSettings& settings, glm::ivec2 size) {
  draw_piece(buffers, camera, settings, {size, {0, 0}, size});
}

void Renderer::draw_piece(const DrawableBuffers& buffers, const scene::Camera& camera,
                          const RenderSettings& settings, const Piece& piece) {
  const Frame frame(buffers, camera, settings, piece);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
  if (settings.transparent) {
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
  } else {
    draw_background(settings.theme, piece);
  }
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  if (settings.clip_plane) gl_.Enable(GL_CLIP_DISTANCE0);
  if (settings.show_surface && !settings.glass) {
    draw_pictures(buffers, frame);
    draw_surface(buffers.cells, frame);
  }
  // The soft rims of lines must not keep out the lines that go on behind them.
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (settings.show_ground) draw_overlay(buffers.ground, frame);
  if (!settings.show_surface && settings.show_edges) draw_wires(buffers, frame);
  if (settings.glass) {
    frame.apply_strokes(stroke_);
    draw_strokes(buffers.interior_edges);
    if (settings.show_surface) draw_inside_glass(buffers.surface(), frame);
  }
  if (settings.ghost != nullptr) draw_glass(settings.ghost->surface(), frame);
  frame.apply_strokes(stroke_);
  if (settings.show_model_edges) draw_strokes(buffers.model_edges);
  draw_strokes(buffers.highlight_lines);
  if (settings.show_model_vertices) draw_strokes(buffers.model_vertices);
  draw_strokes(buffers.highlight_discs);
  gl_.Disable(GL_DEPTH_TEST);
  draw_overlay(buffers.before, frame);
  draw_overlay(buffers.preview, frame);
  draw_overlay(buffers.rulers, frame);
  gl_.Enable(GL_DEPTH_TEST);
  draw_overlay(buffers.selected, frame);
  draw_overlay(buffers.hovered, frame);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_CLIP_DISTANCE0);
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
}

void Renderer::draw_background(const SceneTheme& theme, const Piece& piece) {
  const float whole = static_cast<float>(piece.whole.y);
  background_.use();
  background_.set("from", static_cast<float>(piece.from.y) / whole);
  background_.set("part", static_cast<float>(piece.size.y) / whole);
  background_.set("top", opaque(theme.background_top));
  background_.set("bottom", opaque(theme.background_bottom));
  nothing_.bind();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

/// The faces of each picture for themselves, and those without one.
void Renderer::draw_pictures(const DrawableBuffers& buffers, const Frame& frame) {
  if (!buffers.corners.has_places()) return draw_surface(buffers.surface(), frame);
  ShaderProgram& program = prepare_surface(frame, Faces::Pictures);
  buffers.corners.bind();
  const auto count = static_cast<int>(buffers.pictures.size());
  for (int picture = 0; picture <= count; ++picture) {
    if (picture > 0) buffers.pictures.bind(static_cast<std::size_t>(picture - 1));
    program.set("picture", picture);
    draw_corners(buffers.corners);
  }
  gl_.BindTexture(GL_TEXTURE_2D, 0);
}

/// In eye space. The light that follows the camera comes over its left shoulder.
void Renderer::set_light(ShaderProgram& program, const RenderSettings& settings) {
  constexpr glm::vec3 key(-0.369f, 0.527f, 0.766f), fill(0.873f, -0.218f, 0.436f), up(0, 1, 0);
  constexpr glm::vec3 half(-0.196f, 0.280f, 0.940f);  // between the key light and the eye
  const bool follows = settings.light == glm::mat3(1);
  const glm::vec3 turned = settings.light * key;
  const glm::vec3 between = turned + glm::vec3(0, 0, 1);
  const float length = glm::length(between);
  program.set("key_direction", turned);
  program.set("fill_direction", settings.light * fill);
  program.set("sky_direction", settings.light * up);
  program.set("half_direction", follows ? half : length > 0 ? between / length : turned);
}

void Renderer::draw_surface(const CornerBuffer& corners, const Frame& frame, Faces faces) {
  if (corners.count() == 0) return;
  static_cast<void>(prepare_surface(frame, faces));
  corners.bind();
  draw_corners(corners);
}

/// Mesa on the processor keeps 300 bytes of each face that is to be drawn until it is told to draw.
void Renderer::draw_corners(const CornerBuffer& corners) {
  constexpr GLsizei most = 3 * 50'000;
  for (GLsizei from = 0; from < corners.count(); from += most) {
    if (from > 0) gl_.Finish();
    gl_.DrawArrays(GL_TRIANGLES, from, std::min(most, corners.count() - from));
  }
}

ShaderProgram& Renderer::prepare_surface(const Frame& frame, Faces faces) {
  const RenderSettings& settings = frame.settings;
  const bool wires = faces == Faces::Wires, codes = settings.show_edge_codes && !wires;
  const scene::Color edge = wires ? settings.theme.wire : settings.theme.edge;
  ShaderProgram& program =
      surface_.get(std::string(wires ? "#define WIRES\n" : "") + (codes ? "#define CODES\n" : "") +
                   (faces == Faces::Pictures ? "#define PICTURES\n" : ""));
  frame.apply(program);
  set_light(program, settings);
  program.set("strength", settings.quiet ? settings.theme.surface : 1.0f);
  program.set("light", settings.lit ? 1 : 0);
  program.set("edge_color", settings.show_edges ? unpack_color(edge) : glm::vec4(0));
  program.set("edge_width", settings.edge_width_px);
  program.set("back_color", unpack_color(settings.theme.back_face));
  program.set("highlight_color", unpack_color(settings.theme.highlight));
  for (std::uint8_t code = 0; codes && code <= scene::unjudged; ++code)
    program.set(("code_colors[" + std::to_string(code) + "]").c_str(),
                opaque(scene::verdict_color(code)));
  return program;
}

/// Edges without faces. Where hidden ones are not wanted, the faces come first, a little farther
/// away and in depth alone.
void Renderer::draw_wires(const DrawableBuffers& buffers, const Frame& frame) {
  const auto draw = [&](Faces faces) {
    draw_surface(buffers.surface(), frame, faces);
    draw_surface(buffers.cells, frame, faces);
  };
  if (!frame.settings.hidden_lines) {
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.DepthMask(GL_TRUE);
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(1, 4);
    draw(Faces::Plain);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    gl_.DepthMask(GL_FALSE);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  draw(Faces::Wires);
}

void Renderer::draw_overlay(const OverlayBuffers& overlay, const Frame& frame) {
  if (overlay.faces.count() > 0) {
    frame.apply_pulled(overlay_);
    overlay.faces.bind();
    gl_.DrawArrays(GL_TRIANGLES, 0, overlay.faces.count());
  }
  if (overlay.lines.count() + overlay.discs.count() == 0) return;
  frame.apply_strokes(stroke_);
  draw_strokes(overlay.lines);
  draw_strokes(overlay.discs);
}

/// As far as the plane leaves it.
void Renderer::draw_inside_glass(const CornerBuffer& corners, const Frame& frame) {
  if (!frame.settings.glass_plane) return draw_glass(corners, frame);
  Frame cut = frame;
  cut.set_clip_plane(*frame.settings.glass_plane);
  gl_.Enable(GL_CLIP_DISTANCE0);
  draw_glass(corners, cut);
  if (!frame.settings.clip_plane) gl_.Disable(GL_CLIP_DISTANCE0);
}

/// Its faces in front only. Behind faces in the same place, so that nothing flickers where both
/// agree.
void Renderer::draw_glass(const CornerBuffer& corners, const Frame& frame) {
  if (corners.count() == 0) return;
  frame.apply(glass_);
  glass_.set("glass_color", unpack_color(frame.settings.theme.glass));
  glass_.set("orthographic", frame.orthographic ? 1 : 0);
  gl_.Enable(GL_CULL_FACE);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1, 4);
  corners.bind();
  draw_corners(corners);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_CULL_FACE);
}

void Renderer::draw_strokes(const SegmentBuffer& segments) {
  stroke_.set("half_width_per_thickness", 0.5f);
  stroke_.set("outline_px", 0.0f);
  stroke_.set("pull_px", 0.0f);
  draw_instances(gl_, segments);
}

void Renderer::draw_strokes(const DiscBuffer& discs) {
  stroke_.set("half_width_per_thickness", 1.0f);
  stroke_.set("outline_px", disc_outline_px);
  // A little more than the lines that meet here.
  stroke_.set("pull_px", 2.0f);
  draw_instances(gl_, discs);
}

}  // namespace aomd::render
