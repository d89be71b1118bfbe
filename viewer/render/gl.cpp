#include "viewer/render/gl.h"

#include <string>

namespace aomd::render {
namespace {

void require_version(const Gl& gl) {
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (10 * major + minor < 33)
    throw GlError("OpenGL 3.3 is needed, this context has " + std::to_string(major) + "." +
                  std::to_string(minor));
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two statements, repeated for each function
Gl load_gl(GetProcAddress get_proc_address) {
  Gl gl;
#define AOMD_GL_LOAD(type, name)                                  \
  gl.name = reinterpret_cast<type>(get_proc_address("gl" #name)); \
  if (gl.name == nullptr) throw GlError("OpenGL has no function gl" #name);
  AOMD_GL_FUNCTIONS(AOMD_GL_LOAD)
#undef AOMD_GL_LOAD
  require_version(gl);
  return gl;
}

}  // namespace aomd::render
