#include "tests/support/shape_builder.h"

#include <algorithm>
#include <map>
#include <random>

namespace aomd::test {
namespace {

std::array<std::uint32_t, 3> corners_of(const MeshData& mesh, std::uint32_t f) {
  const std::uint32_t* v = mesh.faces.vertices.data() + 3 * std::size_t{f};
  return {v[0], v[1], v[2]};
}

}  // namespace

Loop circle(int sides, double radius, double z, double shift) {
  Loop loop;
  for (int i = 0; i < sides; ++i) {
    const double u = 2 * M_PI * (i + shift) / sides;
    loop.push_back({radius * std::cos(u), radius * std::sin(u), z});
  }
  return loop;
}

MeshData revolved(const Profile& profile, int sides, const std::vector<int>& faces, bool closed) {
  Builder b;
  std::vector<Indices> loops;
  for (const glm::dvec2& p : profile)
    loops.push_back(p.x > 0 ? b.points(circle(sides, p.x, p.y)) : Indices{b.point({0, 0, p.y})});
  const std::size_t pieces = closed ? profile.size() : profile.size() - 1;
  for (std::size_t k = 0; k < pieces; ++k) {
    const Indices &low = loops[k], &high = loops[(k + 1) % loops.size()];
    const int face = faces[std::min(k, faces.size() - 1)];
    if (low.size() == 1)
      b.fan(high, low[0], face, true);
    else if (high.size() == 1)
      b.fan(low, high[0], face);
    else
      b.band(low, high, [&](std::size_t) { return face; });
  }
  return b.data;
}

Profile arc(double x, double y, double radius, double from, double to, int pieces) {
  Profile points;
  for (int i = 0; i <= pieces; ++i) {
    const double u = (from + (to - from) * i / pieces) * M_PI / 180;
    points.push_back({x + radius * std::cos(u), y + radius * std::sin(u)});
  }
  for (glm::dvec2& p : points)
    if (std::abs(p.x) < 1e-9) p.x = 0;
  return points;
}

Profile joined(Profile a, const Profile& b) {
  const std::size_t skip = !a.empty() && glm::length(a.back() - b.front()) < 1e-9 ? 1 : 0;
  a.insert(a.end(), b.begin() + static_cast<std::ptrdiff_t>(skip), b.end());
  return a;
}

MeshData sphere(int sides, int rings) { return revolved(arc(0, 0, 1, -90, 90, rings), sides, {1}); }

MeshData cylinder(int sides, double height, int rows, bool prism, bool strips) {
  Builder b;
  std::vector<Indices> loops;
  for (int k = 0; k <= rows; ++k) loops.push_back(b.points(circle(sides, 1, height * k / rows)));
  for (int k = 0; k < rows; ++k)
    b.band(loops[static_cast<std::size_t>(k)], loops[static_cast<std::size_t>(k) + 1],
           [&](std::size_t i) { return prism ? 10 + static_cast<int>(i) : 1; });
  if (strips) {
    b.strip(loops.front(), 2, true);
    b.strip(loops.back(), 3);
    return b.data;
  }
  b.fan(loops.front(), b.point({0, 0, 0}), 2, true);
  b.fan(loops.back(), b.point({0, 0, height}), 3);
  return b.data;
}

MeshData extruded(const Profile& polygon, glm::dvec2 middle, double height,
                  const std::vector<int>& side, int rows) {
  Builder b;
  std::vector<Indices> loops;
  for (int k = 0; k <= rows; ++k) {
    Loop loop;
    for (const glm::dvec2& p : polygon) loop.push_back({p.x, p.y, height * k / rows});
    loops.push_back(b.points(loop));
  }
  for (std::size_t k = 0; k + 1 < loops.size(); ++k)
    b.band(loops[k], loops[k + 1], [&](std::size_t i) { return side[i]; });
  b.fan(loops.front(), b.point({middle.x, middle.y, 0}), 1, true);
  b.fan(loops.back(), b.point({middle.x, middle.y, height}), 2);
  return b.data;
}

std::vector<int> each_its_own(std::size_t n) {
  std::vector<int> faces;
  for (std::size_t i = 0; i < n; ++i) faces.push_back(10 + static_cast<int>(i));
  return faces;
}

MeshData plate(int sides, double radius, double height) {
  Builder b;
  const auto square = [&](double z) {
    Loop loop;
    for (const Vector& p : circle(sides, 1, 0, 0.5)) {
      const double far = std::max(std::abs(p.x), std::abs(p.y));
      loop.push_back({2 * p.x / far, 2 * p.y / far, z});
    }
    for (int k = 0; k < 4; ++k) {  // the point next to each corner becomes the corner
      const std::size_t at = static_cast<std::size_t>(sides / 8 + k * sides / 4);
      const double x = loop[at].x < 0 ? -2 : 2, y = loop[at].y < 0 ? -2 : 2;
      loop[at] = {x, y, z};
    }
    return b.points(loop);
  };
  const Indices outer_low = square(0), outer_high = square(height);
  const Indices low = b.points(circle(sides, radius, 0, 0.5)),
                high = b.points(circle(sides, radius, height, 0.5));
  b.band(outer_low, outer_high, [&](std::size_t i) {
    const int step = (static_cast<int>(i) + sides - sides / 8) % sides;
    return 10 + step / (sides / 4);
  });
  b.band(high, low, [](std::size_t) { return 1; });
  b.band(outer_high, high, [](std::size_t) { return 2; });
  b.band(low, outer_low, [](std::size_t) { return 3; });
  return b.data;
}

MeshData cells(const std::vector<std::array<int, 3>>& filled, Vector size, int cut) {
  Builder b;
  std::map<std::array<int, 3>, std::uint32_t> known;
  const auto at = [&](std::array<int, 3> p) {
    const auto [it, fresh] = known.try_emplace(p, 0);
    if (fresh) it->second = b.point(Vector(p[0], p[1], p[2]) / static_cast<double>(cut) * size);
    return it->second;
  };
  const auto is_filled = [&](std::array<int, 3> c) {
    for (const auto& f : filled)
      if (f == c) return true;
    return false;
  };
  for (const auto& cell : filled)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int way : {0, 1}) {
        auto next = cell;
        next[axis] += way ? 1 : -1;
        if (is_filled(next)) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < cut; ++i)
          for (int j = 0; j < cut; ++j) {
            std::array<std::array<int, 3>, 4> corner;
            for (int k = 0; k < 4; ++k) {
              auto p = cell;
              for (int& x : p) x *= cut;
              p[axis] += way * cut;
              p[u] += i + (k == 1 || k == 2);
              p[v] += j + (k >= 2);
              corner[static_cast<std::size_t>(k)] = p;
            }
            if (!way) std::swap(corner[1], corner[3]);
            b.quad(at(corner[0]), at(corner[1]), at(corner[2]), at(corner[3]),
                   1 + static_cast<int>(axis) * 2 + way);
          }
      }
  return b.data;
}

