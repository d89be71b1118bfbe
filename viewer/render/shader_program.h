#pragma once
// A linked pair of shaders.

#include <string>
#include <unordered_map>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "viewer/render/gl.h"
#include "viewer/render/shader_sources.h"

namespace aomd::render {

/// Owns a program object; its context must be current whenever a member runs, the destructor
/// included.
class ShaderProgram {
 public:
  /// Compiles NAME.vert and NAME.frag. Throws GlError with the compiler's message.
  ShaderProgram(const Gl& gl, const ShaderSources& sources, const std::string& name);
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const;
  /// Sets a uniform of the program, which must be in use. A name that the compiler dropped is
  /// passed over.
  void set(const char* name, int value);
  void set(const char* name, float value);
  void set(const char* name, const glm::vec2& value);
  void set(const char* name, const glm::vec3& value);
  void set(const char* name, const glm::vec4& value);
  void set(const char* name, const glm::mat4& value);

 private:
  GLint location(const char* name);

  const Gl& gl_;
  GLuint id_ = 0;
  std::unordered_map<std::string, GLint> locations_;
};

}  // namespace aomd::render
