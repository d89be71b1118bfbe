// glTF 2.0: one mesh of a primitive for each material, whose vertices are split where values jump.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <tuple>

#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/io/base64.h"
#include "core/io/byte_writer.h"
#include "core/io/class_names.h"
#include "core/io/formats.h"
#include "core/io/gltf_accessors.h"
#include "core/io/gltf_arrays.h"
#include "core/io/gltf_columns.h"
#include "core/io/gltf_materials.h"
#include "core/io/gltf_rows.h"
#include "core/io/held_arrays.h"
#include "core/io/picture_files.h"

namespace aomd::io::detail {
namespace {

using Json = nlohmann::json;

/// Text that JSON can hold: bytes that are no UTF-8 become replacement characters.
std::string in_utf8(const std::string& text) {
  const std::string dumped = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(dumped).get<std::string>();
}

/// What faces of one primitive have in common: material, names, and which arrays have numbers.
struct Look {
  std::int32_t material = -1;
  std::string group, object, smoothing;
  std::vector<bool> present;

  friend bool operator<(const Look& a, const Look& b) {
    return std::tie(a.material, a.group, a.object, a.smoothing, a.present) <
           std::tie(b.material, b.group, b.object, b.smoothing, b.present);
  }
};

struct Part {
  Look look;
  std::vector<std::uint32_t> rows;  ///< of the corners of its triangles
};

class GltfWriter {
 public:
  GltfWriter(const MeshData& mesh, FilesBeside* files)
      : mesh_(mesh),
        files_(files),
        arrays_(gltf_arrays(mesh)),
        names_(obj_arrays(mesh)),
        rows_(mesh, arrays_) {}

  void write() {
    model_.asset.version = "2.0";
    model_.asset.generator = "AOMD Studio";
    put_materials();
    put_mesh();
    put_pictures();
  }

  /// The JSON; numbers are in a file of this URI, or in the binary chunk where that is empty.
  std::string json(const std::string& uri) {
    std::ostringstream stream;
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, false);
    Json tree = Json::parse(stream.str());
    if (!images_.empty()) tree["images"] = images_;
    add_rests(mesh_, tree);
    if (!bin_.empty()) {
      Json buffer{{"byteLength", bin_.size()}};
      if (!uri.empty()) buffer["uri"] = uri;
      tree["buffers"] = Json::array({buffer});
    }
    return tree.dump();
  }

  [[nodiscard]] std::string take_bin() { return std::move(bin_); }
  [[nodiscard]] const std::string& bin() const { return bin_; }
  /// Values at corners that are no numbers, on faces that have some.
  [[nodiscard]] std::size_t zeros() const { return zeros_; }

 private:
  void put_materials() {
    for (const Material& m : mesh_.appearance.materials) put_material(m);
    if (!names_.material) return;
    for (const std::string& name : names_.material->names)
      if (!name.empty() && !material_.contains(name)) put_material({.name = name});
  }

  void put_material(const Material& m) {
    material_.try_emplace(m.name, static_cast<std::int32_t>(model_.materials.size()));
    tinygltf::Material material;
    material.name = in_utf8(m.name);
    material.doubleSided = m.two_sided;
    auto& pbr = material.pbrMetallicRoughness;
    pbr.baseColorFactor.assign(m.colour.begin(), m.colour.end());
    pbr.metallicFactor = m.metallic, pbr.roughnessFactor = m.roughness;
    if (m.picture < mesh_.appearance.pictures.size())
      pbr.baseColorTexture.index = static_cast<int>(m.picture);
    model_.materials.push_back(std::move(material));
  }

  /// Pictures that are bytes stay so; files are named, or taken along in a file that holds all.
  void put_pictures() {
    for (const Picture& picture : mesh_.appearance.pictures) {
      tinygltf::Texture texture;
      texture.source = static_cast<int>(images_.size());
      model_.textures.push_back(texture);
      const bool names_file = picture.bytes.empty() && files_ != nullptr;
      const auto bytes = names_file ? std::nullopt : picture_bytes(mesh_.appearance, picture);
      Json image = Json::object();
      if (bytes) {
        image["bufferView"] = view_of(*bytes, 0, 0);
        image["mimeType"] = picture_type(*bytes);
        image["name"] = in_utf8(picture.name);
      } else {
        image["uri"] = in_utf8(uri_of_file(names_file ? files_->name_of(picture) : picture.name));
      }
      images_.push_back(std::move(image));
    }
  }

  int view_of(std::string_view bytes, std::size_t stride, int target) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bin_.size();
    view.byteLength = bytes.size();
    view.byteStride = stride;
    view.target = target;
    bin_ += bytes;
    bin_.resize((bin_.size() + 3) / 4 * 4, '\0');
    model_.bufferViews.push_back(view);
    return static_cast<int>(model_.bufferViews.size() - 1);
  }

