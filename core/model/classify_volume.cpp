#include "core/model/classify_volume.h"

#include <algorithm>
#include <vector>

#include "core/base/assertion.h"

namespace aomd {
namespace {

class VolumeClassifier {
 public:
  VolumeClassifier(Mesh& mesh, const ClassifyOptions& options)
      : mesh_(mesh),
        options_(options),
        needs_{mesh.request(3, 2, "classification"), mesh.request(2, 3, "classification"),
               mesh.request(3, 1, "classification"), mesh.request(0, 1, "classification")},
        on_skin_{std::vector<std::uint8_t>(mesh.capacity(0), 0),
                 std::vector<std::uint8_t>(mesh.capacity(1), 0),
                 std::vector<std::uint8_t>(mesh.capacity(2), 0)} {}

  ClassifyResult run() {
    if (!options_.keep_present) forget();
    flood_regions();
    collect_skin();
    Mesh skin(skin_);
    const ClassifyResult result = classify(skin, options_);
    take_over(skin);
    classify_inside();
    return result;
  }

 private:
  // Not regions: their materials follow from nothing that could be derived anew.
  void forget() {
    for (int dim = 0; dim < 3; ++dim)
      for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
        if (mesh_.ids(dim).alive(id)) mesh_.set_classification(EntityRef(dim, id), {});
  }

  void flood_regions() {
    std::int32_t next = 1;
    for (const Region r : mesh_.regions())
      if (mesh_.classification(r).valid()) next = std::max(next, mesh_.classification(r).tag() + 1);
    std::vector<Region> stack;
    for (const Region seed : mesh_.regions()) {
      if (mesh_.classification(seed).valid()) continue;
      const ModelRef model(3, next++);
      mesh_.set_classification(seed, model);
      stack.push_back(seed);
      while (!stack.empty()) {
        const Region r = stack.back();
        stack.pop_back();
        for (const Face f : mesh_.row<2>(r))
          for (const Region other : mesh_.row<3>(f))
            if (!mesh_.classification(other).valid())
              mesh_.set_classification(other, model), stack.push_back(other);
      }
    }
  }

  [[nodiscard]] bool is_skin(Face f) const {
    const Row<3> regions = mesh_.row<3>(f);
    return regions.size() != 2 || mesh_.classification(f).dimension() == 2 ||
           mesh_.classification(regions[0]) != mesh_.classification(regions[1]);
  }

  // A class that was only inherited from a region says nothing about the skin.
  [[nodiscard]] ModelRef given(EntityRef e) const {
    const ModelRef m = mesh_.classification(e);
    return m.dimension() == 3 ? ModelRef() : m;
  }

  void collect_skin() {
    skin_.positions.resize(mesh_.capacity(0));
    skin_.vertex_classes.resize(mesh_.capacity(0));
    for (const Vertex v : mesh_.vertices()) {
      skin_.positions[v.index] = mesh_.position(v);
      skin_.vertex_classes[v.index] = given(v);
    }
    for (const Face f : mesh_.faces()) {
      if (!is_skin(f)) continue;
      VertexBuffer buffer;
      const auto v = mesh_.vertices_of(f, buffer);
      on_skin_[2][f.index] = 1;
      skin_.faces.shapes.push_back(mesh_.shape(f));
      skin_.faces.vertices.insert(skin_.faces.vertices.end(), v.begin(), v.end());
      skin_.faces.classes.push_back(given(f));
    }
    for (const Edge e : mesh_.edges())
      if (given(e).dimension() == 1)
        skin_.edges.add(Shape::Line,
                        {mesh_.edge_vertices(e)[0].index, mesh_.edge_vertices(e)[1].index},
                        given(e));
  }

  void take_over(const Mesh& skin) {
    std::uint32_t place = 0;  // the skin's faces are the marked ones in the same order
    for (const Face f : mesh_.faces())
      if (on_skin_[2][f.index]) mesh_.set_classification(f, skin.classification(Face(place++)));
    for (const Edge s : skin.edges()) {
      const auto [a, b] = skin.edge_vertices(s);
      const Edge e = mesh_.find_edge(a, b);
      AOMD_CHECK(e.valid());
      mesh_.set_classification(e, skin.classification(s));
      on_skin_[1][e.index] = 1;
      for (const Vertex v : {a, b}) {
        mesh_.set_classification(v, skin.classification(v));
        on_skin_[0][v.index] = 1;
      }
    }
  }

  // A model vertex inside a region is one that the file put there.
  void classify_inside() {
    const auto take = [&](EntityRef e, ModelRef model) {
      std::uint8_t& done = on_skin_[e.dimension][e.index];
      if (!done) mesh_.set_classification(e, model);
      done = 1;
    };
    for (const Region r : mesh_.regions()) {
      const ModelRef model = mesh_.classification(r);
      VertexBuffer buffer;
      for (const Face f : mesh_.row<2>(r)) take(f, model);
      for (const Edge e : mesh_.row<1>(r)) take(e, model);
      for (const std::uint32_t v : mesh_.vertices_of(r, buffer))
        if (mesh_.classification(Vertex(v)).dimension() != 0) take(Vertex(v), model);
    }
  }

  Mesh& mesh_;
  ClassifyOptions options_;
  std::array<Request, 4> needs_;
  std::array<std::vector<std::uint8_t>, 3> on_skin_;  ///< by dimension and id: classified already
  MeshData skin_;
};

}  // namespace

ClassifyResult classify_volume(Mesh& mesh, const ClassifyOptions& options) {
  return VolumeClassifier(mesh, options).run();
}

}  // namespace aomd
