#include "core/io/material_files.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/named_faces.h"
#include "core/io/notes.h"
#include "core/io/picture_files.h"
#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ply_picture = "TextureFile ";
constexpr const char* left_out_maps = "left out: pictures of materials but that of their colour";

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

bool names_picture(const Remark& remark) {
  return remark.keyword == "comment" && remark.text.starts_with(ply_picture);
}

/// `mtllib` may name one file with blanks in its name, or several.
std::vector<std::string> files_of(const fs::path& folder, const std::string& text) {
  if (is_file(folder / text) || text.find(' ') == std::string::npos) return {text};
  std::vector<std::string> files;
  std::istringstream words(text);
  for (std::string word; words >> word;) files.push_back(word);
  return files;
}

/// The pictures of a material but that of its colour, as a library names them.
std::vector<std::string> other_maps(const tinyobj::material_t& m) {
  std::vector<std::string> maps;
  for (const std::string* name :
       {&m.ambient_texname, &m.specular_texname, &m.specular_highlight_texname, &m.bump_texname,
        &m.displacement_texname, &m.alpha_texname, &m.reflection_texname, &m.roughness_texname,
        &m.metallic_texname, &m.sheen_texname, &m.emissive_texname, &m.normal_texname})
    if (!name->empty()) maps.push_back(*name);
  return maps;
}

class Materials {
 public:
  Materials(fs::path folder, Appearance& looks) : folder_(std::move(folder)), looks_(looks) {}

  /// Returns whether the library is there.
  bool add_library(const std::string& file) {
    if (!is_file(folder_ / file)) return false;
    std::istringstream text(read_whole(folder_ / file));
    std::map<std::string, int> numbers;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&numbers, &materials, &text, &warning, &error);
    for (const tinyobj::material_t& m : materials)
      if (!m.name.empty()) add(m);
    return true;
  }

  std::uint32_t picture(std::string name) {
    use_slashes(name);
    const auto [at, is_new] =
        pictures_.try_emplace(name, static_cast<std::uint32_t>(looks_.pictures.size()));
    if (is_new) looks_.pictures.push_back({name, {}});
    return at->second;
  }

  /// Pictures for something else than the colour, each once.
  [[nodiscard]] const std::set<std::string>& others() const { return others_; }

 private:
  static void use_slashes(std::string& name) { std::replace(name.begin(), name.end(), '\\', '/'); }
  void add(const tinyobj::material_t& m) {
    Material material;
    material.name = m.name;
    material.colour = {m.diffuse[0], m.diffuse[1], m.diffuse[2], m.dissolve};
    if (m.metallic != 0 || m.roughness != 0)
      material.metallic = m.metallic, material.roughness = m.roughness;
    if (!m.diffuse_texname.empty()) {
      material.picture = picture(m.diffuse_texname);
      // A picture without a colour beside it is not black.
      if (m.diffuse[0] == 0 && m.diffuse[1] == 0 && m.diffuse[2] == 0)
        material.colour = {1, 1, 1, m.dissolve};
    }
    looks_.materials.push_back(std::move(material));
    for (std::string& name : other_maps(m)) {
      use_slashes(name);
      others_.insert(std::move(name));
    }
  }

  fs::path folder_;
  Appearance& looks_;
  std::map<std::string, std::uint32_t> pictures_;
  std::set<std::string> others_;
};

/// A library of these materials; pictures have the names that they have beside it.
std::string library_of(const Appearance& looks, const std::vector<std::string>& pictures) {
  ByteWriter out;
  out << "# AOMD Studio\n";
  for (const Material& m : looks.materials) {
    out << "newmtl " << (m.name.empty() ? "material" : m.name) << "\nKd " << m.colour[0] << ' '
        << m.colour[1] << ' ' << m.colour[2] << "\nd " << m.colour[3] << "\nPm " << m.metallic
        << "\nPr " << m.roughness << '\n';
    if (m.picture < pictures.size()) out << "map_Kd " << pictures[m.picture] << '\n';
  }
  return out.take();
}

}  // namespace

void add_materials(const fs::path& file, ReadResult& result) {
  Appearance& looks = result.mesh.appearance;
  Materials materials(file.parent_path(), looks);
  ItemList missing;
  for (const Remark& remark : result.mesh.remarks) {
    if (names_picture(remark))
      looks.materials.push_back(
          {.name = {}, .picture = materials.picture(remark.text.substr(ply_picture.size()))});
    if (remark.keyword != "mtllib") continue;
    for (const std::string& library : files_of(file.parent_path(), remark.text))
      if (!materials.add_library(library)) missing.add("material library " + shown(library));
  }
  if (!looks.empty()) looks.folder = file.parent_path().string();
  for (const Picture& picture : looks.pictures)
    if (picture.bytes.empty() && !is_file(file.parent_path() / picture.name))
      missing.add("picture " + shown(picture.name));
  for (const std::string& other : materials.others()) {
    result.mesh.remarks.push_back({obj_map, other});
    if (!is_file(file.parent_path() / other)) missing.add("picture " + shown(other));
  }
  if (!missing.empty()) result.notes.push_back("not there: " + missing.text());
}

std::vector<std::string> named_libraries(const MeshData& mesh) {
  std::vector<std::string> names;
  for (const Remark& remark : mesh.remarks)
    if (remark.keyword == "mtllib") names.push_back(remark.text);
  return names;
}

std::vector<Remark> ply_remarks_for(const fs::path& path, const MeshData& mesh,
                                    EncodedMesh& encoded) {
  const Appearance& looks = mesh.appearance;
  std::vector<Remark> remarks = mesh.remarks;
  if (looks.materials.size() != 1 || looks.pictures.size() != 1) return remarks;
  const std::string name = FilesBeside(looks, path, encoded).name_of(looks.pictures[0]);
  const auto known = std::find_if(remarks.begin(), remarks.end(), names_picture);
  if (known == remarks.end())
    remarks.push_back({"comment", std::string(ply_picture) + name});
  else
    known->text = std::string(ply_picture) + name;
  return remarks;
}

std::vector<std::string> libraries_for(const fs::path& path, const MeshData& mesh,
                                       EncodedMesh& encoded) {
  const Appearance& looks = mesh.appearance;
  std::vector<std::string> libraries = named_libraries(mesh);
  if (looks.materials.empty()) return libraries;
  FilesBeside files(looks, path, encoded);
  std::vector<std::string> pictures;
  bool as_named = !libraries.empty();
  for (const Picture& picture : looks.pictures) {
    pictures.push_back(files.name_of(picture));
    as_named = as_named && pictures.back() == picture.name;
  }
  const bool has_others = std::any_of(mesh.remarks.begin(), mesh.remarks.end(),
                                      [](const Remark& r) { return r.keyword == obj_map; });
  for (const Remark& remark : mesh.remarks)
    if (as_named && remark.keyword == obj_map) as_named = files.name_of(remark.text) == remark.text;
  if (!as_named && has_others) encoded.notes.emplace_back(left_out_maps);
  if (!as_named) return {files.add(".mtl", library_of(looks, pictures))};
  for (std::string& library : libraries) {
    std::string names;
    for (const std::string& file : files_of(looks.folder, library))
      names += (names.empty() ? "" : " ") + files.name_of(file);
    library = names;
  }
  return libraries;
}

}  // namespace aomd::io::detail
