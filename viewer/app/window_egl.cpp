#include "viewer/app/window_egl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>
#include <cstring>

#include "viewer/app/window_headless.h"

namespace aomd::app {
namespace {

/// An initialised display; EGL_NO_DISPLAY where there is none.
EGLDisplay open_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (extensions != nullptr &&
      std::strstr(extensions, "EGL_MESA_platform_surfaceless") != nullptr) {
    const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display != nullptr) {
      EGLDisplay display =
          get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
      if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE)
        return display;
    }
  }
  EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE)
    return display;
  return EGL_NO_DISPLAY;
}

/// Display, pbuffer and context, undone on every way out.
class EglWindow : public HeadlessWindow {
 public:
  explicit EglWindow(glm::ivec2 size) : HeadlessWindow(size), display_(open_display()) {
    if (display_ == EGL_NO_DISPLAY)
      throw WindowError("EGL: there is no display that works without a window");
    try {
      make_context(size);
    } catch (...) {
      close();
      throw;
    }
  }
  ~EglWindow() override { close(); }
  EglWindow(const EglWindow&) = delete;
  EglWindow& operator=(const EglWindow&) = delete;

  [[nodiscard]] render::GetProcAddress get_proc_address() const override {
    return eglGetProcAddress;
  }
  [[nodiscard]] std::string_view kind() const override { return "EGL"; }

 private:
  void make_context(glm::ivec2 size) {
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_NONE};
    constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
    const EGLint surface_size[] = {EGL_WIDTH, size.x, EGL_HEIGHT, size.y, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
      throw WindowError("EGL: no configuration for OpenGL with an 8 bit pbuffer");
    surface_ = eglCreatePbufferSurface(display_, config, surface_size);
    if (surface_ == EGL_NO_SURFACE)
      throw WindowError("EGL: cannot draw into a picture of this size");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT ||
        eglMakeCurrent(display_, surface_, surface_, context_) == EGL_FALSE)
      throw WindowError("EGL: cannot make an OpenGL 3.3 core context");
  }
  void close() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    eglTerminate(display_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Window> make_egl_window(glm::ivec2 size) {
  setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
  return std::make_unique<EglWindow>(size);
}

}  // namespace aomd::app
