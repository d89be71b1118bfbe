#include "core/io/held_arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/gltf_arrays.h"
#include "core/io/medit_solution.h"
#include "core/io/stl_marks.h"

namespace aomd::io::detail {
namespace {

/// The first array of this meaning on entities of a dimension, of 2 to 4 components.
const Attribute* find_meant(const std::vector<Attribute>& arrays, Meaning meaning, int dimension,
                            int least, int most) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const Attribute& a) {
    return a.meaning == meaning && a.dimension == dimension && a.components >= least &&
           a.components <= most;
  });
  return found == arrays.end() ? nullptr : &*found;
}

/// Whether there is a value for each corner of the faces.
bool fits(const Attribute& corners, const MeshData& mesh) {
  return corners.values.size() ==
         static_cast<std::size_t>(corners.components) * mesh.faces.vertices.size();
}

/// The same on corners, as many as the faces have.
const Attribute* find_on_corners(const MeshData& mesh, Meaning meaning, int least, int most) {
  const Attribute* const a = find_meant(mesh.corners, meaning, 2, least, most);
  return a && fits(*a, mesh) ? a : nullptr;
}

const Attribute* find_smoothing(const MeshData& mesh) {
  const auto found =
      std::find_if(mesh.attributes.begin(), mesh.attributes.end(), [](const Attribute& a) {
        return a.name == obj_smoothing && a.dimension == 2 && a.components == 1 && a.integer;
      });
  return found == mesh.attributes.end() ? nullptr : &*found;
}

}  // namespace

double full_colour(const Attribute& array) {
  if (!array.integer) return 1;
  double full = 0;
  use_as(array.type.value_or(NumberType::UInt8), std::numeric_limits<double>::infinity(),
         [&](auto most) { full = static_cast<double>(most); });
  return full;
}

ObjArrays obj_arrays(const MeshData& mesh) {
  ObjArrays found;
  found.colours = find_meant(mesh.attributes, Meaning::Colour, 0, 3, 4);
  found.texture = find_on_corners(mesh, Meaning::Texture, 2, 3);
  found.normals = find_on_corners(mesh, Meaning::Normal, 3, 3);
  found.texture_on_corners = found.texture != nullptr;
  found.normals_on_corners = found.normals != nullptr;
  if (!found.texture) found.texture = find_meant(mesh.attributes, Meaning::Texture, 0, 2, 3);
  if (!found.normals) found.normals = find_meant(mesh.attributes, Meaning::Normal, 0, 3, 3);
  found.group = find_named(mesh, obj_group);
  found.object = find_named(mesh, obj_object);
  found.material = find_named(mesh, obj_material);
  found.smoothing = find_smoothing(mesh);
  for (const Attribute* label : {found.group, found.object, found.material})
    found.names_classes = found.names_classes || (label && names_classes(*label, mesh.faces));
  if (!found.names_classes && !mesh.faces.classes.empty()) found.group = nullptr;
  return found;
}

OffColumns off_arrays(const MeshData& mesh) {
  const auto find = [&](Meaning meaning, int dimension, int least, int most) {
    const Attribute* const a = find_meant(mesh.attributes, meaning, dimension, least, most);
    const bool all = a && std::all_of(a->values.begin(), a->values.end(),
                                      [](double x) { return std::isfinite(x); });
    return all ? a : nullptr;
  };
  return {find(Meaning::Colour, 0, 3, 4), find(Meaning::Texture, 0, 2, 2),
          find(Meaning::Normal, 0, 3, 3), find(Meaning::Colour, 2, 3, 4)};
}

const Attribute* ply_texture(const MeshData& mesh) {
  return find_on_corners(mesh, Meaning::Texture, 2, 2);
}

std::vector<const Attribute*> msh_corners(const MeshData& mesh) {
  std::vector<const Attribute*> found;
  for (const Attribute& a : mesh.corners)
    if (fits(a, mesh)) found.push_back(&a);
  return found;
}

StlArrays stl_arrays(const MeshData& mesh) {
  StlArrays found;
  for (const Attribute& a : mesh.attributes)
    if (a.name == stl_mark && a.dimension == 2 && a.components == 1 && a.type == NumberType::UInt16)
      found.marks = &a;
  if (!found.marks) found.colours = find_meant(mesh.attributes, Meaning::Colour, 2, 3, 4);
  found.solids = find_named(mesh, stl_solid);
  if (found.solids && !names_classes(*found.solids, mesh.faces)) found.solids = nullptr;
  return found;
}

std::vector<const Attribute*> held_arrays(Format format, bool binary, bool beside,
                                          const MeshData& mesh) {
  std::vector<const Attribute*> held;
  const auto all = [&] {
    for (const Attribute& a : mesh.attributes) held.push_back(&a);
  };
  if (format == Format::Obj) {
    const ObjArrays o = obj_arrays(mesh);
    held = {o.colours, o.texture, o.normals, o.group, o.object, o.material, o.smoothing};
  }
  if (format == Format::Gltf) {
    const ObjArrays o = obj_arrays(mesh);
    held = {o.group, o.object, o.material, o.smoothing};
    for (const GltfArray& a : gltf_arrays(mesh)) held.push_back(a.array);
  }
  if (format == Format::Off) {
    const OffColumns o = off_arrays(mesh);
    held = {o.colours, o.texture, o.normals, o.face_colours};
  }
  if (format == Format::Stl) {
    const StlArrays s = stl_arrays(mesh);
    if (binary)
      held = {s.colours, s.marks};
    else
      held = {s.solids};
  }
  if (format == Format::Ply || format == Format::Msh || format == Format::Vtk ||
      format == Format::Vtu || format == Format::Pvtu)
    all();
  if (format == Format::Ply) held.push_back(ply_texture(mesh));
  if (format == Format::Msh)
    for (const Attribute* const a : msh_corners(mesh)) held.push_back(a);
  if (format == Format::Medit && beside) held = solution_arrays(mesh);
  if (format == Format::Medit)
    for (const Attribute& a : mesh.attributes)
      if (a.name.starts_with("medit:")) held.push_back(&a);
  return held;
}

}  // namespace aomd::io::detail
