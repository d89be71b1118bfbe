#include "viewer/app/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <utility>

#include "core/model/gmsh_model.h"
#include "core/samples/samples.h"
#include "viewer/commands/arguments.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/lesson_commands.h"
#include "viewer/commands/look_lines.h"
#include "viewer/drawing/ground.h"
#include "viewer/ui/widgets.h"

namespace aomd::app {
namespace {

using Clock = std::chrono::steady_clock;

// A run gets as long as drawing takes, within these bounds: slow drawing must not starve it, nor it
// the window.
constexpr std::chrono::microseconds least_budget{8000};
constexpr std::chrono::microseconds most_budget{60000};
constexpr double idle_wait_s = 0.5;
// Drawing that takes longer is too slow to turn the mesh by, and a hand that rests so long has
// turned it to where it wants it.
constexpr std::chrono::milliseconds slow_drawing{50}, rest_of_camera{250};
constexpr int frames_after_event = 3;  // ImGui needs a few to settle

/// Each press and release takes a frame of its own, so that slow drawing would make two clicks of
/// one double click.
float double_click_time(std::chrono::microseconds drawing_time) {
  constexpr float usual_s = 0.3f, frames = 4;
  return usual_s + frames * std::chrono::duration<float>(drawing_time).count();
}

}  // namespace

Viewer::ImGuiScope::ImGuiScope() : context(ImGui::CreateContext()) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
}

Viewer::ImGuiScope::~ImGuiScope() { ImGui::DestroyContext(context); }

std::string first_command(const Options& options) {
  if (!options.file.empty()) return "open " + scene::in_quotes(options.file.string());
  return options.script.empty() && options.commands.empty()
             ? "sample " + std::string(samples().front().name)
             : "";
}

Viewer::Viewer(Window& window, scene::Session& session, const Options& options, bool headless,
               std::shared_ptr<Graphics> graphics)
    : window_(window),
      session_(session),
      options_(options),
      headless_(headless),
      graphics_(graphics ? std::move(graphics)
                         : std::make_shared<Graphics>(window, options.shaders)),
      gl_(graphics_->gl),
      fonts_(ui::load_fonts(1)),
      layer_(gl_, graphics_->panels),
      buffers_(gl_),
      original_buffers_(gl_) {
  session_.keep_shape = [this] { update_aspect(); };
  session_.view.theme = options.theme.value_or(scene::Theme::Light);
  interface_.bars = options.interface;
  interface_.interactive = !headless;
  if (!headless) interface_.recent = ui::RecentFiles(ui::recent_files_path());
  if (!headless) connect_clipboard();
  if (remembers()) restore_settings();
  if (!headless && !session_.found_work.works.empty())
    session_.view.dialog = scene::Dialog::Recovery;
  if (!interface_.recent.paths().empty())
    interface_.remember_folder(interface_.recent.paths().front().parent_path());
  if (!options.script.empty()) script_ = scene::Script(options.script);
  script_.add(options.commands_place, options.commands);
  if (!options.record.empty()) begin_record();
  window_.poll(ImGui::GetIO());
  lay_out_frame();  // the layout, and so the picture's shape, is known from here on
}

/// A script begins with the usual look and without a mesh, a window perhaps not.
void Viewer::begin_record() {
  record_.open(options_.record);
  if (!record_) throw io::WriteError(options_.record.string(), {}, "cannot be written");
  for (const std::string& line : scene::look_lines(session_.view)) record_ << line << std::endl;
  if (const std::string first = first_command(options_); !first.empty())
    record_ << first << std::endl;
}

Viewer::~Viewer() { session_.keep_shape = {}; }

/// Pictures and scripts begin with the same look on every machine.
bool Viewer::remembers() const { return !headless_ && options_.script.empty(); }

void Viewer::restore_settings() {
  const ui::Settings settings = ui::read_settings(ui::settings_path());
  session_.view.theme = options_.theme.value_or(settings.theme);
  session_.view.panels = settings.panels;
  session_.view.text_scale = settings.text_scale;
  session_.view.occlusion = settings.occlusion;
  session_.view.ground = settings.ground;
  session_.view.play_speed = settings.play_speed;
  interface_.recent_commands() = settings.recent_commands;
  session_.lesson.completed = {settings.lessons_done.begin(), settings.lessons_done.end()};
  const bool some_left = session_.lesson.completed.size() < scene::lessons().size();
  if (options_.file.empty() && some_left)
    session_.lesson.suggested = std::filesystem::exists(ui::settings_path())
                                    ? scene::LessonPlayer::Hint::Again
                                    : scene::LessonPlayer::Hint::First;
  if (settings.window && !options_.size_given) window_.move_to(*settings.window);
}

