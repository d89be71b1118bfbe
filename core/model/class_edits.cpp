#include "core/model/class_edits.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/mesh/derive.h"
#include "core/model/curve_corners.h"

namespace aomd {
namespace {

class ClassEditor {
 public:
  ClassEditor(const Mesh& mesh, double corner_angle_deg)
      : mesh_(mesh), classes_(mesh), corner_(corner_angle_deg) {}

  ClassOverlay take() { return std::move(classes_); }

  void promote_edges(const std::set<Edge>& edges, std::optional<ModelRef> given) {
    if (edges.empty()) return;
    const ModelRef model = given ? *given : fresh(1);
    for (const Edge e : edges) classes_.set(e, model);
    const std::set<Vertex> ends = ends_of(edges);
    for (const Vertex v : ends) settle_end(v);
    name_pieces(curve_edges_at(ends), given ? std::nullopt : std::optional(model));
  }

  void promote_vertices(const std::set<Vertex>& vertices) {
    for (const Vertex v : vertices)
      if (!is_point(v)) classes_.set(v, fresh(0));
    name_pieces(curve_edges_at(vertices), {});
  }

  void demote_edges(const std::set<Edge>& edges) {
    for (const Edge e : edges) {
      const auto faces = adjacent<2>(mesh_, e);
      if (!faces.empty()) classes_.set(e, classes_.of(faces[0]));
    }
    const std::set<Vertex> ends = ends_of(edges);
    for (const Vertex v : ends) release_end(v);
    name_pieces(curve_edges_at(ends), {});
  }

  void demote_vertices(const std::set<Vertex>& vertices) {
    for (const Vertex v : vertices) {
      if (!is_point(v)) continue;
      const CurveEnds ends = curve(v);
      const ModelRef low = lowest_around(v);
      classes_.set(v, low);
      if (ends.count == 2) join(v, low);
    }
  }

  void put(std::span<const EntityRef> entities, ModelRef model, bool border) {
    for (const EntityRef e : entities)
      if (e.dimension != 1 || model.dimension() != 1) classes_.set(e, model);
    std::set<Edge> edges, around;
    std::set<Vertex> points;
    for (const EntityRef e : entities) {
      if (e.dimension == 1 && model.dimension() == 1) edges.insert(Edge(e.index));
      if (e.dimension == 0 && model.dimension() == 0) points.insert(Vertex(e.index));
      if (e.dimension == 2) take_along(Face(e.index), model, around);
    }
    promote_edges(edges, model);
    if (border) promote_edges(around, {});
    name_pieces(curve_edges_at(points), {});
  }

  void split(ModelRef face) {
    std::vector<std::vector<Face>> parts = parts_of(face);
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    std::set<Edge> ignored;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const ModelRef model = fresh(2);
      for (const Face f : parts[i]) classes_.set(f, model);
      for (const Face f : parts[i]) take_along(f, model, ignored);
    }
  }

 private:
  auto on_curve() const {
    return [this](Edge e) { return classes_.of(e).dimension() == 1; };
  }
  CurveEnds curve(Vertex v) const { return curve_at(mesh_, v, on_curve()); }
  bool is_point(Vertex v) const { return classes_.of(v).dimension() == 0; }

  ModelRef fresh(int dim) {
    auto& next = next_[static_cast<std::size_t>(dim)];
    if (!next) next = free_tag(mesh_, dim);
    return {dim, (*next)++};
  }

  std::set<Vertex> ends_of(const std::set<Edge>& edges) const {
    std::set<Vertex> ends;
    for (const Edge e : edges)
      for (const Vertex v : mesh_.edge_vertices(e)) ends.insert(v);
    return ends;
  }

  std::set<Edge> curve_edges_at(const std::set<Vertex>& vertices) const {
    std::set<Edge> edges;
    for (const Vertex v : vertices)
      for (const Edge e : mesh_.row<1>(v))
        if (on_curve()(e)) edges.insert(e);
    return edges;
  }