  /// Elements of any type, each at a multiple of four bytes; get(i, k) is a number of one.
  template <class Get>
  int accessor_of(NumberType type, int components, std::size_t count, int target, Get&& get) {
    const std::size_t each = size_of(type) * static_cast<std::size_t>(components);
    const bool tight = each % 4 == 0 || target == TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    const std::size_t stride = tight ? each : (each + 3) / 4 * 4;
    ByteWriter bytes;
    bytes.reserve(stride * count);
    for (std::size_t i = 0; i < count; ++i) {
      for (int k = 0; k < components; ++k)
        use_as(type, get(i, k), [&](auto x) { bytes.raw<std::endian::little>(x); });
      for (std::size_t k = each; k < stride; ++k) bytes << '\0';
    }
    tinygltf::Accessor accessor;
    accessor.bufferView = view_of(bytes.take(), tight ? 0 : stride, target);
    accessor.componentType = gltf_component(type);
    accessor.type = gltf_type(components);
    accessor.count = count;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size() - 1);
  }

  void put_mesh();
  void put_positions();
  void put_values();
  std::vector<Part> parts();
  Look look_of(std::size_t face, std::size_t corner);
  void put_primitive(int mode, const std::vector<std::uint32_t>& list, const Look& look);
  void put_lines();
  void put_points();
  void put_bare(int mode, const std::vector<std::uint32_t>& list);

  const MeshData& mesh_;
  FilesBeside* files_;  ///< none: pictures become part of the file
  std::vector<GltfArray> arrays_;
  ObjArrays names_;
  GltfRows rows_;
  tinygltf::Model model_;
  tinygltf::Mesh shape_;
  std::map<std::string, std::int32_t> material_;
  std::map<std::string, int> attributes_;
  Json images_ = Json::array();
  std::string bin_;
  std::size_t zeros_ = 0;
};

// A scene without nodes would be written as none at all.
void GltfWriter::put_mesh() {
  if (mesh_.positions.empty()) return;
  put_positions();
  put_values();
  for (const Part& part : parts()) put_primitive(TINYGLTF_MODE_TRIANGLES, part.rows, part.look);
  put_lines();
  put_points();
  model_.meshes.push_back(std::move(shape_));
  tinygltf::Node node;
  node.mesh = 0;
  if (names_.object && names_.object->names.size() == 1)
    node.name = in_utf8(names_.object->names[0]);
  model_.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.nodes = {0};
  model_.scenes.push_back(std::move(scene));
  model_.defaultScene = 0;
}

void GltfWriter::put_positions() {
  const auto get = [&](std::size_t row, int k) { return mesh_.positions[rows_.vertex(row)][k]; };
  const int index =
      accessor_of(NumberType::Float32, 3, rows_.size(), TINYGLTF_TARGET_ARRAY_BUFFER, get);
  auto& accessor = model_.accessors[static_cast<std::size_t>(index)];
  for (int k = 0; k < 3; ++k) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const glm::dvec3& p : mesh_.positions) {
      const auto x = static_cast<double>(static_cast<float>(p[k]));
      least = std::min(least, x), most = std::max(most, x);
    }
    accessor.minValues.push_back(least), accessor.maxValues.push_back(most);
  }
  attributes_["POSITION"] = index;
  if (!rows_.places_repeat()) return;
  attributes_[gltf_vertex] =
      accessor_of(NumberType::UInt16, 2, rows_.size(), TINYGLTF_TARGET_ARRAY_BUFFER,
                  [&](std::size_t row, int k) {
                    const std::uint32_t v = rows_.vertex(row);
                    return static_cast<double>(k == 0 ? v & 0xffffu : v >> 16);
                  });
}

void GltfWriter::put_values() {
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    const GltfArray& array = arrays_[a];
    const bool downwards = array.semantic.starts_with("TEXCOORD_");
    const auto get = [&](std::size_t row, int k) {
      const double x = rows_.value(a, row, k);
      if (!std::isfinite(x)) return 0.0;
      return downwards && k == 1 ? 1 - x : x;
    };
    const int index = accessor_of(array.type, array.array->components, rows_.size(),
                                  TINYGLTF_TARGET_ARRAY_BUFFER, get);
    model_.accessors[static_cast<std::size_t>(index)].normalized =
        array.semantic.starts_with("COLOR_") && is_integer(array.type);
    attributes_[in_utf8(array.semantic)] = index;
  }
}

std::vector<Part> GltfWriter::parts() {
  std::vector<Part> parts;
  std::map<Look, std::size_t> known;
  std::size_t face = 0, corner = 0;
  for_each_entity(mesh_.faces, [&](auto corners, ModelRef) {
    const Look look = look_of(face++, corner);
    const auto [at, is_new] = known.try_emplace(look, parts.size());
    if (is_new) parts.push_back({look, {}});
    std::vector<std::uint32_t>& list = parts[at->second].rows;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      for (const std::size_t c : {std::size_t{0}, k, k + 1})
        list.push_back(rows_.of_corner(corner + c));
    corner += corners.size();
  });
  return parts;
}

