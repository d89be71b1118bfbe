#include "core/io/material_files.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/notes.h"
#include "core/io/picture_files.h"
#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ply_picture = "TextureFile ";

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
    std::replace(name.begin(), name.end(), '\\', '/');
    const auto [at, is_new] =
        pictures_.try_emplace(name, static_cast<std::uint32_t>(looks_.pictures.size()));
    if (is_new) looks_.pictures.push_back({name, {}});
    return at->second;
  }

 private:
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
  }

  fs::path folder_;
  Appearance& looks_;
  std::map<std::string, std::uint32_t> pictures_;
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
