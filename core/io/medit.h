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

/// The numbers of keywords in binary files, after libMeshb.
struct MeditCode {
  int code;
  std::string_view keyword;
};
inline constexpr MeditCode medit_codes[] = {{3, "Dimension"},
                                            {4, "Vertices"},
                                            {5, "Edges"},
                                            {6, "Triangles"},
                                            {7, "Quadrilaterals"},
                                            {8, "Tetrahedra"},
                                            {9, "Prisms"},
                                            {10, "Hexahedra"},
                                            {13, "Corners"},
                                            {14, "Ridges"},
                                            {15, "RequiredVertices"},
                                            {16, "RequiredEdges"},
                                            {17, "RequiredTriangles"},
                                            {18, "RequiredQuadrilaterals"},
                                            {20, "NormalAtVertices"},
                                            {24, "TrianglesP2"},
                                            {25, "EdgesP2"},
                                            {26, "SolAtPyramids"},
                                            {27, "QuadrilateralsQ2"},
                                            {30, "TetrahedraP2"},
                                            {33, "HexahedraQ2"},
                                            {49, "Pyramids"},
                                            {54, "End"},
                                            {59, "Tangents"},
                                            {60, "Normals"},
                                            {61, "TangentAtVertices"},
                                            {62, "SolAtVertices"},
                                            {63, "SolAtEdges"},
                                            {64, "SolAtTriangles"},
                                            {65, "SolAtQuadrilaterals"},
                                            {66, "SolAtTetrahedra"},
                                            {67, "SolAtPrisms"},
                                            {68, "SolAtHexahedra"},
                                            {86, "PrismsP2"},
                                            {87, "PyramidsP2"},
                                            {88, "QuadrilateralsQ3"},
                                            {89, "QuadrilateralsQ4"},
                                            {90, "TrianglesP3"},
                                            {91, "TrianglesP4"},
                                            {92, "EdgesP3"},
                                            {93, "EdgesP4"},
                                            {96, "TetrahedraP3"},
                                            {97, "TetrahedraP4"},
                                            {98, "HexahedraQ3"},
                                            {99, "HexahedraQ4"},
                                            {100, "PyramidsP3"},
                                            {101, "PyramidsP4"},
                                            {102, "PrismsP3"},
                                            {103, "PrismsP4"},
                                            {127, "EdgesP2Ordering"},
                                            {128, "EdgesP3Ordering"},
                                            {129, "TrianglesP2Ordering"},
                                            {130, "TrianglesP3Ordering"},
                                            {131, "QuadrilateralsQ2Ordering"},
                                            {132, "QuadrilateralsQ3Ordering"},
                                            {133, "TetrahedraP2Ordering"},
                                            {134, "TetrahedraP3Ordering"},
                                            {135, "PyramidsP2Ordering"},
                                            {136, "PyramidsP3Ordering"},
                                            {137, "PrismsP2Ordering"},
                                            {138, "PrismsP3Ordering"},
                                            {139, "HexahedraQ2Ordering"},
                                            {140, "HexahedraQ3Ordering"},
                                            {142, "EdgesP4Ordering"},
                                            {144, "TrianglesP4Ordering"},
                                            {146, "QuadrilateralsQ4Ordering"},
                                            {148, "TetrahedraP4Ordering"},
                                            {150, "PyramidsP4Ordering"},
                                            {152, "PrismsP4Ordering"},
                                            {154, "HexahedraQ4Ordering"}};

/// Attributes that hold what a mesh has no other place for.
inline constexpr std::string_view medit_reference = "medit:reference",  ///< of vertices
    medit_required = "medit:required",  ///< 0 or 1, of any dimension
    medit_ridge = "medit:ridge",        ///< 0 or 1, of edges
    medit_normal = "medit:normal",      ///< of vertices, 0 where there is none
    medit_tangent = "medit:tangent";

}  // namespace aomd::io::detail