MeshData chamfered_box(Vector half, double cut) {
  Builder b;
  std::map<std::array<int, 4>, std::uint32_t> known;
  for (int s = 0; s < 8; ++s)
    for (int axis = 0; axis < 3; ++axis) {
      Vector p;
      for (int k = 0; k < 3; ++k) p[k] = (s >> k & 1 ? 1 : -1) * (half[k] - (k == axis ? 0 : cut));
      known[{s, axis}] = b.point(p);
    }
  const auto at = [&](int s, int axis) { return known.at({s, axis}); };
  int face = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const int way : {0, 1 << axis}) {
      std::array<int, 4> s = {way, way | u, way | u | v, way | v};
      if (!way) std::swap(s[1], s[3]);
      b.quad(at(s[0], axis), at(s[1], axis), at(s[2], axis), at(s[3], axis), face++);
    }
    // chamfers along `axis`
    for (const int k : {0, u, v, u | v}) {
      const int a1 = (axis + 1) % 3, a2 = (axis + 2) % 3, low = k, high = k | 1 << axis;
      const bool flip = (k == 0 || k == (u | v));
      flip ? b.quad(at(low, a1), at(high, a1), at(high, a2), at(low, a2), face++)
           : b.quad(at(low, a2), at(high, a2), at(high, a1), at(low, a1), face++);
    }
  }
  for (int s = 0; s < 8; ++s) {
    const bool even = ((s & 1) + (s >> 1 & 1) + (s >> 2 & 1)) % 2 == 1;
    even ? b.triangle(at(s, 0), at(s, 1), at(s, 2), face++)
         : b.triangle(at(s, 0), at(s, 2), at(s, 1), face++);
  }
  return b.data;
}

