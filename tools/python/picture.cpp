// Pictures without a display.

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "tools/python/images.h"
#include "viewer/app/viewer.h"
#include "viewer/commands/commands.h"

namespace aomd::python {
namespace {

io::Image drawn(const MeshHandle& mesh, glm::ivec2 size, const std::vector<std::string>& commands,
                bool transparent) {
  static std::mutex one_at_a_time;  // ImGui has one present context
  const std::lock_guard lock(one_at_a_time);
  app::Options options;
  options.size = size;
  options.interface = false;
  scene::Session session;
  scene::LoadRequest request;
  request.sample = "mesh";
  request.data = mesh;
  session.start_loading(std::move(request));
  const auto window = app::make_headless_window(app::HeadlessKind::Auto, size);
  app::Viewer viewer(*window, session, options, true);
  viewer.run_headless();
  for (const std::string& line : commands) {
    scene::execute(session, line);
    session.finish();
  }
  return viewer.scene_picture(size, transparent);
}

py::array picture(const MeshHandle& mesh, int width, int height,
                  const std::vector<std::string>& commands, bool transparent) {
  io::Image image;
  {
    const py::gil_scoped_release unlocked;
    image = drawn(mesh, {width, height}, commands, transparent);
  }
  return array_of(std::move(image));
}

}  // namespace

void add_picture(py::module_& module) {
  module.def("render", &picture);
  add_images(module);
}

}  // namespace aomd::python
