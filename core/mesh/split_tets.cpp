#include "core/mesh/split_tets.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/text.h"
#include "core/mesh/orient_regions.h"
#include "core/mesh/side_index.h"

namespace aomd {
namespace {

using Vertices = std::span<const std::uint32_t>;
using Corners = std::array<std::uint32_t, 4>;

// The triangles of a polygon that is cut from its smallest vertex, the same way round.
template <typename Visit>
void each_triangle(Vertices v, Visit&& visit) {
  const std::size_t n = v.size();
  const auto low = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
  for (std::size_t k = 1; k + 1 < n; ++k) visit(v[low], v[(low + k) % n], v[(low + k + 1) % n]);
}

// Sides look outward: a tetrahedron on one has it turned, so that it looks at the top.
template <typename Visit>
void each_tetrahedron(const ShapeTemplate& shape, Vertices v, Visit&& visit) {
  const std::uint32_t top = *std::min_element(v.begin(), v.end());
  for (int i = 0; i < shape.face_count; ++i) {
    const SideVertices side(shape.sub(2, i), v.data());
    const Vertices corners = side.span();
    if (std::find(corners.begin(), corners.end(), top) != corners.end()) continue;
    each_triangle(corners, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      visit(Corners{a, c, b, top});
    });
  }
}

// Six times the volume of a tetrahedron.
double volume(const MeshData& mesh, const Corners& v) {
  const glm::dvec3 origin = mesh.positions[v[0]];
  return glm::dot(glm::cross(mesh.positions[v[1]] - origin, mesh.positions[v[2]] - origin),
                  mesh.positions[v[3]] - origin);
}

class Splitter {
 public:
  explicit Splitter(const MeshData& from) : from_(from) {
    result_.mesh.positions = from.positions;
    result_.mesh.vertex_classes = from.vertex_classes;
    result_.mesh.edges = from.edges;
    result_.mesh.model = from.model;
    result_.mesh.periodic = from.periodic;
  }

  SplitToTets run() {
    split(2, [this](Shape shape, Vertices v) { add_face(shape, v); });
    split(3, [this](Shape shape, Vertices v) { add_region(shape, v); });
    for (const Attribute& a : from_.attributes) take(a);
    return std::move(result_);
  }

 private:
  // Adds what each entity becomes, and its class as often.
  template <typename Add>
  void split(int dim, Add&& add) {
    const EntityList& list = from_.list(dim);
    EntityList& pieces = result_.mesh.list(dim);
    auto& begin = begin_[static_cast<std::size_t>(dim)];
    const std::uint32_t* v = list.vertices.data();
    for (std::size_t i = 0; i < list.size(); ++i) {
      begin.push_back(pieces.size());
      const auto n = static_cast<std::size_t>(shape_template(list.shapes[i]).vertex_count);
      add(list.shapes[i], Vertices(v, n));
      v += n;
      if (!list.classes.empty()) pieces.classes.resize(pieces.size(), list.classes[i]);
      count(list.shapes[i], pieces.size() - begin.back());
    }
    begin.push_back(pieces.size());
  }

  void count(Shape shape, std::size_t pieces) {
    if (shape == Shape::Triangle || shape == Shape::Tetrahedron) return;
    ++result_.cut[static_cast<std::size_t>(shape)];
    result_.pieces[static_cast<std::size_t>(shape)] += pieces;
  }

  void add_piece(int dim, Shape shape, Vertices v) {
    EntityList& list = result_.mesh.list(dim);
    list.shapes.push_back(shape);
    list.vertices.insert(list.vertices.end(), v.begin(), v.end());
  }

  void add_face(Shape shape, Vertices v) {
    if (shape == Shape::Triangle) return add_piece(2, shape, v);
    each_triangle(v, [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      add_piece(2, Shape::Triangle, std::array{a, b, c});
    });
  }

  void add_region(Shape shape, Vertices v) {
    if (shape == Shape::Tetrahedron) return add_piece(3, shape, v);
    each_tetrahedron(shape_template(shape), v, [&](const Corners& corners) {
      result_.inverted += !(volume(from_, corners) > 0);
      add_piece(3, Shape::Tetrahedron, corners);
    });
  }

  void take(const Attribute& a) {
    Attribute& pieces = result_.mesh.attributes.emplace_back(a);
    if (a.dimension < 2) return;
    pieces.values.clear();
    const auto& begin = begin_[static_cast<std::size_t>(a.dimension)];
    const auto n = static_cast<std::size_t>(a.components);
    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
      for (std::size_t copies = begin[i + 1] - begin[i]; copies > 0; --copies)
        for (std::size_t k = 0; k < n; ++k) pieces.values.push_back(a.values[n * i + k]);
  }

  const MeshData& from_;
  SplitToTets result_;
  std::array<std::vector<std::size_t>, 4> begin_;  ///< by level: the first piece of each entity
};

}  // namespace

SplitToTets split_to_tets(MeshData mesh) {
  if (mesh.regions.empty()) {
    SplitToTets same;
    same.mesh = std::move(mesh);
    return same;
  }
  orient_regions(mesh);
  return Splitter(mesh).run();
}

std::string SplitToTets::text() const {
  std::string words;
  for (std::size_t i = shape_count(); i-- > 0;) {
    if (cut[i] == 0) continue;
    const ShapeTemplate& shape = shape_template(static_cast<Shape>(i));
    words += (words.empty() ? "" : ", ") + counted(cut[i], shape.name) + " into " +
             counted(pieces[i], shape.dimension == 3 ? "tetrahedron" : "triangle");
  }
  return words;
}

}  // namespace aomd