MeshData polyhedron(const Loop& corners, const std::vector<Indices>& faces, bool smooth) {
  Builder b;
  b.points(corners);
  int face = 1;
  for (const Indices& f : faces) {
    for (std::size_t i = 2; i < f.size(); ++i) b.triangle(f[0], f[i - 1], f[i], face);
    face += smooth ? 0 : 1;
  }
  return b.data;
}

MeshData icosahedron(bool smooth) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  return polyhedron(
      {{-1, g, 0},
       {1, g, 0},
       {-1, -g, 0},
       {1, -g, 0},
       {0, -1, g},
       {0, 1, g},
       {0, -1, -g},
       {0, 1, -g},
       {g, 0, -1},
       {g, 0, 1},
       {-g, 0, -1},
       {-g, 0, 1}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
      smooth);
}

MeshData dodecahedron() {
  const MeshData ico = icosahedron(false);
  Loop corners;
  for (std::uint32_t f = 0; f < 20; ++f) {
    Vector sum(0.0);
    for (std::uint32_t k = 0; k < 3; ++k) sum += ico.positions[corners_of(ico, f)[k]];
    corners.push_back(sum / 3.0);
  }
  std::vector<Indices> faces;
  for (std::uint32_t v = 0; v < 12; ++v) {
    const Vector axis = glm::normalize(ico.positions[v]);
    const Vector x = glm::normalize(glm::cross(axis, Vector(0.3, 0.5, 0.8))),
                 y = glm::cross(axis, x);
    std::map<double, std::uint32_t> around;
    for (std::uint32_t f = 0; f < 20; ++f)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (corners_of(ico, f)[k] == v)
          around[std::atan2(glm::dot(corners[f], y), glm::dot(corners[f], x))] = f;
    Indices face;
    for (const auto& [angle, f] : around) face.push_back(f);
    faces.push_back(face);
  }
  return polyhedron(corners, faces);
}

MeshData subdivided(const MeshData& mesh, const std::function<Vector(Vector)>& place) {
  Builder b;
  b.data.positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t p, std::uint32_t q) {
    const auto [it, fresh] = middles.try_emplace(std::minmax(p, q), 0);
    if (fresh) it->second = b.point(place(0.5 * (mesh.positions[p] + mesh.positions[q])));
    return it->second;
  };
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto t = corners_of(mesh, f);
    const int face = mesh.faces.classes[f].tag();
    const std::uint32_t x = middle(t[0], t[1]), y = middle(t[1], t[2]), z = middle(t[2], t[0]);
    b.triangle(t[0], x, z, face);
    b.triangle(x, t[1], y, face);
    b.triangle(z, y, t[2], face);
    b.triangle(x, y, z, face);
  }
  return b.data;
}

MeshData icosphere(int levels) {
  MeshData mesh = icosahedron(true);
  for (Vector& p : mesh.positions) p = glm::normalize(p);
  for (int i = 0; i < levels; ++i)
    mesh = subdivided(mesh, [](Vector p) { return glm::normalize(p); });
  return mesh;
}

