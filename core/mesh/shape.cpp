#include "core/mesh/shape.h"

namespace aomd {
namespace {

constexpr SubEntity edge(std::uint8_t a, std::uint8_t b) { return {Shape::Line, {a, b, 0, 0}}; }
constexpr SubEntity tri(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
  return {Shape::Triangle, {a, b, c, 0}};
}
constexpr SubEntity quad(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
  return {Shape::Quad, {a, b, c, d}};
}

}  // namespace

// Vertex numbering of the regions, as in Gmsh and VTK:
//
//   tetrahedron        pyramid            prism              hexahedron
//        3                 4               3-----5            7------6
//       /|\              / | \             |\   /|           /|     /|
//      / | \            3--|--2            | \ / |          4------5 |
//     0--|--2          /   | /             |  4  |          | 3----|-2
//      \ | /          0-----1              0--|--2          |/     |/
//        1                                  \ | /           0------1
//                                             1
constexpr std::array<ShapeTemplate, shape_count> shape_templates = {{
    {"vertex", 0, 1, 0, 0, {}, {}},
    {"edge", 1, 2, 0, 0, {}, {}},
    {"triangle", 2, 3, 3, 0, {edge(0, 1), edge(1, 2), edge(2, 0)}, {}},
    {"quad", 2, 4, 4, 0, {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0)}, {}},
    {"tetrahedron",
     3,
     4,
     6,
     4,
     {edge(0, 1), edge(1, 2), edge(2, 0), edge(0, 3), edge(1, 3), edge(2, 3)},
     {tri(0, 2, 1), tri(0, 1, 3), tri(1, 2, 3), tri(2, 0, 3)}},
    {"pyramid",
     3,
     5,
     8,
     5,
     {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0), edge(0, 4), edge(1, 4), edge(2, 4), edge(3, 4)},
     {quad(0, 3, 2, 1), tri(0, 1, 4), tri(1, 2, 4), tri(2, 3, 4), tri(3, 0, 4)}},
    {"prism",
     3,
     6,
     9,
     5,
     {edge(0, 1), edge(1, 2), edge(2, 0), edge(3, 4), edge(4, 5), edge(5, 3), edge(0, 3), edge(1, 4),
      edge(2, 5)},
     {tri(0, 2, 1), tri(3, 4, 5), quad(0, 1, 4, 3), quad(1, 2, 5, 4), quad(2, 0, 3, 5)}},
    {"hexahedron",
     3,
     8,
     12,
     6,
     {edge(0, 1), edge(1, 2), edge(2, 3), edge(3, 0), edge(4, 5), edge(5, 6), edge(6, 7), edge(7, 4),
      edge(0, 4), edge(1, 5), edge(2, 6), edge(3, 7)},
     {quad(0, 3, 2, 1), quad(4, 5, 6, 7), quad(0, 1, 5, 4), quad(1, 2, 6, 5), quad(2, 3, 7, 6),
      quad(3, 0, 4, 7)}},
}};

}  // namespace aomd
