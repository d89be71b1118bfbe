#include "core/io/losses.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/medit_solution.h"
#include "core/io/named_faces.h"
#include "core/io/notes.h"
#include "core/mesh/names.h"

namespace aomd::io::detail {
namespace {

/// Whether each format holds edges, and the classes of edges and vertices.
struct Holds {
  bool edges, classes;
};

Holds what_holds(Format format) {
  if (format == Format::Obj) return {true, false};
  if (format == Format::Gltf) return {true, false};
  const bool neither = format == Format::Off || format == Format::Stl;
  return {!neither, !neither};  // what SU2 loses is add_what_markers_lack()
}

bool classified(const std::vector<ModelRef>& classes) {
  return std::any_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); });
}

std::size_t unused_vertices(const MeshData& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const std::uint32_t v : mesh.faces.vertices) used[v] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// SU2 has elements, and markers: what lies on model entities of one dimension less. Elements have
/// no classes, and what bounds markers has none but theirs.
void add_what_markers_lack(const MeshData& mesh, ItemList& left_out) {
  const int dim = mesh.regions.empty() ? 2 : 3;
  const EntityList& sides = mesh.list(dim - 1);
  std::size_t unmarked = 0;
  for_each_entity(sides, [&](auto, ModelRef m) { unmarked += m.dimension() != dim - 1; });
  if (dim == 3 && !mesh.edges.empty()) left_out.add(counted(mesh.edges.size(), "edge"));
  if (unmarked > 0)
    left_out.add(counted(unmarked, entity_name(dim - 1)) + " on no model " + entity_name(dim - 1));
  if (std::any_of(mesh.vertex_classes.begin(), mesh.vertex_classes.end(),
                  [&](ModelRef m) { return m.valid() && m.dimension() < dim - 1; }))
    left_out.add("classification of vertices");
  if (classified(mesh.list(dim).classes))
    left_out.add(std::string("classification of ") + entity_plural(dim));
  if (std::any_of(mesh.model.groups.begin(), mesh.model.groups.end(), [&](const PhysicalGroup& g) {
        return g.dimension != dim - 1 && !g.name.empty();
      }))
    left_out.add("names of physical groups");
}

/// How many different points there are among a few.
template <class Point>
std::size_t different(const std::vector<Point>& points) {
  std::size_t n = 0;
  for (auto p = points.begin(); p != points.end(); ++p) n += std::find(points.begin(), p, *p) == p;
  return n;
}

glm::vec3 rounded(const glm::dvec3& p) { return {p}; }

/// How many faces have 3 different corners before rounding, and fewer after it.
std::size_t collapsing_faces(const MeshData& mesh) {
  std::size_t n = 0;
  std::vector<glm::dvec3> before;
  std::vector<glm::vec3> after;
  for_each_entity(mesh.faces, [&](auto corners, ModelRef) {
    before.clear(), after.clear();
    for (const std::uint32_t v : corners) after.push_back(rounded(mesh.positions[v]));
    if (different(after) > 2) return;
    for (const std::uint32_t v : corners) before.push_back(mesh.positions[v]);
    n += different(before) > 2;
  });
  return n;
}

double largest_move(const MeshData& mesh) {
  double largest = 0;
  for (const glm::dvec3& p : mesh.positions)
    largest = std::max(largest, glm::distance(p, glm::dvec3(rounded(p))));
  return largest;
}

bool holds_materials(Format format) { return format == Format::Obj || format == Format::Gltf; }

/// What a line about the whole is called where the format has no place for it, else an empty
/// string.
std::string lost_remark(Format format, bool binary, const Remark& remark) {
  if (remark.keyword == "mtllib" && holds_materials(format)) return {};
  if (remark.keyword == "mtllib") return "material library " + shown(remark.text);
  if (remark.keyword == stl_solid)
    return format == Format::Stl && !binary ? std::string() : "solid name " + shown(remark.text);
  if (remark.keyword == obj_map)
    return format == Format::Obj ? std::string() : "pictures of materials but that of their colour";
  const bool picture = remark.text.starts_with("TextureFile ") && holds_materials(format);
  return format == Format::Ply || picture ? std::string() : "comments";
}

/// What glTF alone says of materials, by the words that it has for it.
void add_rest_of_material(const std::string& json, ItemList& left_out) {
  constexpr std::pair<std::string_view, const char*> words[] = {
      {"\"normalTexture\"", "normal maps"},
      {"\"occlusionTexture\"", "occlusion maps"},
      {"\"metallicRoughnessTexture\"", "maps of metal and roughness"},
      {"\"emissive", "emission"},
      {"\"alphaMode\"", "blending of materials"},
      {"\"KHR_texture_transform\"", "transforms of texture coordinates"},
      {"\"texCoord\"", "which texture coordinates pictures go by"},
      {"\"KHR_materials_", "extensions of materials"}};
  bool named = false;
  for (const auto& [word, what] : words) {
    if (json.find(word) == std::string::npos) continue;
    left_out.add(what);
    named = true;
  }
  if (!named) left_out.add("what else glTF says of materials");
}

