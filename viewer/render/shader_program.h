#pragma once
// A linked pair of shaders.

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

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
  /// Compiles NAME.vert and NAME.frag, with a `preamble` behind their first line. Throws GlError
  /// with the compiler's message.
  ShaderProgram(const Gl& gl, const ShaderSources& sources, const std::string& name,
                const std::string& preamble = {});
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

/// The programs that one pair of shaders makes by what is defined in it, each compiled at its first
/// use.
class ShaderVariants {
 public:
  ShaderVariants(const Gl& gl, ShaderSources sources, std::string name)
      : gl_(gl), sources_(std::move(sources)), name_(std::move(name)) {}
  /// `preamble`: lines of "#define". Throws GlError.
  [[nodiscard]] ShaderProgram& get(const std::string& preamble);

 private:
  const Gl& gl_;
  ShaderSources sources_;
  std::string name_;
  std::map<std::string, std::unique_ptr<ShaderProgram>, std::less<>> programs_;
};

}  // namespace aomd::render
