#pragma once
// What the tests of the quality strategy share.

#include <bit>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/decimate/options.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/samples/samples.h"
#include "tests/support/as_listed.h"
#include "tests/support/zoo.h"

namespace aomd::test {

inline Mesh classified(const MeshData& data, Edges edges = Edges::All) {
  Mesh mesh(data);
  classify(mesh, as_listed(data));
  if (edges == Edges::OnModelEdges) mesh.keep_model_edges_only();
  return mesh;
}

inline DecimationOptions quality(std::uint32_t target, double regularity = 0.5) {
  return {.strategy = Strategy::Quality,
          .coarsest = true,
          .target_faces = target,
          .angle_deg = 60,
          .regularity = regularity};
}

/// Samples by their names and sizes.
inline std::vector<zoo::Animal> samples(
    std::initializer_list<std::pair<const char*, int>> names_and_sizes) {
  std::vector<zoo::Animal> all;
  for (const auto& [name, size] : names_and_sizes) all.push_back({name, make_sample(name, size)});
  return all;
}

/// The first thing that verify() finds; "" where there is none.
inline std::string finding(const Mesh& mesh) {
  const auto all = verify(mesh);
  return all.empty() ? "" : all[0].name + ": " + all[0].text;
}

/// Faces, vertices, their classes and positions, ids included; nothing of edges.
inline std::string without_edges(const Mesh& mesh) {
  std::string s;
  const auto add = [&](auto x) { s += std::to_string(x) + ' '; };
  for (const Face f : mesh.faces()) {
    add(f.index), add(mesh.classification(f).bits());
    for (const Vertex v : mesh.triangle(f)) add(v.index);
  }
  for (const Vertex v : mesh.vertices()) {
    add(v.index), add(mesh.classification(v).bits());
    for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(mesh.position(v)[k]));
  }
  return s;
}

}  // namespace aomd::test