void Viewer::save_settings() {
  ui::write_settings(ui::settings_path(),
                     {session_.view.theme,
                      session_.view.presenting.value_or(session_.view.panels),
                      session_.view.text_scale,
                      session_.view.occlusion,
                      session_.view.ground,
                      window_.place(),
                      interface_.recent_commands(),
                      session_.view.play_speed,
                      {session_.lesson.completed.begin(), session_.lesson.completed.end()}});
}

void Viewer::connect_clipboard() {
  session_.clipboard.write_system = [](const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
  };
  session_.clipboard.read_system = [] {
    const char* text = ImGui::GetClipboardText();
    return std::string(text != nullptr ? text : "");
  };
}

/// Of lines and dots, and where nobody changes that of text.
float Viewer::drawing_scale() const {
  const double own = options_.scale ? *options_.scale : window_.content_scale();
  const double presented = session_.view.presenting ? scene::presentation_scale : 1;
  return static_cast<float>(own * presented * picture_scale_);
}

void Viewer::update_look() {
  const float scale = drawing_scale() * static_cast<float>(session_.view.text_scale);
  if (scale == scale_ && theme_ == session_.view.theme) return;
  if (scale != scale_) {
    fonts_ = ui::load_fonts(scale);
    layer_.update_fonts();
  }
  scale_ = scale;
  theme_ = session_.view.theme;
  ui::apply_theme(ui::theme_kind(theme_), scale);
}

void Viewer::update_aspect() {
  const ui::Layout layout =
      ui::make_layout(ImGui::GetIO().DisplaySize, session_.view.panels, interface_.bars, em_);
  const double before = session_.view.aspect;
  const ui::Area picture = ui::picture_area(layout.viewport, session_.sheet().side_by_side(), true);
  session_.view.aspect = static_cast<double>(picture.size.x) / picture.size.y;
  session_.view.height_px = picture.size.y;
  session_.view.camera.distance *= farther(before, session_.view.aspect);
}

/// How much farther away the mesh as a whole must be seen from for a picture of another shape.
double Viewer::farther(double before, double now) const {
  if (session_.document().empty()) return 1;
  const scene::Box& bounds = session_.document().content().bounds;
  if (!(bounds.diagonal() > 0)) return 1;
  const scene::Camera& camera = session_.view.camera;
  return camera.fitting_distance(bounds, now) / camera.fitting_distance(bounds, before);
}

render::RenderSettings Viewer::settings(bool transparent) const {
  render::RenderSettings settings;
  settings.transparent = transparent;
  settings.show_surface = session_.view.surface;
  settings.lit = session_.view.light;
  settings.hidden_lines = session_.view.hidden_lines;
  settings.show_edge_codes = session_.sheet().verdicts() != nullptr;
  settings.show_edges = session_.view.edges;
  settings.show_model_edges = session_.view.model_edges;
  settings.show_model_vertices = session_.view.model_vertices;
  settings.draft = moving_;
  settings.quiet = session_.view.coloring == scene::Coloring::Classification ||
                   session_.view.coloring == scene::Coloring::None;
  const scene::View& view = session_.view;
  if (view.light_from)
    settings.light =
        glm::mat3(view.camera.view()) * glm::transpose(glm::mat3(view.light_from->view()));
  if (view.ground && !session_.document().empty()) {
    const int up = view.camera.up_axis == scene::UpAxis::Z ? 2 : 1;
    const scene::Box& bounds = session_.document().content().bounds;
    settings.show_ground =
        view.camera.eye()[up] > scene::ground_height(bounds, view.camera.up_axis);
  }
  settings.glass = session_.view.interior_edges && !session_.document().empty() &&
                   session_.document().content().volume();
  settings.glass_plane = session_.sheet().preview_cut();
  settings.glass = settings.glass || settings.glass_plane;
  if (const auto& clip = session_.view.clip; clip && !clip->cells && !session_.document().empty())
    settings.clip_plane = clip->plane(session_.document().content().bounds, scene::clip_hair);
  settings.pixel_scale = drawing_scale() * ImGui::GetIO().DisplayFramebufferScale.x;
  settings.theme = ui::scene_theme(ui::theme_kind(session_.view.theme));
  return settings;
}