  // After edges have come to a model edge.
  void settle_end(Vertex v) {
    if (is_point(v)) return;
    const CurveEnds ends = curve(v);
    const bool passes = ends.count == 2 &&
                        classes_.of(ends.edges[0]) == classes_.of(ends.edges[1]) &&
                        !curve_turns(mesh_, v, ends, corner_, on_curve());
    classes_.set(v, passes ? classes_.of(ends.edges[0]) : fresh(0));
  }

  // After edges have left a model edge.
  void release_end(Vertex v) {
    const CurveEnds ends = curve(v);
    if (ends.count == 0) {
      if (const ModelRef around = lowest_around(v); one_around(v, around))
        return classes_.set(v, around);
    } else if (ends.count == 2 && classes_.of(ends.edges[0]) == classes_.of(ends.edges[1]) &&
               !curve_turns(mesh_, v, ends, corner_, on_curve())) {
      return classes_.set(v, classes_.of(ends.edges[0]));
    }
    if (!is_point(v)) classes_.set(v, fresh(0));
  }

  ModelRef lowest_around(Vertex v) const {
    ModelRef lowest;
    for (const Edge e : mesh_.row<1>(v)) lowest = std::min(lowest, classes_.of(e));
    return lowest;
  }
  bool one_around(Vertex v, ModelRef model) const {
    const auto edges = mesh_.row<1>(v);
    return std::all_of(edges.begin(), edges.end(), [&](Edge e) { return classes_.of(e) == model; });
  }

  // What lies between faces of one model entity lies on it; what does not is around them.
  void take_along(Face f, ModelRef model, std::set<Edge>& around) {
    for (const Edge e : adjacent<1>(mesh_, f)) {
      if (classes_.of(e).dimension() < 2) continue;
      const auto faces = adjacent<2>(mesh_, e);
      const bool inside =
          std::all_of(faces.begin(), faces.end(), [&](Face g) { return classes_.of(g) == model; });
      if (inside)
        classes_.set(e, model);
      else
        around.insert(e);
    }
    for (const Vertex v : adjacent<0>(mesh_, f))
      if (classes_.of(v).dimension() >= 2 && one_around(v, model)) classes_.set(v, model);
  }

  std::vector<std::vector<Face>> parts_of(ModelRef face) const {
    std::vector<std::vector<Face>> parts;
    std::set<Face> seen;
    for (const Face seed : mesh_.faces()) {
      if (mesh_.classification(seed) != face || !seen.insert(seed).second) continue;
      std::vector<Face> part{seed};
      for (std::size_t i = 0; i < part.size(); ++i)
        for (const Edge e : adjacent<1>(mesh_, part[i])) {
          if (classes_.of(e).dimension() < 2) continue;
          for (const Face g : adjacent<2>(mesh_, e))
            if (mesh_.classification(g) == face && seen.insert(g).second) part.push_back(g);
        }
      parts.push_back(std::move(part));
    }
    return parts;
  }

  /// The edges of a model edge that are connected with one, not through model vertices. `class_of`
  /// tells what entities lie on, before or after.
  template <typename ClassOf>
  std::vector<Edge> piece(Edge seed, const ClassOf& class_of) const {
    std::vector<Edge> edges{seed};
    std::set<Edge> seen{seed};
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (const Vertex v : mesh_.edge_vertices(edges[i])) {
        if (class_of(v).dimension() == 0) continue;
        for (const Edge e : mesh_.row<1>(v))
          if (class_of(e) == class_of(seed) && seen.insert(e).second) edges.push_back(e);
      }
    return edges;
  }

  struct Piece {
    std::vector<Edge> edges;
    Edge least;
  };

  // What was one piece of a model edge and now is several: the longest keeps the tag. `chained` is
  // a model edge whose pieces are all new.
  void name_pieces(const std::set<Edge>& at, std::optional<ModelRef> chained) {
    const auto now = [&](EntityRef e) { return classes_.of(e); };
    const auto before = [&](EntityRef e) { return mesh_.classification(e); };
    std::map<std::pair<std::uint32_t, Edge>, std::vector<Piece>> families;
    std::set<Edge> seen;
    for (const Edge seed : at) {
      if (seen.contains(seed)) continue;
      Piece p{piece(seed, now), {}};
      seen.insert(p.edges.begin(), p.edges.end());
      p.least = *std::min_element(p.edges.begin(), p.edges.end());
      const ModelRef model = now(seed);
      const auto old =
          std::find_if(p.edges.begin(), p.edges.end(), [&](Edge e) { return before(e) == model; });
      if (old == p.edges.end() && chained != model) continue;
      Edge family;
      if (old != p.edges.end()) {
        const std::vector<Edge> whole = piece(*old, before);
        family = *std::min_element(whole.begin(), whole.end());
      }
      families[{model.bits(), family}].push_back(std::move(p));
    }
    for (auto& [key, pieces] : families) name_family(pieces);
  }

