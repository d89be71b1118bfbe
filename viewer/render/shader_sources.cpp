#include "viewer/render/shader_sources.h"

#include <fstream>
#include <iterator>

#include "viewer/render/gl.h"

namespace aomd::render {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw GlError(path.string() + ": cannot read the shader");
  return text;
}

}  // namespace

ShaderSources load_shader_sources(const std::optional<std::filesystem::path>& folder) {
  ShaderSources sources;
  for (const scene::EmbeddedText& embedded : embedded_texts()) {
    const std::string name(embedded.name);
    sources.emplace(name, folder ? read_text(*folder / name) : std::string(embedded.text));
  }
  return sources;
}

}  // namespace aomd::render