/// Before each frame of a window.
void Viewer::choose_detail() {
  const auto now = Clock::now();
  if (session_.view.camera != drawn_from_) moved_at_ = now;
  drawn_from_ = session_.view.camera;
  moving_ = session_.view.detail == scene::Detail::Automatic && full_time_ > slow_drawing &&
            now - moved_at_ < rest_of_camera;
}

void Viewer::lay_out_frame() {
  update_look();
  session_.refresh();
  ImGui::NewFrame();
  em_ = ui::em();
  lines_ = interface_.draw(session_, fonts_);
  ImGui::Render();
  update_aspect();
}

/// One picture, or two of the same size with a line between them.
void Viewer::draw_scene(const scene::Camera& camera, const render::PixelRect& rect,
                        GLuint destination, bool transparent) {
  const bool coarse =
      session_.view.surface && (moving_ || session_.view.detail == scene::Detail::Coarse);
  buffers_.upload(session_.sheet().drawing().drawable(), coarse);
  scene::SurfaceDrawing* original = session_.sheet().reference_drawing();
  if (original != nullptr) original_buffers_.upload(original->drawable(), coarse);
  render::RenderSettings how = settings(transparent);
  if (original == nullptr || !session_.sheet().side_by_side()) {
    if (original != nullptr) how.ghost = &original_buffers_;
    graphics_->renderer.render(buffers_, camera, how, rect, destination);
    return;
  }
  const int half = (rect.width - 1) / 2;
  render::RenderSettings as_loaded = how;
  as_loaded.show_edge_codes = false;  // nothing is said about its edges
  graphics_->renderer.render(original_buffers_, camera, as_loaded,
                             {rect.x, rect.y, half, rect.height}, destination);
  graphics_->renderer.render(buffers_, camera, how,
                             {rect.x + rect.width - half, rect.y, half, rect.height}, destination);
}

measure::PixelArea Viewer::scene_area(glm::ivec2 pixels) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const ui::Area& area = interface_.layout().viewport;
  const auto at = [](float v) { return static_cast<int>(std::lround(v)); };
  const int left = at(area.position.x * scale.x);
  const int top = at(area.position.y * scale.y);
  const int right = std::min(pixels.x, at((area.position.x + area.size.x) * scale.x));
  const int bottom = std::min(pixels.y, at((area.position.y + area.size.y) * scale.y));
  return {left, top, right - left, bottom - top};
}

void Viewer::draw_frame(glm::ivec2 pixels, GLuint destination, bool transparent) {
  lay_out_frame();
  if (pixels.x < 1 || pixels.y < 1) return;

  const ImVec4 panel = ui::theme_colors(ui::theme_kind(session_.view.theme)).panel;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, destination);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(panel.x, panel.y, panel.z, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  const measure::PixelArea area = scene_area(pixels);
  draw_scene(session_.view.camera,
             {area.x, pixels.y - area.y - area.height, area.width, area.height}, destination,
             transparent);
  layer_.draw(*ImGui::GetDrawData(), destination);
}

/// In a window they are shown as errors are; without one they go where errors go, and nothing ends.
void Viewer::tell_warnings() {
  for (const std::string& text : std::exchange(session_.warnings, {})) {
    if (headless_)
      std::cerr << "aomd-view: " << text << std::endl;
    else
      session_.error += (session_.error.empty() ? "" : "\n") + text;
  }
}

void Viewer::print_log() {
  if (session_.log) std::cout << *session_.log << std::endl;
  session_.log.reset();
}

void Viewer::execute(const std::string& line) {
  scene::execute(session_, line);
  const std::string_view text = scene::command_text(line);
  const bool passing = text.rfind("hover ", 0) == 0;  // where the mouse goes is not worth repeating
  if (record_.is_open() && !passing && !text.empty()) record_ << text << std::endl;
  if (const auto next = std::exchange(session_.next_line, {})) execute(*next);
}

/// The dialog that asks for a picture is not to be in it, nor where the lines are played again.
void Viewer::clear_for_picture(std::string_view line) {
  const bool asks = scene::command_text(line).rfind("screenshot", 0) == 0;
  if (asks && session_.view.dialog != scene::Dialog::None) execute("dialog none");
}

void Viewer::execute_or_tell(const std::string& line) {
  in_script_ = false;  // what goes wrong from here on is to be said, not the end
  try {
    clear_for_picture(line);
    if (headless_ || !scene::asks_first(session_, line)) execute(line);
  } catch (const std::exception& error) {
    session_.error = error.what();
  }
}

