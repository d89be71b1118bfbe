#include "core/samples/build.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aomd::sample {
namespace {

using Index = std::uint32_t;

/// A mesh edge on a model edge.
struct Curve {
  Index a, b;
};

std::size_t side_count(const MeshData& mesh, std::size_t face) {
  return static_cast<std::size_t>(shape_template(mesh.faces.shapes[face]).vertex_count);
}

std::vector<Curve> find_curves(const MeshData& mesh) {
  struct Side {
    Index a, b;
    std::int32_t tag;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0, place = 0; f < mesh.faces.size(); ++f) {
    const std::size_t n = side_count(mesh, f);
    for (std::size_t i = 0; i < n; ++i) {
      const Index a = mesh.faces.vertices[place + i], b = mesh.faces.vertices[place + (i + 1) % n];
      sides.push_back({std::min(a, b), std::max(a, b), mesh.faces.classes[f].tag()});
    }
    place += n;
  }
  std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
    return std::tie(l.a, l.b, l.tag) < std::tie(r.a, r.b, r.tag);
  });
  std::vector<Curve> curves;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    bool one_face = true;
    for (next = i;
         next < sides.size() && sides[next].a == sides[i].a && sides[next].b == sides[i].b;
         ++next) {
      one_face = one_face && sides[next].tag == sides[i].tag;
    }
    if (next - i == 2 && one_face) continue;
    curves.push_back({sides[i].a, sides[i].b});
  }
  return curves;
}

/// The curves that meet at each vertex: rows [first[v], first[v + 1]) of `curve`.
struct Incidence {
  std::vector<std::size_t> first, curve;
};

Incidence meet(std::size_t vertices, const std::vector<Curve>& curves) {
  Incidence at{std::vector<std::size_t>(vertices + 1), std::vector<std::size_t>(2 * curves.size())};
  for (const Curve& c : curves) {
    for (const Index v : {c.a, c.b}) ++at.first[v + 1];
  }
  std::partial_sum(at.first.begin(), at.first.end(), at.first.begin());
  std::vector<std::size_t> fill(at.first.begin(), at.first.end() - 1);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const Index v : {curves[i].a, curves[i].b}) at.curve[fill[v]++] = i;
  }
  return at;
}

/// Numbers the chains of curves between model vertices, from 1.
std::vector<std::int32_t> number_chains(const std::vector<Curve>& curves, const Incidence& at,
                                        const std::vector<ModelRef>& vertex_classes) {
  std::vector<std::int32_t> tags(curves.size(), 0);
  std::int32_t last = 0;
  std::vector<std::size_t> open;
  for (std::size_t seed = 0; seed < curves.size(); ++seed) {
    if (tags[seed] != 0) continue;
    tags[seed] = ++last;
    open.assign(1, seed);
    while (!open.empty()) {
      const Curve curve = curves[open.back()];
      open.pop_back();
      for (const Index v : {curve.a, curve.b}) {
        if (vertex_classes[v].dimension() == 0) continue;
        for (std::size_t row = at.first[v]; row < at.first[v + 1]; ++row) {
          if (tags[at.curve[row]] != 0) continue;
          tags[at.curve[row]] = last;
          open.push_back(at.curve[row]);
        }
      }
    }
  }
  return tags;
}

std::uint64_t morton(const glm::dvec3& unit) {
  constexpr int bits = 16;
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto q = static_cast<std::uint64_t>(std::clamp(unit[axis], 0.0, 1.0) * ((1 << bits) - 1));
    for (int bit = 0; bit < bits; ++bit) key |= (q >> bit & 1u) << (3 * bit + axis);
  }
  return key;
}

}  // namespace

Index add_vertex(MeshData& mesh, const glm::dvec3& position) {
  mesh.positions.push_back(position);
  return static_cast<Index>(mesh.positions.size() - 1);
}

void add_quad(MeshData& mesh, const Index (&q)[4], std::int32_t tag, bool other_diagonal) {
  const ModelRef model = tag == 0 ? ModelRef() : ModelRef(2, tag);
  const std::size_t s = other_diagonal ? 1 : 0;
  mesh.faces.add(Shape::Triangle, {q[s], q[s + 1], q[(s + 2) % 4]}, model);
  mesh.faces.add(Shape::Triangle, {q[s], q[(s + 2) % 4], q[(s + 3) % 4]}, model);
}

void add_quad(MeshData& mesh, const Index (&q)[4], std::int32_t tag) {
  const auto& p = mesh.positions;
  const glm::dvec3 d02 = p[q[2]] - p[q[0]], d13 = p[q[3]] - p[q[1]];
  // A clear difference, so that rounding never decides.
  add_quad(mesh, q, tag, glm::dot(d13, d13) < 0.999999 * glm::dot(d02, d02));
}

void classify_below_faces(MeshData& mesh, std::span<const Index> corners) {
  const std::vector<Curve> curves = find_curves(mesh);
  const Incidence at = meet(mesh.positions.size(), curves);
  mesh.vertex_classes.assign(mesh.positions.size(), ModelRef());
  for (std::size_t f = 0, place = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = side_count(mesh, f); k > 0; --k, ++place)
      mesh.vertex_classes[mesh.faces.vertices[place]] = mesh.faces.classes[f];
  }
  std::int32_t last_vertex = 0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const std::size_t degree = at.first[v + 1] - at.first[v];
    const bool passes = degree == 0 || degree == 2;
    const bool named = std::find(corners.begin(), corners.end(), v) != corners.end();
    if (!passes || named) mesh.vertex_classes[v] = ModelRef(0, ++last_vertex);
  }
  const std::vector<std::int32_t> tags = number_chains(curves, at, mesh.vertex_classes);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const ModelRef model(1, tags[i]);
    mesh.edges.add(Shape::Line, {curves[i].a, curves[i].b}, model);
    for (const Index v : {curves[i].a, curves[i].b}) {
      if (mesh.vertex_classes[v].dimension() != 0) mesh.vertex_classes[v] = model;
    }
  }
}

void order_in_space(MeshData& mesh) {
  glm::dvec3 low = mesh.positions[0], high = low;
  for (const glm::dvec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  std::vector<std::pair<std::uint64_t, Index>> order;
  for (Index v = 0; v < mesh.positions.size(); ++v)
    order.emplace_back(morton((mesh.positions[v] - low) / (high - low)), v);
  std::sort(order.begin(), order.end());

  std::vector<glm::dvec3> positions;
  std::vector<Index> renamed(order.size());
  for (const auto& [key, v] : order) {
    renamed[v] = static_cast<Index>(positions.size());
    positions.push_back(mesh.positions[v]);
  }
  mesh.positions = std::move(positions);

  std::vector<std::array<Index, 3>> faces(mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.vertices.size(); ++i)
    faces[i / 3][i % 3] = renamed[mesh.faces.vertices[i]];
  for (auto& f : faces) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i < mesh.faces.vertices.size(); ++i)
    mesh.faces.vertices[i] = faces[i / 3][i % 3];
}

}  // namespace aomd::sample
