// The picture, without a window: every check runs on each headless context that works here.

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "core/measure/image_diff.h"
#include "viewer/app/window.h"
#include "viewer/ui/imgui_layer.h"
#include "viewer/ui/theme.h"

namespace aomd::render_test {
namespace {

constexpr glm::ivec2 picture_size{640, 480};
constexpr double aspect = 640.0 / 480.0;

/// A closed surface of revolution around z, `n` by `2n` quads: a sphere, or a torus whose tube has
/// radius 0.4.
scene::Drawable round_thing(int n, bool torus) {
  const auto point = [&](int i, int j, double offset) {
    const double a = std::numbers::pi * i / n;
    const double b = (torus ? 2 : 1) * std::numbers::pi * j / n;
    const double ring = torus ? 1 + (0.4 + offset) * std::sin(b) : (1 + offset) * std::sin(b);
    return glm::vec3(ring * std::cos(a), ring * std::sin(a),
                     ((torus ? 0.4 : 1.0) + offset) * std::cos(b));
  };
  const auto corner = [&](int i, int j, int tag) {
    const glm::vec3 p = point(i, j, 0);
    return scene::Corner{p, scene::pack_normal(glm::normalize(point(i, j, 0.1) - p)),
                         scene::color_of(ModelRef(2, tag)), 0};
  };
  std::vector<scene::Corner> corners;
  for (int i = 0; i < 2 * n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int tag = 1 + i * 4 / n;
      for (const auto& [u, v] : {std::pair{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
        corners.push_back(corner(i + u, j + v, tag));
    }
  }
  scene::Drawable drawable;
  for (const scene::Corner& c : corners) drawable.bounds.add(c.position);
  drawable.bounds.set_radius(torus ? 1.4 : 1.0);
  drawable.corners.assign(std::move(corners));
  return drawable;
}

double mean_luminance(const io::Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    sum += 0.2126 * image.rgba[i] + 0.7152 * image.rgba[i + 1] + 0.0722 * image.rgba[i + 2];
  return sum / static_cast<double>(image.pixel_count());
}

/// A context and what draws with it; ImGui's context lives as long.
struct Stage {
  explicit Stage(app::HeadlessKind kind)
      : window(app::make_headless_window(kind, picture_size)),
        gl(render::load_gl(window->get_proc_address())),
        sources(render::load_shader_sources()),
        renderer(gl, sources),
        buffers(gl) {}

  io::Image picture(scene::Drawable& drawable, const render::RenderSettings& settings = {}) {
    buffers.upload(drawable);
    renderer.render(buffers, camera_for(drawable), settings,
                    {0, 0, picture_size.x, picture_size.y});
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    return render::read_pixels(gl, picture_size);
  }
  static scene::Camera camera_for(const scene::Drawable& drawable) {
    return *scene::parse_camera("iso", scene::Camera(), drawable.bounds, aspect).camera;
  }

  std::unique_ptr<app::Window> window;
  render::Gl gl;
  render::ShaderSources sources;
  render::Renderer renderer;
  render::DrawableBuffers buffers;
};

class Render : public ::testing::TestWithParam<app::HeadlessKind> {
 protected:
  void SetUp() override {
    try {
      stage_.emplace(GetParam());
    } catch (const app::WindowError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  std::optional<Stage> stage_;
};

INSTANTIATE_TEST_SUITE_P(Headless, Render,
                         ::testing::Values(app::HeadlessKind::OsMesa, app::HeadlessKind::Egl),
                         [](const auto& test) {
                           return test.param == app::HeadlessKind::OsMesa ? "OSMesa" : "EGL";
                         });

io::Image four_colors() {
  io::Image four(2, 2);
  constexpr std::uint8_t colors[4][4] = {
      {250, 0, 0, 255}, {0, 250, 0, 255}, {0, 0, 250, 255}, {250, 250, 0, 255}};
  for (int i = 0; i < 4; ++i) std::copy_n(colors[i], 4, four.pixel(i % 2, i / 2));
  return four;
}

/// The colour in the middle of a white sphere whose faces all show one place of a picture.
glm::ivec3 shown_at(Stage& stage, glm::vec2 place, std::uint32_t picture,
                    const io::Image& image_on_it = four_colors()) {
  scene::Drawable sphere = round_thing(24, false);
  for (scene::Corner& corner : sphere.corners.edit(0, sphere.corners.size())) {
    corner.color = scene::rgb(0xffffff);
    corner.flags = picture << scene::picture_shift;
  }
  sphere.places.assign(std::vector<glm::vec2>(sphere.corners.size(), place));
  sphere.pictures = std::make_shared<const scene::Pictures>(scene::Pictures{{image_on_it}, {}});
  render::RenderSettings settings;
  settings.lit = settings.show_edges = false;
  const io::Image image = stage.picture(sphere, settings);
  const std::uint8_t* const pixel = image.pixel(picture_size.x / 2, picture_size.y / 2);
  return {pixel[0], pixel[1], pixel[2]};
}

TEST_P(Render, PicturesLieOnFacesAndAreCountedUpwards) {
  EXPECT_EQ(shown_at(*stage_, {0.25f, 0.75f}, 1), glm::ivec3(250, 0, 0));
  EXPECT_EQ(shown_at(*stage_, {0.75f, 0.75f}, 1), glm::ivec3(0, 250, 0));
  EXPECT_EQ(shown_at(*stage_, {0.25f, 0.25f}, 1), glm::ivec3(0, 0, 250));
  EXPECT_EQ(shown_at(*stage_, {-3.25f, 2.25f}, 1), glm::ivec3(250, 250, 0)) << "repeated";
  EXPECT_EQ(shown_at(*stage_, {0.25f, 0.25f}, 0), glm::ivec3(255, 255, 255)) << "without one";
}

TEST_P(Render, PicturesLargerThanAnyCardTakesAreMadeSmaller) {
  io::Image wide(1 << 17, 3);
  for (std::size_t i = 0; i < wide.rgba.size(); ++i)
    wide.rgba[i] = std::array<std::uint8_t, 4>{40, 80, 120, 255}[i % 4];
  EXPECT_EQ(shown_at(*stage_, {0.25f, 0.25f}, 1, wide), glm::ivec3(40, 80, 120));
}

TEST_P(Render, ShowsSomethingInTheMiddleAndBackgroundAround) {
  scene::Drawable nothing;
  const io::Image empty = stage_->picture(nothing);
  scene::Drawable torus = round_thing(48, true);
  const io::Image image = stage_->picture(torus);
  const measure::ImageDifference difference = measure::compare_images(empty, image);
  EXPECT_GT(difference.differing_pixels, image.pixel_count() / 5);
  EXPECT_LT(difference.differing_pixels, image.pixel_count() * 4 / 5);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(image.pixel(2, 2)[c], empty.pixel(2, 2)[c]);
}

TEST_P(Render, FacesBehindVeryManyOthersShowToo) {
  scene::Drawable torus = round_thing(48, true), same = round_thing(48, true);
  const io::Image alone = stage_->picture(torus);
  std::vector<scene::Corner> corners(3 * 150'001);
  const auto values = same.corners.values();
  corners.insert(corners.end(), values.begin(), values.end());
  same.corners.assign(std::move(corners));
  stage_.reset();
  stage_.emplace(GetParam());
  EXPECT_EQ(stage_->picture(same), alone);
}

TEST_P(Render, TwoRunsAreEqualByteForByte) {
  scene::Drawable torus = round_thing(48, true);
  const io::Image first = stage_->picture(torus);
  EXPECT_EQ(first, stage_->picture(torus));
  stage_.reset();
  stage_.emplace(GetParam());
  scene::Drawable again = round_thing(48, true);
  EXPECT_EQ(first, stage_->picture(again));
}

TEST_P(Render, UploadsOnlyWhatChanged) {
  scene::Drawable sphere = round_thing(64, false);
  const io::Image before = stage_->picture(sphere);
  EXPECT_EQ(stage_->buffers.uploaded_bytes(), sphere.corners.size() * sizeof(scene::Corner));
  (void)stage_->picture(sphere);
  EXPECT_EQ(stage_->buffers.uploaded_bytes(), 0u);
  scene::Corner corner = sphere.corners[6000];
  corner.position *= 1.2f;
  sphere.corners.set(6000, corner);
  const io::Image patched = stage_->picture(sphere);
  EXPECT_EQ(stage_->buffers.uploaded_bytes(), sizeof(scene::Corner));
  // The patched buffer shows what a fresh one shows.
  sphere.corners.assign({sphere.corners.values().begin(), sphere.corners.values().end()});
  EXPECT_EQ(patched, stage_->picture(sphere));
  EXPECT_NE(patched, before);
}

TEST_P(Render, GrowsBuffersAndForgetsCutElements) {
  scene::Drawable sphere = round_thing(16, false);
  const io::Image whole = stage_->picture(sphere);
  const std::vector<scene::Corner> kept(sphere.corners.values().begin(),
                                        sphere.corners.values().end());
  sphere.corners.resize(kept.size() / 2);
  EXPECT_NE(stage_->picture(sphere), whole);
  EXPECT_EQ(stage_->buffers.uploaded_bytes(), 0u);
  for (std::size_t i = kept.size() / 2; i < kept.size(); ++i) sphere.corners.push_back(kept[i]);
  EXPECT_EQ(stage_->picture(sphere), whole);
  sphere.corners.resize(3 * kept.size());
  EXPECT_EQ(stage_->picture(sphere), whole) << "dead slots are invisible";
}

TEST_P(Render, EdgesShowOnCoarseMeshesAndFadeOnDenseOnes) {
  render::RenderSettings off;
  off.show_edges = false;
  scene::Drawable coarse = round_thing(12, false);
  EXPECT_LT(mean_luminance(stage_->picture(coarse)),
            0.99 * mean_luminance(stage_->picture(coarse, off)));
  scene::Drawable dense = round_thing(220, false);
  EXPECT_NEAR(mean_luminance(stage_->picture(dense)) / mean_luminance(stage_->picture(dense, off)),
              1.0, 0.02);
}

/// How many pixels are not those of another picture.
std::size_t differing(const io::Image& a, const io::Image& b) {
  return measure::compare_images(a, b).differing_pixels;
}

TEST_P(Render, WithoutTheSurfaceEdgesShowAlone) {
  scene::Drawable nothing, sphere = round_thing(12, false);
  const io::Image empty = stage_->picture(nothing);
  render::RenderSettings settings;
  settings.show_surface = false;
  const io::Image all = stage_->picture(sphere, settings);
  settings.hidden_lines = false;
  const io::Image front = stage_->picture(sphere, settings);
  EXPECT_GT(differing(front, empty), 2000u);
  EXPECT_LT(differing(front, empty), front.pixel_count() / 4) << "no faces";
  EXPECT_GT(differing(all, empty), differing(front, empty) * 3 / 2) << "and those of the back";
  settings.show_edges = false;
  EXPECT_TRUE(stage_->picture(sphere, settings) == empty);
}

TEST_P(Render, BackFacesAreTinted) {
  scene::Drawable outside = round_thing(32, false);
  std::vector<scene::Corner> turned(outside.corners.values().begin(),
                                    outside.corners.values().end());
  for (std::size_t i = 0; i < turned.size(); i += 3) std::swap(turned[i], turned[i + 1]);
  scene::Drawable inside;
  inside.bounds = outside.bounds;
  inside.corners.assign(std::move(turned));
  const io::Image front = stage_->picture(outside);
  const io::Image back = stage_->picture(inside);
  EXPECT_GT(measure::compare_images(front, back).differing_pixels, front.pixel_count() / 5);
}

TEST_P(Render, ClipPlaneOpensTheSphere) {
  scene::Drawable sphere = round_thing(32, false);
  const io::Image whole = stage_->picture(sphere);
  render::RenderSettings settings;
  settings.clip_plane = glm::dvec4(0, 0, 0, 1);
  EXPECT_EQ(stage_->picture(sphere, settings), whole) << "a plane that cuts nothing";
  settings.clip_plane = glm::dvec4(0, 0, 0, -1);
  scene::Drawable nothing;
  nothing.bounds = sphere.bounds;
  const io::Image all_cut = stage_->picture(sphere, settings);
  EXPECT_EQ(all_cut, stage_->picture(nothing));
}

TEST_P(Render, LinesDiscsAndHighlightsAreDrawn) {
  scene::Drawable sphere = round_thing(24, false);
  const io::Image plain = stage_->picture(sphere);
  sphere.model_edges.push_back(
      {{1.0f, -1.0f, 1.0f}, {1.0f, -1.0f, -1.0f}, scene::rgb(0xff0000), 4.0f});
  const io::Image line = stage_->picture(sphere);
  EXPECT_EQ(stage_->buffers.uploaded_bytes(), sizeof(scene::Segment));
  EXPECT_NE(line, plain);
  sphere.model_vertices.push_back({{1.0f, -1.0f, 0.2f}, scene::rgb(0x0000ff), 6.0f});
  const io::Image disc = stage_->picture(sphere);
  EXPECT_NE(disc, line);
  for (scene::Corner& corner : sphere.corners.edit(0, 3)) corner.flags |= scene::highlighted;
  EXPECT_NE(stage_->picture(sphere), disc);
  render::RenderSettings hidden;
  hidden.show_model_edges = false;
  hidden.show_model_vertices = false;
  for (scene::Corner& corner : sphere.corners.edit(0, 3)) corner.flags = 0;
  EXPECT_EQ(stage_->picture(sphere, hidden), plain);
}

TEST_P(Render, LinesThatPassBehindTheEyeAreCut) {
  scene::Drawable drawable;
  drawable.bounds.add({-1, -1, -1});
  drawable.bounds.add({1, 1, 1});
  const scene::Camera camera = Stage::camera_for(drawable);
  const io::Image plain = stage_->picture(drawable);
  const glm::vec3 behind(camera.eye() - 5.0 * camera.forward() + 0.5 * camera.right());
  drawable.bounds.add(behind);
  drawable.model_edges.push_back({glm::vec3(0), behind, scene::rgb(0x000000), 3.0f});
  stage_->buffers.upload(drawable);
  stage_->renderer.render(stage_->buffers, camera, {}, {0, 0, picture_size.x, picture_size.y});
  const io::Image image = render::read_pixels(stage_->gl, picture_size);
  // From the middle to the right border, about 4 pixels wide.
  const std::size_t changed = measure::compare_images(plain, image).differing_pixels;
  EXPECT_GT(changed, 320u * 3);
  EXPECT_LT(changed, 320u * 6);
}

TEST_P(Render, OnlyTheRectangleChanges) {
  scene::Drawable sphere = round_thing(24, false);
  const io::Image whole = stage_->picture(sphere);
  stage_->renderer.render(stage_->buffers, Stage::camera_for(sphere),
                          {.theme = render::dark_scene_theme()}, {100, 50, 200, 120});
  const io::Image patched = render::read_pixels(stage_->gl, picture_size);
  for (int y = 0; y < picture_size.y; ++y) {
    for (int x = 0; x < picture_size.x; ++x) {
      const int from_below = picture_size.y - 1 - y;
      if (x >= 100 && x < 300 && from_below >= 50 && from_below < 170) continue;
      ASSERT_EQ(whole.pixel(x, y)[0], patched.pixel(x, y)[0]) << x << " " << y;
    }
  }
  EXPECT_NE(whole, patched);
}

TEST_P(Render, ImGuiTextIsDrawn) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  const ui::Fonts fonts = ui::load_fonts(1);
  for (const ui::ThemeKind kind : {ui::ThemeKind::Light, ui::ThemeKind::Dark}) {
    ui::apply_theme(kind, 1);
    render::ShaderProgram program(stage_->gl, stage_->sources, "ui");
    ui::ImGuiLayer layer(stage_->gl, program);
    scene::Drawable nothing;
    const io::Image before = stage_->picture(nothing);
    (void)stage_->window->poll(ImGui::GetIO());
    ImGui::NewFrame();
    ImGui::GetForegroundDrawList()->AddText(fonts.heading, 40, {100, 200}, 0xff0000ff, "AOMD");
    ImGui::Render();
    layer.draw(*ImGui::GetDrawData());
    EXPECT_EQ(stage_->gl.GetError(), GLenum{GL_NO_ERROR});
    const io::Image after = render::read_pixels(stage_->gl, picture_size);
    std::size_t red = 0;
    for (int y = 195; y < 250; ++y)
      for (int x = 95; x < 260; ++x)
        red += after.pixel(x, y)[0] > 240 && after.pixel(x, y)[1] < 15 ? 1u : 0u;
    EXPECT_GT(red, 300u);
    EXPECT_LT(red, 5000u);
    EXPECT_LT(measure::compare_images(before, after).differing_pixels, 9000u);
  }
  ImGui::DestroyContext();
}

TEST_P(Render, BrokenShaderIsAnErrorWithItsName) {
  render::ShaderSources sources = stage_->sources;
  sources["surface.frag"] = "#version 330 core\nnonsense\n";
  try {
    const render::Renderer renderer(stage_->gl, sources);
    FAIL() << "no error";
  } catch (const render::GlError& error) {
    EXPECT_NE(std::string(error.what()).find("surface.frag"), std::string::npos);
  }
}

TEST(Gl, MissingFunctionIsNamed) {
  try {
    (void)render::load_gl([](const char*) -> render::GlFunction { return nullptr; });
    FAIL() << "no error";
  } catch (const render::GlError& error) {
    EXPECT_NE(std::string(error.what()).find("glActiveTexture"), std::string::npos);
  }
}

TEST(ShaderSources, FolderGivesTheSameTextsAsTheProgram) {
  EXPECT_EQ(render::load_shader_sources(AOMD_SHADERS), render::load_shader_sources());
  EXPECT_THROW((void)render::load_shader_sources("/no/such/folder"), render::GlError);
}

TEST(Headless, AutoSaysWhichOneWorkedAndSizesAreChecked) {
  const auto window = app::make_headless_window(app::HeadlessKind::Auto, {64, 48});
  EXPECT_TRUE(window->kind() == "OSMesa" || window->kind() == "EGL");
  EXPECT_EQ(window->framebuffer_size(), glm::ivec2(64, 48));
  EXPECT_THROW((void)app::make_headless_window(app::HeadlessKind::Auto, {0, 48}), app::WindowError);
}

}  // namespace
}  // namespace aomd::render_test