/// Formats without materials lose all of these, which is said of them.
void add_remark(Format format, bool binary, const Remark& remark, ItemList& left_out) {
  if (remark.keyword != gltf_material) {
    const std::string lost = lost_remark(format, binary, remark);
    if (!lost.empty()) left_out.add(lost);
  } else if (format == Format::Obj || format == Format::Ply) {
    add_rest_of_material(remark.text, left_out);
  }
}

/// The library then stands for its materials.
bool names_library(const MeshData& mesh) {
  return std::any_of(mesh.remarks.begin(), mesh.remarks.end(),
                     [](const Remark& r) { return r.keyword == "mtllib"; });
}

/// The file beside a Medit mesh numbers its arrays.
void add_names_of_solution(const MeshData& mesh, ItemList& left_out) {
  std::array<std::size_t, 4> numbers{};
  for (const Attribute* const a : solution_arrays(mesh))
    if (a->name != solution_name(numbers[static_cast<std::size_t>(a->dimension)]++))
      left_out.add("the name " + shown(a->name));
}

/// Arrays that the format has no place for, and names of labels. OBJ and STL write names for
/// labels.
void add_arrays(Format format, bool binary, bool beside, const MeshData& mesh, ItemList& left_out) {
  const std::vector<const Attribute*> held = held_arrays(format, binary, beside, mesh);
  const auto look = [&](const Attribute& a) {
    if (std::find(held.begin(), held.end(), &a) == held.end())
      left_out.add("attribute " + shown(a.name));
    else if (!a.names.empty() && format != Format::Stl && !holds_materials(format))
      left_out.add("names of " + shown(a.name));
  };
  for (const Attribute& a : mesh.attributes) look(a);
  if (beside) add_names_of_solution(mesh, left_out);
  for (const Attribute& a : mesh.corners) look(a);
  for (const Remark& remark : mesh.remarks) add_remark(format, binary, remark, left_out);
  const Appearance& looks = mesh.appearance;
  const bool one_picture = looks.materials.size() == 1 && looks.pictures.size() == 1;
  if (!looks.materials.empty() && !holds_materials(format) && !names_library(mesh) &&
      !(format == Format::Ply && one_picture))
    left_out.add(counted(looks.materials.size(), "material"));
}

}  // namespace

void note_losses(Format format, bool binary, bool beside, const MeshData& mesh,
                 std::vector<std::string>& notes) {
  const Holds holds = what_holds(format);
  const bool faces_lose = format == Format::Off || (format == Format::Stl && binary);
  ItemList left_out;
  if (format == Format::Su2) add_what_markers_lack(mesh, left_out);
  if (!holds.edges && !mesh.edges.empty()) left_out.add(counted(mesh.edges.size(), "edge"));
  if (format == Format::Stl) {
    const std::size_t unused = unused_vertices(mesh);
    if (unused > 0) left_out.add(counted(unused, "vertex") + " that no face uses");
  }
  if (!holds.classes && classified(mesh.vertex_classes)) left_out.add("classification of vertices");
  if (!holds.classes && classified(mesh.edges.classes)) left_out.add("classification of edges");
  if (faces_lose && classified(mesh.faces.classes)) left_out.add("classification of faces");
  add_arrays(format, binary, beside, mesh, left_out);
  if (!mesh.periodic.empty() && format != Format::Msh) left_out.add("periodic links");
  if (!mesh.model.groups.empty() && format != Format::Msh && format != Format::Su2)
    left_out.add("names of physical groups");
  note_left_out(notes, left_out);
}

std::string_view exact_form(Format format) { return format == Format::Gltf ? ".ply" : "text"; }

void note_rounding(const MeshData& mesh, std::string_view exact, std::vector<std::string>& notes) {
  Box box;
  for (const glm::dvec3& p : mesh.positions) box.add(p);
  const double move = largest_move(mesh);
  const std::size_t lost = collapsing_faces(mesh);
  if (lost == 0 && move <= 1e-6 * box.diagonal()) return;
  std::string note = "coordinates rounded to 32-bit floats by up to " + number_text(move, 3);
  if (lost > 0) note += "; " + counted(lost, "face") + " collapse" + (lost == 1 ? "s" : "");
  notes.push_back(note + "; " + std::string(exact) + " keeps them");
}

std::string rounding_defect(const MeshData& mesh, std::string_view exact) {
  const std::size_t lost = collapsing_faces(mesh);
  if (100 * lost <= mesh.faces.size()) return {};
  return counted(lost, "face") + " of " + std::to_string(mesh.faces.size()) +
         " would collapse, since coordinates are rounded to 32-bit floats by up to " +
         number_text(largest_move(mesh), 3) + ": write " + std::string(exact) +
         ", or move the mesh to the origin";
}

}  // namespace aomd::io::detail