MeshData flat_subdivided(MeshData mesh, int levels) {
  for (int i = 0; i < levels; ++i) mesh = subdivided(mesh, [](Vector p) { return p; });
  return mesh;
}

MeshData moved(MeshData mesh, const std::function<Vector(Vector)>& to) {
  for (Vector& p : mesh.positions) p = to(p);
  return mesh;
}

MeshData roughened(MeshData mesh, double most) {
  std::mt19937 random(7);
  const auto draw = [&] { return most * (2.0 * random() / 4294967295.0 - 1); };
  for (Vector& p : mesh.positions) {
    const double x = draw(), y = draw(), z = draw();
    p += Vector(x, y, z);
  }
  return mesh;
}

MeshData together(const std::vector<MeshData>& parts) {
  Builder b;
  int faces = 0;
  for (const MeshData& part : parts) {
    const auto first = static_cast<std::uint32_t>(b.data.positions.size());
    b.points(part.positions);
    int most = 0;
    for (std::uint32_t f = 0; f < part.faces.size(); ++f) {
      const auto t = corners_of(part, f);
      const int face = part.faces.classes[f].tag();
      b.triangle(first + t[0], first + t[1], first + t[2], faces + face);
      most = std::max(most, face);
    }
    faces += most;
  }
  return b.data;
}

MeshData terrain(int n, double height) {
  Builder b;
  const auto un = static_cast<std::uint32_t>(n);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      b.point({i, j,
               height * std::sin(0.9 * i + 0.3) * std::cos(0.8 * j) +
                   0.4 * height * std::sin(0.5 * i - 0.7 * j)});
  for (std::uint32_t j = 0; j < un; ++j)
    for (std::uint32_t i = 0; i < un; ++i) {
      const std::uint32_t v = j * (un + 1) + i;
      b.quad(v, v + 1, v + un + 2, v + un + 1, 1);
    }
  return b.data;
}

Profile star(int tips, double outer, double inner) {
  Profile polygon;
  for (int i = 0; i < 2 * tips; ++i) {
    const double u = M_PI * i / tips, r = i % 2 ? inner : outer;
    polygon.push_back({r * std::cos(u), r * std::sin(u)});
  }
  return polygon;
}

Profile gear(int teeth, double outer, double inner) {
  Profile polygon;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double u = M_PI * (i + 0.5) / (2 * teeth), r = i % 4 < 2 ? outer : inner;
    polygon.push_back({r * std::cos(u), r * std::sin(u)});
  }
  return polygon;
}

MeshData rounded_plate(Vector half, double radius, int pieces, int rows) {
  Profile polygon = arc(half.x - radius, half.y - radius, radius, 0, 90, pieces);
  polygon = joined(polygon, arc(-half.x + radius, half.y - radius, radius, 90, 180, pieces));
  polygon = joined(polygon, arc(-half.x + radius, -half.y + radius, radius, 180, 270, pieces));
  polygon = joined(polygon, arc(half.x - radius, -half.y + radius, radius, 270, 360, pieces));
  return extruded(polygon, {0, 0}, half.z, std::vector<int>(polygon.size(), 10), rows);
}

MeshData d_shape(int pieces) {
  Profile polygon = arc(0, 0, 1, -90, 90, pieces);
  for (glm::dvec2& p : polygon) p.x += 0.5;
  std::vector<int> side(polygon.size(), 10);
  side.back() = 11;
  return extruded(polygon, {0.7, 0}, 0.8, side);
}

MeshData slot(int pieces) {
  Profile polygon = joined(arc(2, 0, 1, -90, 90, pieces), arc(-2, 0, 1, 90, 270, pieces));
  return extruded(polygon, {0, 0}, 0.7, std::vector<int>(polygon.size(), 10));
}

}  // namespace aomd::test
