#pragma once
// Makes coarse triangle meshes whose faces are classified by the faces of the smooth shape that
// they stand for.

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/mesh/mesh_data.h"

namespace aomd::test {

using Loop = std::vector<glm::dvec3>;
using Indices = std::vector<std::uint32_t>;
using Profile = std::vector<glm::dvec2>;  // distance from the axis, and height
using Vector = glm::dvec3;

/// Puts triangles together, each on a face of the smooth shape.
class Builder {
 public:
  std::uint32_t point(const Vector& p) {
    data.positions.push_back(p);
    return static_cast<std::uint32_t>(data.positions.size() - 1);
  }
  Indices points(const Loop& loop) {
    Indices made;
    for (const Vector& p : loop) made.push_back(point(p));
    return made;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, int face) {
    data.faces.add(Shape::Triangle, {a, b, c}, ModelRef(2, face));
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, int face) {
    triangle(a, b, c, face);
    triangle(a, c, d, face);
  }
  // Between two closed loops; side i lies on face(i).
  template <typename FaceOf>
  void band(const Indices& low, const Indices& high, const FaceOf& face) {
    const std::size_t n = low.size();
    for (std::size_t i = 0; i < n; ++i)
      quad(low[i], low[(i + 1) % n], high[(i + 1) % n], high[i], face(i));
  }
  // All of a loop to one point; the face looks against the loop's way with `down`.
  void fan(const Indices& loop, std::uint32_t tip, int face, bool down = false) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % n];
      down ? triangle(b, a, tip, face) : triangle(a, b, tip, face);
    }
  }
  // A convex loop in zigzag.
  void strip(const Indices& loop, int face, bool down = false) {
    std::size_t i = 0, j = loop.size() - 1;
    for (bool near = true; i + 1 < j; near = !near) {
      const std::uint32_t a = loop[i], b = near ? loop[i + 1] : loop[j - 1], c = loop[j];
      down ? triangle(b, a, c, face) : triangle(a, b, c, face);
      near ? ++i : --j;
    }
  }

  MeshData data;
};

Loop circle(int sides, double radius, double z, double shift = 0);
/// A profile turned about the z axis from its lower end to its upper end. Piece k of it lies on
/// face faces[k]; ends on the axis become points, others stay open unless `closed` joins them.
MeshData revolved(const Profile& profile, int sides, const std::vector<int>& faces,
                  bool closed = false);
/// Points of an arc about (x, y), both ends with it; angles in degrees from the x axis.
Profile arc(double x, double y, double radius, double from, double to, int pieces);
Profile joined(Profile a, const Profile& b);
MeshData sphere(int sides, int rings);
/// A cylinder whose wall is one face, or one a side.
MeshData cylinder(int sides, double height, int rows, bool prism, bool strips = false);
/// A polygon in the plane, star-shaped about `middle`, drawn out along z. side[i] is the face of
/// its side i.
MeshData extruded(const Profile& polygon, glm::dvec2 middle, double height,
                  const std::vector<int>& side, int rows = 1);
std::vector<int> each_its_own(std::size_t n);
/// A plate with a round hole: outer square, hole of so many sides (a multiple of four).
MeshData plate(int sides, double radius, double height);
/// Unit cells in a grid, their outer squares cut in two; the faces are told by where they look.
MeshData cells(const std::vector<std::array<int, 3>>& filled, Vector size, int cut = 1);
/// A box whose edges and corners are cut off: 6 faces, 12 chamfers, 8 triangles.
MeshData chamfered_box(Vector half, double cut);
/// Regular polyhedra, by their corners and faces of n corners each.
MeshData polyhedron(const Loop& corners, const std::vector<Indices>& faces, bool smooth = false);
MeshData icosahedron(bool smooth);
MeshData dodecahedron();
/// Each face in four, the new points put where `place` says.
MeshData subdivided(const MeshData& mesh, const std::function<Vector(Vector)>& place);
MeshData icosphere(int levels);
MeshData flat_subdivided(MeshData mesh, int levels);
MeshData moved(MeshData mesh, const std::function<Vector(Vector)>& to);
MeshData roughened(MeshData mesh, double most);
MeshData together(const std::vector<MeshData>& parts);
MeshData terrain(int n, double height);
Profile star(int tips, double outer, double inner);
Profile gear(int teeth, double outer, double inner);
/// A rectangle with rounded corners of so many pieces each; the sides and rounds are one face, or
/// with chamfers each its own.
MeshData rounded_plate(Vector half, double radius, int pieces, int rows = 1);
MeshData d_shape(int pieces);
MeshData slot(int pieces);

}  // namespace aomd::test
