#include "viewer/render/shader_program.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

namespace aomd::render {
namespace {

std::string shader_log(const Gl& gl, GLuint shader) {
  GLint length = 0;
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  gl.GetShaderInfoLog(shader, length, nullptr, log.data());
  log.resize(log.find('\0'));
  return log;
}

std::string program_log(const Gl& gl, GLuint program) {
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length) + 1, '\0');
  gl.GetProgramInfoLog(program, length, nullptr, log.data());
  log.resize(log.find('\0'));
  return log;
}

/// Compiles one shader and attaches it; the program keeps it alive.
void attach(const Gl& gl, GLuint program, GLenum kind, const ShaderSources& sources,
            const std::string& file, const std::string& preamble) {
  const auto found = sources.find(file);
  if (found == sources.end()) throw GlError("there is no shader " + file);
  std::string whole = found->second;
  whole.insert(std::min(whole.size(), whole.find('\n') + 1), preamble);
  const char* text = whole.c_str();
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  const std::string log = good == 0 ? shader_log(gl, shader) : std::string();
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);
  if (good == 0) throw GlError("shader " + file + ": " + log);
}

void link(const Gl& gl, GLuint program, const ShaderSources& sources, const std::string& name,
          const std::string& preamble) {
  attach(gl, program, GL_VERTEX_SHADER, sources, name + ".vert", preamble);
  attach(gl, program, GL_FRAGMENT_SHADER, sources, name + ".frag", preamble);
  gl.LinkProgram(program);
  GLint good = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good == 0) throw GlError("shaders " + name + ": " + program_log(gl, program));
}

}  // namespace

ShaderProgram::ShaderProgram(const Gl& gl, const ShaderSources& sources, const std::string& name,
                             const std::string& preamble)
    : gl_(gl), id_(gl.CreateProgram()) {
  try {
    link(gl_, id_, sources, name, preamble);
  } catch (...) {
    gl_.DeleteProgram(id_);
    throw;
  }
}

ShaderProgram::~ShaderProgram() { gl_.DeleteProgram(id_); }

void ShaderProgram::use() const { gl_.UseProgram(id_); }

void ShaderProgram::set(const char* name, int value) { gl_.Uniform1i(location(name), value); }
void ShaderProgram::set(const char* name, float value) { gl_.Uniform1f(location(name), value); }
void ShaderProgram::set(const char* name, const glm::vec2& value) {
  gl_.Uniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec3& value) {
  gl_.Uniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec4& value) {
  gl_.Uniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat4& value) {
  gl_.UniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

GLint ShaderProgram::location(const char* name) {
  const auto [entry, fresh] = locations_.try_emplace(name, -1);
  if (fresh) entry->second = gl_.GetUniformLocation(id_, name);
  return entry->second;
}

ShaderProgram& ShaderVariants::get(const std::string& preamble) {
  std::unique_ptr<ShaderProgram>& program = programs_[preamble];
  if (!program) program = std::make_unique<ShaderProgram>(gl_, sources_, name_, preamble);
  return *program;
}

}  // namespace aomd::render
