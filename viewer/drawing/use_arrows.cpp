#include "viewer/drawing/use_arrows.h"

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr Color forwards_color = rgb(0x0072b2), backwards_color = rgb(0xc63a1e);
constexpr float line_px = 2.6f;
constexpr double inwards = 0.22;            // from the edge's middle to the face's
constexpr double begin = 0.24, end = 0.76;  // along the edge
constexpr double head = 0.09;               // of its length

}  // namespace

void draw_use_arrows(const Mesh& mesh, Face face, const glm::dvec3& origin, Overlay& overlay) {
  glm::dvec3 center(0);
  VertexBuffer corners, ends;
  const auto vertices = mesh.vertices_of(face, corners);
  for (const std::uint32_t v : vertices) center += mesh.position(Vertex(v));
  center /= static_cast<double>(vertices.size());
  for (const Edge edge : mesh.row<1>(face)) {
    const auto v = mesh.vertices_of(edge, ends);
    const glm::dvec3 a = mesh.position(Vertex(v[0])), b = mesh.position(Vertex(v[1]));
    const glm::dvec3 aside = inwards * (center - 0.5 * (a + b));
    const auto at = [&](double t, double side) {
      return glm::vec3(a + t * (b - a) + (1 + side) * aside - origin);
    };
    const Color color = mesh.use_direction(face, edge) ? forwards_color : backwards_color;
    overlay.lines.push_back({at(begin, 0), at(end, 0), color, line_px});
    for (const double side : {-0.5, 0.5})
      overlay.lines.push_back({at(end - head, side), at(end, 0), color, line_px});
  }
}

}  // namespace aomd::scene
