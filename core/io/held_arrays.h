#pragma once
// Which arrays of a mesh a format has a place for.

#include <vector>

#include "core/io/io.h"
#include "core/io/named_faces.h"

namespace aomd::io::detail {

/// What a colour of full strength is: 1, or the largest whole number of the array's type.
[[nodiscard]] double full_colour(const Attribute& array);

/// What OBJ has a place for; null where the mesh has none.
struct ObjArrays {
  const Attribute *colours = nullptr, *texture = nullptr, *normals = nullptr;
  const Attribute *group = nullptr, *object = nullptr, *material = nullptr, *smoothing = nullptr;
  bool texture_on_corners = false, normals_on_corners = false;
  bool names_classes = false;  ///< the names tell what the classes tell
};
[[nodiscard]] ObjArrays obj_arrays(const MeshData& mesh);

/// What OFF has a place for: arrays of numbers throughout.
struct OffColumns {
  const Attribute *colours = nullptr, *texture = nullptr, *normals = nullptr,
                  *face_colours = nullptr;
};
[[nodiscard]] OffColumns off_arrays(const MeshData& mesh);

/// The array on corners that PLY has a place for: two texture coordinates each.
[[nodiscard]] const Attribute* ply_texture(const MeshData& mesh);

/// The arrays on corners that MSH has a place for: as many values as the faces have corners.
[[nodiscard]] std::vector<const Attribute*> msh_corners(const MeshData& mesh);

/// What STL has a place for: in binary colours or marks of facets, in text names of solids.
struct StlArrays {
  const Attribute *colours = nullptr, *marks = nullptr, *solids = nullptr;
};
[[nodiscard]] StlArrays stl_arrays(const MeshData& mesh);

/// The arrays, of corners too, that a file of the format holds; `beside`: a Medit mesh has its file
/// of arrays.
[[nodiscard]] std::vector<const Attribute*> held_arrays(Format format, bool binary, bool beside,
                                                        const MeshData& mesh);

}  // namespace aomd::io::detail
