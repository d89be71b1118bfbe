#pragma once
// Draws a Drawable as a Camera sees it.

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include "viewer/drawing/camera.h"
#include "viewer/drawing/drawable.h"
#include "viewer/render/buffers.h"
#include "viewer/render/framebuffer.h"
#include "viewer/render/gl.h"
#include "viewer/render/shader_program.h"
#include "viewer/render/shader_sources.h"

namespace aomd::render {

/// The scene's colours that do not come from the Drawable.
struct SceneTheme {
  scene::Color background_top = 0;
  scene::Color background_bottom = 0;
  scene::Color edge = 0;       ///< of mesh edges; its alpha is their strength
  scene::Color wire = 0;       ///< likewise, without the surface
  scene::Color back_face = 0;  ///< what faces seen from behind tend to; its alpha is how far
  scene::Color highlight = 0;  ///< of highlighted faces; its alpha is how far
  scene::Color outline = 0;    ///< around discs
  float surface = 1;  ///< how much of their colour faces have where it stands for no number
  scene::Color glass =
      0;  ///< of surfaces that others are seen through; its alpha is how dense it is
};

[[nodiscard]] SceneTheme light_scene_theme();
[[nodiscard]] SceneTheme dark_scene_theme();

struct RenderSettings {
  bool lit = true;           ///< shades the surface; else its colours are as they are
  bool show_surface = true;  ///< without it the mesh edges alone, where these show
  bool hidden_lines = true;  ///< then also those that the surface would hide
  bool glass = false;        ///< the surface as glass, with the edges inside of it
  bool show_edges = true;    ///< mesh edges; they fade where triangles shrink to a few pixels
  bool show_model_edges = true;
  bool show_model_vertices = true;
  bool show_ground = false;
  bool draft = false;  ///< one sample a pixel: for pictures that the next one follows at once
  bool quiet = false;  ///< colours stand for no numbers: SceneTheme::surface
  glm::mat3 light{1};  ///< turns the light that comes over the shoulder of the camera
  bool show_edge_codes = false;  ///< faces in the colours of their edges' codes, a third for each
  float edge_width_px = 1.1f;    ///< of mesh edges, at pixel scale 1
  float pixel_scale = 1.0f;  ///< framebuffer pixels a logical pixel: scales all widths and radii
  SceneTheme theme = light_scene_theme();
  bool transparent =
      false;  ///< nothing behind the mesh: colours are then multiplied by their alpha
  /// Keeps points p with dot(xyz, p) + w >= 0, in world coordinates.
  std::optional<glm::dvec4> clip_plane = {};
  /// Where the surface of glass ends, likewise: what lies inside of it is seen on both sides.
  std::optional<glm::dvec4> glass_plane = {};
  /// A surface that is drawn as glass over everything; what lies on the one below does not show.
  const DrawableBuffers* ghost = nullptr;
};

/// Programs and targets of one context, which must be current whenever a member runs.
class Renderer {
 public:
  static constexpr int wanted_samples = 4;

  /// Compiles the shaders, but for variants that few pictures need. Throws GlError.
  Renderer(const Gl& gl, const ShaderSources& sources);

  /// Draws into `rect` of framebuffer `destination` (0 is the window's) through an own target with
  /// several samples; piece by piece where `rect` is larger than that may become. Nothing outside
  /// `rect` changes. An empty rect is left alone.
  void render(const DrawableBuffers& buffers, const scene::Camera& camera,
              const RenderSettings& settings, const PixelRect& rect, GLuint destination = 0);
  /// Draws into the framebuffer that is bound, which needs depth; the viewport must be `size`
  /// large.
  void draw(const DrawableBuffers& buffers, const scene::Camera& camera,
            const RenderSettings& settings, glm::ivec2 size);
  [[nodiscard]] int samples() const { return target_.samples(); }

 private:
  /// A piece of a picture of `whole` pixels, from its lower left corner.
  struct Piece {
    glm::ivec2 whole{0}, from{0}, size{0};
  };
  struct Frame;
  void draw_piece(const DrawableBuffers& buffers, const scene::Camera& camera,
                  const RenderSettings& settings, const Piece& piece);
  void draw_background(const SceneTheme& theme, const Piece& piece);
  static void set_light(ShaderProgram& program, const RenderSettings& settings);
  enum class Faces { Plain, Pictures, Wires };
  void draw_surface(const CornerBuffer& corners, const Frame& frame, Faces faces = Faces::Plain);
  void draw_pictures(const DrawableBuffers& buffers, const Frame& frame);
  void draw_corners(const CornerBuffer& corners);
  [[nodiscard]] ShaderProgram& prepare_surface(const Frame& frame, Faces faces);
  void draw_wires(const DrawableBuffers& buffers, const Frame& frame);
  void draw_overlay(const OverlayBuffers& overlay, const Frame& frame);
  void draw_inside_glass(const CornerBuffer& corners, const Frame& frame);
  void draw_glass(const CornerBuffer& corners, const Frame& frame);
  void draw_strokes(const SegmentBuffer& segments);
  void draw_strokes(const DiscBuffer& discs);

  const Gl& gl_;
  ShaderProgram background_;
  ShaderVariants surface_;
  ShaderProgram overlay_;
  ShaderProgram glass_;
  ShaderProgram stroke_;  ///< lines and discs
  VertexBuffer nothing_;  ///< the background's triangle comes from gl_VertexID
  MultisampleTarget target_;
  MultisampleTarget draft_target_;
};

}  // namespace aomd::render
