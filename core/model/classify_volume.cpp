#include "core/model/classify_volume.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/assertion.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/side_groups.h"

namespace aomd {
namespace {

class VolumeClassifier {
 public:
  VolumeClassifier(Mesh& mesh, const ClassifyOptions& options)
      : mesh_(mesh), options_(options), on_skin_(mesh.capacity(0), 0) {
    constexpr const char* name = "classification";
    needs_.push_back(mesh.request(0, 3, name));
    for (const int dim : {2, 1})  // edges are made in the order of the faces
      needs_.push_back(options.complete ? mesh.request(0, dim, name)
                                        : mesh.request_listed(0, dim, name));
  }

  ClassifyResult run() {
    if (!options_.keep_present) forget();
    flood_regions();
    find_skin();
    Mesh skin(skin_data());
    const ClassifyResult result = classify(skin, options_);
    if (!options_.complete && has_bare_edges(skin)) return start_again();
    take_over_edges(skin);
    take_over_faces(skin);
    classify_inside();
    return result;
  }

 private:
  /// A face between model regions or on the outside: an entity, or side k of the first region.
  struct SkinFace {
    Face listed;
    Region region;
    int side = 0;
  };
  /// An edge to be made, and which user of its smaller vertex has it first: a listed face, or the
  /// side of a region.
  struct NewEdge {
    Vertex low, from, to;
    ModelRef model;
    std::array<std::uint32_t, 4> first_user{};
  };

  // Not regions: their materials follow from nothing that could be derived anew.
  void forget() {
    for (int dim = 0; dim < 3; ++dim)
      for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
        if (mesh_.ids(dim).alive(id)) mesh_.set_classification(EntityRef(dim, id), {});
  }

  // With all edges as entities, as the last resort.
  ClassifyResult start_again() {
    options_.complete = true;
    needs_.clear();
    return VolumeClassifier(mesh_, options_).run();
  }

  // Unclassified regions that are joined through faces become one model region.
  void flood_regions() {
    std::int32_t next = 1;
    bool all = true;
    for (const Region r : mesh_.regions()) {
      const ModelRef model = mesh_.classification(r);
      if (model.valid()) next = std::max(next, model.tag() + 1);
      all = all && model.valid();
    }
    if (all) return;
    DisjointSets parts = unclassified_parts();
    for (const Region r : mesh_.regions()) {
      if (mesh_.classification(r).valid()) continue;
      const Region first(parts.find(r.index));
      mesh_.set_classification(r, r == first ? ModelRef(3, next++) : mesh_.classification(first));
    }
  }

  DisjointSets unclassified_parts() {
    DisjointSets parts(mesh_.capacity(3));
    SideGroups<2>(mesh_).each([&](std::span<const SideUse> uses) {
      std::uint32_t before = no_index;
      for (const SideUse& use : uses) {
        if (use.dimension != 3 || mesh_.classification(Region(use.index)).valid()) continue;
        if (before != no_index) parts.unite(before, use.index);
        before = use.index;
      }
    });
    return parts;
  }

  // A class that was only inherited from a region says nothing about the skin.
  [[nodiscard]] ModelRef given(EntityRef e) const {
    const ModelRef m = mesh_.classification(e);
    return m.dimension() == 3 ? ModelRef() : m;
  }

  // Of faces that are listed twice the first is the one that regions have.
  void find_skin() {
    const SideGroups<2> sides(mesh_);
    sides.each([&](std::span<const SideUse> uses) {
      const auto regions = std::partition_point(uses.begin(), uses.end(),
                                                [](const SideUse& u) { return u.dimension == 2; });
      for (auto use = uses.begin(); use != regions; ++use)
        add_listed(Face(use->index), use == uses.begin() ? std::span(regions, uses.end())
                                                         : std::span<const SideUse>());
      if (regions == uses.begin() && is_between({}, uses))
        skin_.push_back({{}, Region(uses[0].index), uses[0].side});
    });
    std::sort(skin_.begin(), skin_.end(), [](const SkinFace& a, const SkinFace& b) {
      return std::tie(a.listed, a.region, a.side) < std::tie(b.listed, b.region, b.side);
    });
  }

  void add_listed(Face f, std::span<const SideUse> regions) {
    if (is_between(mesh_.classification(f), regions))
      skin_.push_back({f, {}, 0});
    else
      mesh_.set_classification(f, mesh_.classification(Region(regions[0].index)));
  }

