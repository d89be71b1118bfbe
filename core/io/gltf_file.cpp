#include "core/io/gltf_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/io/base64.h"

namespace aomd::io::detail {
namespace {

using Json = nlohmann::json;

constexpr std::size_t header_size = 12, chunk_header = 8;
constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k > 0; --k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + k - 1]);
  return value;
}

const Json* member(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? &*found : nullptr;
}

const std::string* text_of(const Json& object, const char* key) {
  const Json* const found = member(object, key);
  return found ? found->get_ptr<const std::string*>() : nullptr;
}

std::optional<std::uint64_t> number_of(const Json& object, const char* key) {
  const Json* const found = member(object, key);
  if (!found || !found->is_number_unsigned()) return {};
  return found->get<std::uint64_t>();
}

/// How deep brackets lie in each other; nested functions would go as deep.
std::size_t depth_of(std::string_view json) {
  std::size_t depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\') ++i;
    if (c == '"') in_text = !in_text;
    if (in_text) continue;
    if (c == '{' || c == '[') deepest = std::max(deepest, ++depth);
    if ((c == '}' || c == ']') && depth > 0) --depth;
  }
  return deepest;
}

Json parsed(const Source& source, std::string_view text) {
  constexpr std::size_t deepest = 100;
  if (depth_of(text) > deepest) source.fail("is nested too deeply to be a glTF file");
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto offset = static_cast<std::size_t>(text.data() - source.bytes.data()) +
                        std::min(error.byte, text.size() - 1);
    if (text.data() != source.bytes.data()) source.fail_at_byte(offset, "its JSON is damaged");
    source.fail_at_line(offset, "this is no JSON, as .gltf files are");
  } catch (const Json::out_of_range&) {
    source.fail("its JSON has a number that is too large");
  }
}

void check_version(const Source& source, const Json& tree) {
  const Json* const asset = member(tree, "asset");
  const std::string* const version = asset ? text_of(*asset, "version") : nullptr;
  if (!version) source.fail("is JSON, but no glTF file: it has no \"asset\" with a version");
  if (!version->starts_with("2."))
    source.fail("is glTF " + shown(*version) + ", and only 2.0 can be read");
}

/// Extensions without which the numbers cannot be had.
void check_extensions(const Source& source, const Json& tree, ItemList& left_out) {
  const Json* const required = member(tree, "extensionsRequired");
  if (!required || !required->is_array()) return;
  for (const Json& each : *required) {
    const std::string name = each.is_string() ? each.get<std::string>() : std::string();
    if (name == "KHR_draco_mesh_compression")
      source.fail("is compressed by Draco, which cannot be read: export it without compression");
    if (name.find("meshopt_compression") != std::string::npos)
      source.fail(
          "is compressed by meshoptimizer, which cannot be read: export it without "
          "compression");
    const bool kept = name.starts_with("KHR_materials_") || name == "KHR_texture_transform";
    if (!kept && name != "KHR_mesh_quantization") left_out.add("extension " + shown(name));
  }
}

/// Where pictures do not go on beyond their rims.
bool has_other_wrapping(const Json& tree) {
  static constexpr std::uint64_t repeat = 10497;
  const Json* const samplers = member(tree, "samplers");
  if (!samplers || !samplers->is_array()) return false;
  return std::any_of(samplers->begin(), samplers->end(), [](const Json& sampler) {
    return number_of(sampler, "wrapS").value_or(repeat) != repeat ||
           number_of(sampler, "wrapT").value_or(repeat) != repeat;
  });
}

/// Members that say nothing of meshes, and that tinygltf therefore need not see.
void drop_others(Json& tree, ItemList& left_out) {
  for (const auto& [key, what] : {std::pair("animations", "animations"),
                                  std::pair("skins", "skins"), std::pair("cameras", "cameras")}) {
    const Json* const found = member(tree, key);
    if (found && found->is_array() && !found->empty()) left_out.add(what);
  }
  if (has_other_wrapping(tree)) left_out.add("how pictures go on beyond their rims");
  for (const char* key : {"animations", "skins", "cameras", "samplers", "extensions", "extras",
                          "extensionsUsed", "extensionsRequired"})
    tree.erase(key);
}

/// The array of one name, taken out of the tree; empty where there is none.
Json take_array(Json& tree, const char* key) {
  Json taken = Json::array();
  const auto found = tree.find(key);
  if (found == tree.end()) return taken;
  if (found->is_array()) taken = std::move(*found);
  tree.erase(found);
  return taken;
}

