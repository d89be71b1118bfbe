#include "core/io/gltf_materials.h"

#include <initializer_list>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/io/named_faces.h"

namespace aomd::io::detail {
namespace {

using Json = nlohmann::json;

constexpr const char *shading = "pbrMetallicRoughness", *colour = "baseColorTexture";

bool is_texture(const Json& value) {
  return value.is_object() && value.contains("index") && value["index"].is_number_unsigned();
}

/// Gives every texture in a tree the number that it has elsewhere, and drops what is none. Of the
/// picture of the colour Material has the number.
void renumber(Json& tree, const PictureOfTexture& number_of) {
  std::vector<std::string> dropped;
  for (const auto& item : tree.items()) {
    Json& value = item.value();
    if (item.key().ends_with("Texture") && item.key() != colour) {
      const std::uint32_t number =
          is_texture(value) ? number_of(value["index"].get<std::uint64_t>()) : Material::no_picture;
      if (number == Material::no_picture)
        dropped.push_back(item.key());
      else
        value["index"] = number;
    }
    if (value.is_structured()) renumber(value, number_of);
  }
  for (const std::string& key : dropped) tree.erase(key);
}

/// Nothing stays under a key of a type that glTF does not have there.
void keep_objects(Json& tree, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const auto found = tree.find(key); found != tree.end() && !found->is_object())
      tree.erase(found);
}

void erase_empty(Json& object, const char* key) {
  const auto found = object.find(key);
  if (found != object.end() && found->is_object() && found->empty()) object.erase(found);
}

/// What Material holds, and what goes without saying.
void erase_known(Json& material) {
  for (const char* key : {"name", "doubleSided"}) material.erase(key);
  if (const Json mode = material.value("alphaMode", Json()); !mode.is_string() || mode == "OPAQUE")
    material.erase("alphaMode");
  keep_objects(material, {shading, "extensions"});
  if (!material.contains(shading)) return;
  Json& looks = material[shading];
  keep_objects(looks, {colour, "extensions"});
  for (const char* key : {"baseColorFactor", "metallicFactor", "roughnessFactor"}) looks.erase(key);
  if (looks.contains(colour)) {
    looks[colour].erase("index");
    if (looks[colour].value("texCoord", Json()) == 0) looks[colour].erase("texCoord");
  }
  erase_empty(looks, colour);
  erase_empty(material, shading);
}

void collect_extensions(const Json& tree, std::set<std::string>& names) {
  for (const auto& item : tree.items()) {
    if (item.key() == "extensions" && item.value().is_object())
      for (const auto& extension : item.value().items()) names.insert(extension.key());
    if (item.value().is_structured()) collect_extensions(item.value(), names);
  }
}

/// How the picture of the colour lies says nothing where there is none.
void drop_lost_picture(Json& material) {
  const auto looks = material.find(shading);
  if (looks == material.end() || !looks->is_object() || !looks->contains(colour)) return;
  if (!is_texture((*looks)[colour])) looks->erase(colour);
}

}  // namespace

std::string rest_of_material(const Json& material, const std::string& name,
                             const PictureOfTexture& picture) {
  if (!material.is_object()) return {};
  Json rest = material;
  erase_known(rest);
  renumber(rest, picture);
  erase_empty(rest, shading);
  if (rest.empty()) return {};
  rest["name"] = name;
  return rest.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void add_rests(const MeshData& mesh, Json& tree) {
  const auto pictures = static_cast<std::uint32_t>(mesh.appearance.pictures.size());
  const auto same = [pictures](std::uint64_t n) {
    return n < pictures ? static_cast<std::uint32_t>(n) : Material::no_picture;
  };
  std::set<std::string> extensions;
  for (const Remark& remark : mesh.remarks) {
    if (remark.keyword != gltf_material || !tree.contains("materials")) continue;
    Json rest = Json::parse(remark.text, nullptr, false);
    if (!rest.is_object()) continue;
    renumber(rest, same);
    for (Json& material : tree["materials"]) {
      if (material.value("name", Json()) != rest.value("name", Json())) continue;
      material.merge_patch(rest);
      drop_lost_picture(material);
      collect_extensions(material, extensions);
    }
  }
  if (!extensions.empty()) tree["extensionsUsed"] = extensions;
}

}  // namespace aomd::io::detail