  [[nodiscard]] bool is_between(ModelRef listed, std::span<const SideUse> regions) const {
    return regions.size() != 2 || listed.dimension() == 2 ||
           mesh_.classification(Region(regions[0].index)) !=
               mesh_.classification(Region(regions[1].index));
  }

  [[nodiscard]] const ShapeTemplate& shape_of(EntityRef e) const {
    return shape_template(mesh_.shape(e));
  }
  [[nodiscard]] SideVertices vertices(const SkinFace& face) const {
    VertexBuffer buffer;
    if (face.listed.valid()) return SideVertices(mesh_.vertices_of(face.listed, buffer));
    const auto whole = mesh_.vertices_of(face.region, buffer);
    return {shape_of(face.region).sub(2, face.side), whole.data()};
  }
  [[nodiscard]] Shape shape(const SkinFace& face) const {
    return face.listed.valid() ? mesh_.shape(face.listed)
                               : shape_of(face.region).sub(2, face.side).shape;
  }

  // The skin as a surface of its own. Its vertices keep their order; those that the file puts on
  // model edges and vertices have a say wherever they are.
  MeshData skin_data() {
    MeshData data;
    for (const SkinFace& face : skin_) {
      const SideVertices side = vertices(face);
      for (const std::uint32_t v : side.span()) on_skin_[v] = 1;
    }
    for (const Edge e : mesh_.edges())
      if (given(e).dimension() == 1)
        for (const Vertex v : mesh_.edge_vertices(e)) on_skin_[v.index] = 1;
    place_.assign(mesh_.capacity(0), no_index);
    for (const Vertex v : mesh_.vertices()) {
      if (on_skin_[v.index] == 0 && given(v).dimension() > 1) continue;
      place_[v.index] = static_cast<std::uint32_t>(data.positions.size());
      data.positions.push_back(mesh_.position(v));
      data.vertex_classes.push_back(given(v));
      vertices_.push_back(v);
    }
    for (const SkinFace& face : skin_) {
      data.faces.shapes.push_back(shape(face));
      const SideVertices side = vertices(face);
      for (const std::uint32_t v : side.span()) data.faces.vertices.push_back(place_[v]);
      data.faces.classes.push_back(face.listed.valid() ? given(face.listed) : ModelRef());
    }
    for (const Edge e : mesh_.edges()) {
      if (given(e).dimension() != 1) continue;
      const auto [a, b] = mesh_.edge_vertices(e);
      data.edges.add(Shape::Line, {place_[a.index], place_[b.index]}, given(e));
    }
    return data;
  }

  [[nodiscard]] Vertex on_skin(Vertex v) const { return Vertex(place_[v.index]); }

  // Whether an edge on a model edge, or one that is no side, bounds no face of the skin.
  [[nodiscard]] bool has_bare_edges(Mesh& skin) const {
    const Request faces = skin.request(1, 2, "classification"),
                  edges = skin.request(0, 1, "classification");
    for (const Edge e : mesh_.edges()) {
      const ModelRef model = given(e);
      if (model.valid() && model.dimension() != 1) continue;
      const auto [a, b] = mesh_.edge_vertices(e);
      const Edge found = skin.find_edge(on_skin(a), on_skin(b));
      const bool bounds = found.valid() && !skin.row<2>(found).empty();
      if (!bounds && (model.valid() || !region_with(a, b).valid())) return true;
    }
    return false;
  }

  // The first region with an edge, or none.
  [[nodiscard]] Region region_with(Vertex a, Vertex b) const {
    VertexBuffer buffer;
    for (const Region r : mesh_.row<3>(a))
      if (edge_of(shape_of(r), mesh_.vertices_of(r, buffer).data(), a, b) >= 0) return r;
    return {};
  }

  // Which edge of a shape with these vertices joins two of them; negative where none does.
  static int edge_of(const ShapeTemplate& shape, const std::uint32_t* v, Vertex a, Vertex b) {
    for (int k = 0; k < shape.edge_count; ++k) {
      const auto& ends = shape.sub(1, k).vertices;
      const std::uint32_t from = v[ends[0]], to = v[ends[1]];
      if ((from == a.index && to == b.index) || (from == b.index && to == a.index)) return k;
    }
    return -1;
  }

