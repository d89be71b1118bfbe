#pragma once
// What the reader and the writer of Medit meshes share.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// The keyword of each list of elements. Source: "MEDIT: An interactive mesh visualization
/// software" (Frey, INRIA RT-0253, 2001) and libMeshb's table of keywords; corners are in the order
/// of our templates.
struct MeditList {
  std::string_view keyword;
  Shape shape = Shape::Point;
};
inline constexpr std::array<MeditList, 7> medit_lists{{{"Edges", Shape::Line},
                                                       {"Triangles", Shape::Triangle},
                                                       {"Quadrilaterals", Shape::Quad},
                                                       {"Tetrahedra", Shape::Tetrahedron},
                                                       {"Pyramids", Shape::Pyramid},
                                                       {"Prisms", Shape::Prism},
                                                       {"Hexahedra", Shape::Hexahedron}}};

/// Attributes that hold what a mesh has no other place for.
inline constexpr std::string_view medit_reference = "medit:reference",  ///< of vertices
    medit_required = "medit:required",  ///< 0 or 1, of any dimension
    medit_ridge = "medit:ridge",        ///< 0 or 1, of edges
    medit_normal = "medit:normal",      ///< of vertices, 0 where there is none
    medit_tangent = "medit:tangent";

}  // namespace aomd::io::detail