/// The command line's model: a wrong one ends a program without a window, as a wrong mesh does.
void Viewer::take_model(const std::string& line) {
  headless_ ? execute(line) : execute_or_tell(line);
}

/// A mesh has arrived: remember its file; what the command line says about the camera holds for the
/// first one.
void Viewer::after_loading() {
  if (!session_.take_arrival()) return;
  const bool first = !std::exchange(shown_any_, true);
  const scene::LoadedMesh& content = session_.document().content();
  window_.set_title(content.name + " \u2013 AOMD Studio");
  if (!content.file.empty()) {
    interface_.recent.add(content.file);
    interface_.remember_folder(std::filesystem::absolute(content.file).parent_path());
  }
  if (first && !options_.camera.empty()) execute("camera " + options_.camera);
  if (first && !options_.model.empty())
    take_model("model " + scene::in_quotes(options_.model.string()));
}

void Viewer::tick(double frame_s) {
  try {
    session_.tick(std::clamp(drawing_time_, least_budget, most_budget), frame_s);
    scene::update_lesson(session_);
    after_loading();
  } catch (const std::exception& error) {
    if (in_script_) script_.fail();
    session_.error = error.what();
    session_.status = "Not opened";
  }
}

void Viewer::advance_script() {
  while (!script_.done() && !session_.quit) {
    if (!script_.advance(session_, [&](const std::string& line) { execute(line); })) return;
    in_script_ = true;
    print_log();
    if (!session_.screenshots.empty()) return;
  }
}

void Viewer::take_events(const Events& events) {
  for (const std::filesystem::path& file : events.dropped_files)
    execute_or_tell((is_cad_file(file.string()) ? "model " : "open ") +
                    scene::in_quotes(file.string()));
  for (const std::string& chord : events.chords)
    if (const std::string line = ui::Interface::line_for_chord(session_, chord); !line.empty())
      execute_or_tell(line);
}

void Viewer::ask_to_close() {
  window_.cancel_close();
  execute_or_tell("quit");
}

void Viewer::run_window() {
  int awake = frames_after_event;
  auto last = Clock::now();
  while (!session_.quit) {
    const bool waits = session_.idle() && script_.done() && awake <= 0;
    const auto before = Clock::now();
    const double wait_s =
        moving_ ? std::chrono::duration<double>(rest_of_camera).count() : idle_wait_s;
    const Events events = window_.poll(ImGui::GetIO(), waits ? wait_s : 0);
    take_events(events);
    if (window_.should_close()) ask_to_close();
    const auto now = Clock::now();
    const bool timed_out = std::chrono::duration<double>(now - before).count() >= wait_s;
    if (events.input || (waits && !timed_out)) awake = frames_after_event;
    session_.keep();
    if (const std::string line = session_.look_at_file(now); !line.empty()) {
      execute_or_tell(line);
      awake = frames_after_event;
    }
    if (!session_.warnings.empty()) awake = frames_after_event;
    tell_warnings();
    if (waits && timed_out && awake <= 0 && !moving_ && !ImGui::GetIO().WantTextInput) continue;
    awake = session_.idle() ? awake - 1 : frames_after_event;
    tick(std::chrono::duration<double>(now - last).count());
    last = now;
    advance_script();
    choose_detail();
    const auto drawing = Clock::now();
    draw_frame(window_.framebuffer_size(), 0);
    window_.present();
    drawing_time_ = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - drawing);
    if (!moving_) full_time_ = drawing_time_;
    ImGui::GetIO().MouseDoubleClickTime = double_click_time(drawing_time_);
    if (!lines_.empty()) awake = frames_after_event;
    for (const std::string& line : std::exchange(lines_, {})) execute_or_tell(line);
    print_log();
    take_screenshots_or_tell();
  }
  if (remembers()) save_settings();
  if (session_.recovery) session_.recovery->finish();
}

void Viewer::finish() {
  session_.finish();
  scene::update_lesson(session_);
  tell_warnings();
}

void Viewer::run_headless() {
  finish();
  after_loading();
  while ((!script_.done() || session_.series() != nullptr) && !session_.quit) {
    advance_script();
    try {
      finish();
      after_loading();
      take_screenshots();
    } catch (const std::exception&) {
      script_.fail();
    }
  }
  if (session_.recovery) session_.recovery->finish();
}

}  // namespace aomd::app
