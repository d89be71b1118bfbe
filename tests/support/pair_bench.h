#pragma once
// A small classified mesh for operators that work by vertex pair, with all edges as entities or
// only some.

#include <initializer_list>
#include <utility>

#include "core/mesh/mesh.h"
#include "core/model/classify.h"
#include "tests/support/as_listed.h"
#include "tests/support/zoo.h"

namespace aomd::test {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

inline constexpr Edges both[] = {Edges::All, Edges::OnModelEdges};
inline const char* name(Edges edges) {
  return edges == Edges::All ? "all edges" : "model edges only";
}

/// A mesh that classify() has classified; a test may then change classes by on(), and calls
/// ready().
struct PairBench {
  explicit PairBench(const MeshData& data) : mesh(data) {
    classify(mesh, as_listed(data));
    mesh.set(0, 1);
  }
  PairBench& ready(Edges edges) {
    if (edges == Edges::OnModelEdges) mesh.keep_model_edges_only();
    mesh.set(0, 2);
    return *this;
  }
  Edge edge(std::uint32_t a, std::uint32_t b) const { return mesh.find_edge(Vertex(a), Vertex(b)); }
  void on(ModelRef model, std::initializer_list<std::uint32_t> vertices) {
    for (const std::uint32_t v : vertices) mesh.set_classification(Vertex(v), model);
  }
  void on(ModelRef model, std::initializer_list<Ends> edges) {
    for (const auto& [a, b] : edges) mesh.set_classification(edge(a, b), model);
  }
  Mesh mesh;
};

inline MeshData on_one_face(MeshData data) {
  data.faces.classes.assign(data.faces.size(), ModelRef(2, 1));
  return data;
}

}  // namespace aomd::test