  void take_over_faces(const Mesh& skin) {
    for (std::uint32_t i = 0; i < skin_.size(); ++i) {
      const ModelRef model = skin.classification(Face(i));
      if (skin_[i].listed.valid()) {
        mesh_.set_classification(skin_[i].listed, model);
        continue;
      }
      std::array<Vertex, max_face_vertices> corners;
      const SideVertices side = vertices(skin_[i]);
      for (std::uint32_t k = 0; k < side.count; ++k) corners[k] = Vertex(side.ids[k]);
      mesh_.create_face(std::span<const Vertex>(corners.data(), side.count), model);
    }
  }

  // Before new faces are listed: those that are say how new edges run.
  void take_over_edges(const Mesh& skin) {
    std::vector<NewEdge> missing;
    done_.assign(mesh_.capacity(1), 0);
    for (const Edge s : skin.edges()) {
      const ModelRef model = skin.classification(s);
      const auto [p, q] = skin.edge_vertices(s);
      const Vertex a = vertices_[p.index], b = vertices_[q.index];
      for (const Vertex v : {p, q})
        mesh_.set_classification(vertices_[v.index], skin.classification(v));
      if (const Edge e = mesh_.find_edge(a, b); e.valid())
        mesh_.set_classification(e, model), done_[e.index] = 1;
      else if (model.dimension() <= 1)
        missing.push_back(new_edge(std::min(a, b), std::max(a, b), model));
    }
    std::sort(missing.begin(), missing.end(), [](const NewEdge& a, const NewEdge& b) {
      return std::tie(a.low, a.first_user) < std::tie(b.low, b.first_user);
    });
    for (const NewEdge& e : missing) mesh_.create_edge(e.from, e.to, e.model);
  }

  // As completing the level would make it: it takes its direction from its first user.
  [[nodiscard]] NewEdge new_edge(Vertex a, Vertex b, ModelRef model) const {
    VertexBuffer buffer;
    const auto made = [&](std::uint32_t kind, std::uint32_t id, int side,
                          const ShapeTemplate& shape, const std::uint32_t* v) {
      const int k = edge_of(shape, v, a, b);
      const auto number = [](int i) { return static_cast<std::uint32_t>(i); };
      const auto& ends = shape.sub(1, std::max(k, 0)).vertices;
      return std::pair(k >= 0, NewEdge{a,
                                       Vertex(v[ends[0]]),
                                       Vertex(v[ends[1]]),
                                       model,
                                       {kind, id, number(side), number(k)}});
    };
    for (const Face f : mesh_.row<2>(a))
      if (const auto [has, e] =
              made(0, f.index, 0, shape_of(f), mesh_.vertices_of(f, buffer).data());
          has)
        return e;
    const Region r = region_with(a, b);
    const std::uint32_t* whole = mesh_.vertices_of(r, buffer).data();
    for (int k = 0; k < shape_of(r).face_count; ++k) {
      const SubEntity& sub = shape_of(r).sub(2, k);
      const SideVertices side(sub, whole);
      if (const auto [has, e] = made(1, r.index, k, shape_template(sub.shape), side.ids.data());
          has)
        return e;
    }
    AOMD_CHECK(false);
  }

  // A model vertex inside a region is one that the file put there.
  void classify_inside() {
    for (const Edge e : mesh_.edges()) {
      if (e.index >= done_.size() || done_[e.index] != 0) continue;
      const auto [a, b] = mesh_.edge_vertices(e);
      if (const Region r = region_with(a, b); r.valid())
        mesh_.set_classification(e, mesh_.classification(r));
    }
    for (const Vertex v : mesh_.vertices())
      if (on_skin_[v.index] == 0 && mesh_.classification(v).dimension() != 0 &&
          !mesh_.row<3>(v).empty())
        mesh_.set_classification(v, mesh_.classification(mesh_.row<3>(v)[0]));
  }

  Mesh& mesh_;
  ClassifyOptions options_;
  std::vector<Request> needs_;
  std::vector<SkinFace> skin_;         ///< by id, as completing the level would number them
  std::vector<std::uint8_t> on_skin_;  ///< by vertex
  std::vector<std::uint32_t> place_;   ///< by vertex: which of the skin it is, if any
  std::vector<Vertex> vertices_;       ///< of the skin
  std::vector<std::uint8_t> done_;     ///< by edge that was there: it is one of the skin's
};

}  // namespace

ClassifyResult classify_volume(Mesh& mesh, const ClassifyOptions& options) {
  return VolumeClassifier(mesh, options).run();
}

}  // namespace aomd
