// Pictures without a display.

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/python/arrays.h"
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
  auto* const pixels = new std::vector<std::uint8_t>(std::move(image.rgba));
  const py::capsule owner(pixels,
                          [](void* p) { delete static_cast<std::vector<std::uint8_t>*>(p); });
  return py::array_t<std::uint8_t>({image.height, image.width, 4}, pixels->data(), owner);
}

using RgbaArray = py::array_t<std::uint8_t, py::array::c_style>;

py::bytes png_of(const RgbaArray& pixels) {
  if (pixels.ndim() != 3 || pixels.shape(2) != 4)
    throw std::invalid_argument("a picture has the shape (height, width, 4)");
  io::Image image(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
  image.rgba.assign(pixels.data(), pixels.data() + pixels.size());
  return io::to_png(image);
}

}  // namespace

void add_picture(py::module_& module) {
  module.def("render", &picture);
  module.def("to_png", &png_of);
}

}  // namespace aomd::python