Look GltfWriter::look_of(std::size_t face, std::size_t corner) {
  Look look;
  const auto name = [&](const Attribute* label) {
    return label ? in_utf8(name_of(*label, face)) : std::string();
  };
  const bool classes = !mesh_.faces.classes.empty() && !names_.names_classes;
  look.group = classes ? class_name(mesh_.faces.classes[face]) : name(names_.group);
  if (names_.object && names_.object->names.size() > 1) look.object = name(names_.object);
  if (names_.smoothing)
    look.smoothing = std::to_string(static_cast<std::int64_t>(names_.smoothing->values[face]));
  const std::string material = names_.material         ? name_of(*names_.material, face)
                               : material_.size() == 1 ? material_.begin()->first
                                                       : std::string();
  if (const auto found = material_.find(material); found != material_.end())
    look.material = found->second;
  const std::size_t corners = shape_template(mesh_.faces.shapes[face]).vertex_count;
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    std::size_t known = 0;
    for (std::size_t c = corner; c < corner + corners; ++c)
      known += rows_.known(a, rows_.of_corner(c));
    look.present.push_back(known > 0);
    if (known > 0) zeros_ += corners - known;
  }
  return look;
}

void GltfWriter::put_primitive(int mode, const std::vector<std::uint32_t>& list, const Look& look) {
  tinygltf::Primitive primitive;
  primitive.mode = mode;
  primitive.material = look.material;
  primitive.indices = accessor_of(rows_.size() < 65535 ? NumberType::UInt16 : NumberType::UInt32, 1,
                                  list.size(), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                                  [&](std::size_t i, int) { return static_cast<double>(list[i]); });
  primitive.attributes = attributes_;
  for (std::size_t a = 0; a < arrays_.size(); ++a)
    if (!look.present[a]) primitive.attributes.erase(in_utf8(arrays_[a].semantic));
  tinygltf::Value::Object extras;
  for (const auto& [key, text] :
       {std::pair("group", &look.group), std::pair("object", &look.object),
        std::pair("smoothing", &look.smoothing)})
    if (!text->empty()) extras[key] = tinygltf::Value(*text);
  if (!extras.empty()) primitive.extras = tinygltf::Value(extras);
  shape_.primitives.push_back(std::move(primitive));
}

/// What is no face has no look, and the arrays that have numbers for all of it.
void GltfWriter::put_bare(int mode, const std::vector<std::uint32_t>& list) {
  if (list.empty()) return;
  Look look;
  for (std::size_t a = 0; a < arrays_.size(); ++a)
    look.present.push_back(std::all_of(list.begin(), list.end(),
                                       [&](std::uint32_t row) { return rows_.known(a, row); }));
  put_primitive(mode, list, look);
}

void GltfWriter::put_lines() {
  std::vector<std::uint32_t> list;
  for_each_entity(mesh_.edges, [&](auto ends, ModelRef) {
    for (const std::uint32_t v : ends) list.push_back(GltfRows::first_of(v));
  });
  put_bare(TINYGLTF_MODE_LINE, list);
}

/// Vertices that nothing uses.
void GltfWriter::put_points() {
  std::vector<bool> used(mesh_.positions.size(), false);
  for (const EntityList* list : {&mesh_.faces, &mesh_.edges})
    for (const std::uint32_t v : list->vertices) used[v] = true;
  std::vector<std::uint32_t> list;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (!used[v]) list.push_back(GltfRows::first_of(v));
  put_bare(TINYGLTF_MODE_POINTS, list);
}

/// The two chunks of a .glb.
std::string container(const std::string& path, std::string json, const std::string& bin) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size =
      12 + 8 + std::uint64_t{json.size()} + (bin.empty() ? 0 : 8 + bin.size());
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw WriteError(path, {}, "a .glb holds at most 4 GB: write .gltf");
  ByteWriter out;
  out.reserve(static_cast<std::size_t>(size));
  const auto word = [&](std::uint64_t x) {
    out.raw<std::endian::little>(static_cast<std::uint32_t>(x));
  };
  out << "glTF";
  word(2), word(size), word(json.size());
  out << "JSON" << json;
  if (!bin.empty()) {
    word(bin.size());
    out << std::string_view("BIN\0", 4) << bin;
  }
  return out.take();
}

}  // namespace

void write_gltf(const std::filesystem::path& path, const MeshData& mesh, bool binary, bool beside,
                EncodedMesh& encoded) {
  FilesBeside files(mesh.appearance, path, encoded);
  GltfWriter writer(mesh, beside && !binary ? &files : nullptr);
  writer.write();
  if (writer.zeros() > 0)
    encoded.notes.push_back(counted(writer.zeros(), "value") +
                            " at corners that are no numbers written as 0");
  if (binary) {
    encoded.bytes = container(path.string(), writer.json({}), writer.bin());
  } else if (beside) {
    encoded.bytes = writer.json(uri_of_file(files.own_name(".bin")));
    if (!writer.bin().empty()) files.add(".bin", writer.take_bin());
  } else {
    encoded.bytes = writer.json("data:application/octet-stream;base64," + to_base64(writer.bin()));
  }
}

}  // namespace aomd::io::detail
