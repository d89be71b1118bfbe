#pragma once
// Labels of faces that have names: groups, objects and materials of OBJ, solids of STL.

#include <string_view>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

inline constexpr const char *obj_group = "group", *obj_object = "object",
                            *obj_material = "material", *obj_smoothing = "smoothing",
                            *stl_solid = "solid";

/// The keyword of what a glTF file says of a material beyond Material (core/io/gltf_materials.h).
inline constexpr const char* gltf_material = "gltf material";
/// That of a picture that a library of materials names for something else than the colour.
inline constexpr const char* obj_map = "mtl map";

/// The label on faces of this name; null where there is none or not every value has a name.
[[nodiscard]] const Attribute* find_named(const MeshData& mesh, std::string_view name);

/// The name of a face.
[[nodiscard]] inline const std::string& name_of(const Attribute& label, std::size_t face) {
  return label.names[static_cast<std::size_t>(label.values[face])];
}

/// True where labels and classes tell the same faces apart, or there are no classes: the names then
/// stand for both.
[[nodiscard]] bool names_classes(const Attribute& label, const EntityList& faces);

}  // namespace aomd::io::detail