tinygltf::Model model_of(const Source& source, const std::string& text) {
  tinygltf::Model model;
  std::string error, warning;
  bool good = false;
  try {
    good = tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text.data(),
                                                    static_cast<unsigned>(text.size()), "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!good) source.fail("no sound glTF: " + error.substr(0, error.find('\n')));
  return model;
}

int hex_value(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::size_t at = digits.find(lower({&c, 1}));
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

}  // namespace

GltfFile::GltfFile(const Source& source) : source_(source), size_(source.bytes.size()) {
  read_json(split_container());
}

/// The JSON of the file; the binary chunk of a .glb is kept.
std::string_view GltfFile::split_container() {
  const std::string_view bytes = source_.bytes;
  binary_ = bytes.starts_with("glTF");
  if (!binary_) return bytes;
  if (bytes.size() < header_size + chunk_header) source_.fail("ends early: it has no chunk");
  if (const std::uint32_t version = word(bytes, 4); version != 2)
    source_.fail("is glTF " + std::to_string(version) + ", and only 2.0 can be read");
  const std::size_t length = word(bytes, 8);
  if (length > bytes.size())
    source_.fail_at_byte(bytes.size(),
                         "the file ends early: its header promises " + counted(length, "byte"));
  std::string_view json;
  for (std::size_t at = header_size; at + chunk_header <= length;) {
    const std::size_t size = word(bytes, at), start = at + chunk_header;
    if (size > length - start)
      source_.fail_at_byte(at, "a chunk is promised " + counted(size, "byte") + ", and " +
                                   std::to_string(length - start) + " follow");
    const std::uint32_t kind = word(bytes, at + 4);
    if (kind == json_chunk && json.empty()) json = bytes.substr(start, size);
    if (kind == binary_chunk && chunk_.empty()) chunk_ = bytes.substr(start, size);
    at = start + size;
  }
  if (json.empty()) source_.fail("has no JSON chunk");
  return json;
}

void GltfFile::read_json(std::string_view text) {
  Json tree = parsed(source_, text);
  check_version(source_, tree);
  check_extensions(source_, tree, left_out_);
  drop_others(tree, left_out_);
  for (const Json& buffer : take_array(tree, "buffers")) {
    const auto length = number_of(buffer, "byteLength");
    if (!length) source_.fail("buffer " + std::to_string(buffers_.size()) + " has no byteLength");
    take_buffer(text_of(buffer, "uri"), *length);
  }
  for (const Json& image : take_array(tree, "images")) {
    const auto view = number_of(image, "bufferView");
    const std::string *name = text_of(image, "name"), *uri = text_of(image, "uri");
    images_.push_back({name ? *name : "", uri ? *uri : "",
                       view && *view < 0x7fffffff ? static_cast<int>(*view) : -1});
  }
  if (const Json* const materials = member(tree, "materials")) materials_ = materials->dump();
  model_ = model_of(source_, tree.dump());
}

void GltfFile::take_buffer(const std::string* uri, std::uint64_t length) {
  const std::string what = "buffer " + std::to_string(buffers_.size());
  if (!uri && !(binary_ && buffers_.empty())) source_.fail(what + " has no uri");
  const std::string_view bytes = uri ? bytes_of_uri(*uri) : chunk_;
  if (bytes.size() < length)
    source_.fail(what + " is promised " + counted(length, "byte") + ", and there are " +
                 std::to_string(bytes.size()));
  buffers_.push_back(bytes.substr(0, static_cast<std::size_t>(length)));
}

std::string_view GltfFile::bytes_of_uri(const std::string& uri) {
  const auto known = files_.find(uri);
  if (known != files_.end()) return known->second;
  std::string bytes;
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos) source_.fail("a data URI has no data");
    bytes = from_base64(std::string_view(uri).substr(comma + 1));
  } else {
    const std::string file = file_of_uri(uri);
    if (file.empty()) source_.fail("the buffer " + shown(uri) + " is no file beside this one");
    const auto path = std::filesystem::path(source_.name).parent_path() / file;
    try {
      bytes = FileBytes(path).view();
    } catch (const ReadError&) {
      source_.fail("its buffer " + shown(file) + " cannot be read");
    }
    size_ += bytes.size();
  }
  return files_.emplace(uri, std::move(bytes)).first->second;
}

std::string_view GltfFile::view(int index) const {
  const std::string what = "buffer view " + std::to_string(index);
  if (index < 0 || static_cast<std::size_t>(index) >= model_.bufferViews.size())
    source_.fail("there is no " + what);
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers_.size())
    source_.fail(what + " is of buffer " + std::to_string(view.buffer) + ", which is not there");
  if (view.extensions.contains("EXT_meshopt_compression"))
    source_.fail(
        "is compressed by meshoptimizer, which cannot be read: export it without "
        "compression");
  const std::string_view bytes = buffers_[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
    source_.fail(what + " goes beyond its buffer of " + counted(bytes.size(), "byte"));
  return bytes.substr(view.byteOffset, view.byteLength);
}

std::vector<Picture> GltfFile::pictures() const {
  std::vector<Picture> pictures;
  for (const Image& image : images_) {
    Picture picture{image.name, {}};
    if (image.view >= 0)
      picture.bytes = view(image.view);
    else if (image.uri.starts_with("data:"))
      picture.bytes = from_base64(std::string_view(image.uri).substr(image.uri.find(',') + 1));
    else
      picture.name = file_of_uri(image.uri);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

std::string file_of_uri(std::string_view uri) {
  if (uri.find(':') != std::string_view::npos || uri.starts_with("/")) return {};
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && hex_value(uri[i + 1]) >= 0 &&
                       hex_value(uri[i + 2]) >= 0;
    name += coded ? static_cast<char>(16 * hex_value(uri[i + 1]) + hex_value(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return name;
}

std::string uri_of_file(std::string_view name) {
  constexpr std::string_view plain = "-._~/!$&'()*+,;=@", digits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       plain.find(c) != std::string_view::npos;
    if (stays)
      uri += c;
    else
      (uri += '%').append({digits[byte >> 4], digits[byte & 15u]});
  }
  return uri;
}

}  // namespace aomd::io::detail
