#include "viewer/app/window_osmesa.h"

#include <GL/osmesa.h>

#include <cstdint>
#include <cstdlib>

#include "viewer/app/window_headless.h"

namespace aomd::app {
namespace {

class OsMesaWindow : public HeadlessWindow {
 public:
  explicit OsMesaWindow(glm::ivec2 size)
      : HeadlessWindow(size),
        pixels_(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
    constexpr int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (context_ == nullptr) throw WindowError("OSMesa: cannot make an OpenGL 3.3 core context");
    if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, size.x, size.y) == GL_FALSE) {
      OSMesaDestroyContext(context_);
      throw WindowError("OSMesa: cannot draw into a picture of this size");
    }
  }
  ~OsMesaWindow() override { OSMesaDestroyContext(context_); }
  OsMesaWindow(const OsMesaWindow&) = delete;
  OsMesaWindow& operator=(const OsMesaWindow&) = delete;

  [[nodiscard]] render::GetProcAddress get_proc_address() const override {
    return &OSMesaGetProcAddress;
  }
  [[nodiscard]] std::string_view kind() const override { return "OSMesa"; }

 private:
  std::vector<std::uint8_t> pixels_;
  OSMesaContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Window> make_osmesa_window(glm::ivec2 size) {
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
  return std::make_unique<OsMesaWindow>(size);
}

}  // namespace aomd::app
