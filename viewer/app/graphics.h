#pragma once
// What drawing in a context takes, whatever is drawn: the compiled shaders are most of it.

#include <filesystem>
#include <optional>

#include "viewer/app/window.h"
#include "viewer/render/renderer.h"
#include "viewer/render/shader_sources.h"

namespace aomd::app {

/// May be shared by viewers that follow one another in one context.
struct Graphics {
  /// Compiles the shaders; those of a folder, where one is named. Throws render::GlError.
  Graphics(const Window& window, const std::filesystem::path& shaders)
      : gl(render::load_gl(window.get_proc_address())),
        sources(
            render::load_shader_sources(shaders.empty() ? std::nullopt : std::optional(shaders))),
        renderer(gl, sources),
        panels(gl, sources, "ui") {}
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  render::Gl gl;
  render::ShaderSources sources;
  render::Renderer renderer;
  render::ShaderProgram panels;
};

}  // namespace aomd::app