  void name_family(std::vector<Piece>& pieces) {
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return a.edges.size() != b.edges.size() ? a.edges.size() > b.edges.size() : a.least < b.least;
    });
    for (std::size_t i = 1; i < pieces.size(); ++i) rename(pieces[i].edges, fresh(1));
  }

  void rename(const std::vector<Edge>& edges, ModelRef model) {
    for (const Edge e : edges) {
      classes_.set(e, model);
      for (const Vertex v : mesh_.edge_vertices(e))
        if (!is_point(v)) classes_.set(v, model);
    }
  }

  // The model edges on both sides of a vertex that is no model vertex any more.
  void join(Vertex v, ModelRef model) {
    const auto now = [&](EntityRef e) { return classes_.of(e); };
    for (const Edge e : curve(v).edges)
      if (now(e) != model) rename(piece(e, now), model);
  }

  const Mesh& mesh_;
  ClassOverlay classes_;
  TurnLimit corner_;
  std::array<std::optional<std::int32_t>, 4> next_;
};

}  // namespace

std::int32_t free_tag(const Mesh& mesh, int dimension) {
  std::int32_t highest = 0;
  const auto take = [&](ModelRef m) {
    if (m.dimension() == dimension) highest = std::max(highest, m.tag());
  };
  for (int level = 0; level <= dimension; ++level) {
    if (const ClassLists* lists = mesh.class_lists()) {
      for (const ModelRef m : lists->models(level)) take(m);
      continue;
    }
    for (std::uint32_t id = 0; id < mesh.capacity(level); ++id)
      if (mesh.alive({level, id})) take(mesh.classification({level, id}));
  }
  for (const ModelEntity& entity : mesh.model_table().entities) take(entity.ref);
  return highest + 1;
}

ClassOverlay promote(const Mesh& mesh, std::span<const EntityRef> entities,
                     double corner_angle_deg) {
  std::set<Edge> edges;
  std::set<Vertex> vertices;
  for (const EntityRef e : entities) {
    if (e.dimension == 1 && mesh.classification(e).dimension() > 1) edges.insert(Edge(e.index));
    if (e.dimension == 0 && mesh.classification(e).dimension() > 0)
      vertices.insert(Vertex(e.index));
  }
  ClassEditor editor(mesh, corner_angle_deg);
  editor.promote_edges(edges, {});
  editor.promote_vertices(vertices);
  return editor.take();
}

ClassOverlay demote(const Mesh& mesh, std::span<const EntityRef> entities,
                    double corner_angle_deg) {
  std::set<Edge> edges;
  std::set<Vertex> vertices;
  for (const EntityRef e : entities) {
    if (e.dimension == 1 && mesh.classification(e).dimension() == 1) edges.insert(Edge(e.index));
    if (e.dimension == 0 && mesh.classification(e).dimension() == 0)
      vertices.insert(Vertex(e.index));
  }
  ClassEditor editor(mesh, corner_angle_deg);
  editor.demote_edges(edges);
  editor.demote_vertices(vertices);
  return editor.take();
}

ClassOverlay assign(const Mesh& mesh, std::span<const EntityRef> entities, ModelRef model,
                    bool border, double corner_angle_deg) {
  ClassEditor editor(mesh, corner_angle_deg);
  editor.put(entities, model, border);
  return editor.take();
}

ClassOverlay split_face(const Mesh& mesh, ModelRef face) {
  ClassEditor editor(mesh, 180);
  editor.split(face);
  return editor.take();
}

}  // namespace aomd
