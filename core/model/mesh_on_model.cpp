#include "core/model/mesh_on_model.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

#include "core/base/text.h"
#include "core/mesh/column.h"
#include "core/mesh/geometry.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/names.h"

namespace aomd {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

template <typename Visit>
void for_each_entity(const Mesh& mesh, Visit&& visit) {
  for (int dim = 0; dim <= 3; ++dim) {
    const IdPool& ids = mesh.ids(dim);
    for (std::uint32_t id = ids.next_alive(0); id < ids.capacity(); id = ids.next_alive(id + 1))
      visit(EntityRef(dim, id));
  }
}

// The nearest thing found so far.
struct Nearest {
  double distance = infinite;
  ModelRef model;

  void consider(double d, ModelRef m) {
    if (d < distance) distance = d, model = m;
  }
};

// Faces that no model edge separates, and what is known of the model face that they lie on.
struct Patch {
  std::vector<Face> faces;
  std::vector<Vertex> inside;
  std::set<ModelRef> curves;
};

class Fitter {
 public:
  Fitter(Mesh& mesh, const Model& model, double tolerance)
      : mesh_(mesh),
        model_(model),
        tolerance_(tolerance > 0 ? tolerance : 1e-6 * model.box().diagonal()),
        needs_{
            mesh.request(2, 0, "fitting to the model"), mesh.request(0, 1, "fitting to the model"),
            mesh.request(2, 1, "fitting to the model"), mesh.request(1, 2, "fitting to the model")},
        vertices_(mesh.capacity(0)),
        edges_(mesh.capacity(1)),
        faces_(mesh.capacity(2)) {
    for (int dim = 1; dim <= 2; ++dim)
      for (const ModelRef m : model.entities(dim)) closures_[m] = model.closure(m);
  }

  void run() {
    find_model_vertices();
    find_vertices_on_edges();
    for (const Edge e : mesh_.edges()) edges_[e] = model_edge_of(e);
    leave_unused_model_edges();
    check_border();
    for (const Face f : mesh_.faces())
      if (!faces_[f].valid()) place(patch_from(f));
    check_distance();
    apply();
  }

 private:
  [[nodiscard]] bool used(Vertex v) const { return !mesh_.row<1>(v).empty(); }

  void find_model_vertices() {
    std::vector<Nearest> nearest(mesh_.capacity(0));
    for (const ModelRef m : model_.entities(0)) {
      const glm::dvec3 p = model_.snap(m, {});
      for (const Vertex v : mesh_.vertices())
        if (used(v)) nearest[v.index].consider(glm::length(mesh_.position(v) - p), m);
    }
    take(nearest);
  }

  void find_vertices_on_edges() {
    std::vector<Nearest> nearest(mesh_.capacity(0));
    for (const ModelRef m : model_.entities(1)) {
      const Box box = model_.box(m);
      for (const Vertex v : mesh_.vertices()) {
        const glm::dvec3& p = mesh_.position(v);
        if (!used(v) || vertices_[v].valid() || box.distance2(p) > tolerance_ * tolerance_)
          continue;
        nearest[v.index].consider(glm::length(model_.snap(m, p) - p), m);
      }
    }
    take(nearest);
  }

  void take(const std::vector<Nearest>& nearest) {
    for (const Vertex v : mesh_.vertices()) {
      if (nearest[v.index].distance > tolerance_) continue;
      vertices_[v] = nearest[v.index].model;
      on_[vertices_[v]].push_back(v);
    }
  }

  [[nodiscard]] bool bounds(ModelRef lower, ModelRef upper) const {
    const std::vector<ModelRef>& closure = closures_.at(upper);
    return std::binary_search(closure.begin(), closure.end(), lower);
  }
  [[nodiscard]] bool on_or_bounds(Vertex v, ModelRef curve) const {
    return vertices_[v] == curve || (vertices_[v].dimension() == 0 && bounds(vertices_[v], curve));
  }

  [[nodiscard]] ModelRef model_edge_of(Edge e) const {
    const auto [a, b] = mesh_.edge_vertices(e);
    Nearest nearest;
    for (const Vertex v : {a, b})
      if (const ModelRef m = vertices_[v]; m.dimension() == 1) consider(m, a, b, nearest);
    if (vertices_[a].dimension() == 0 && vertices_[b].dimension() == 0)
      for (const ModelRef m : model_.entities(1)) consider(m, a, b, nearest);
    return nearest.model;
  }

  void consider(ModelRef curve, Vertex a, Vertex b, Nearest& nearest) const {
    if (!on_or_bounds(a, curve) || !on_or_bounds(b, curve)) return;
    const glm::dvec3 pa = mesh_.position(a), pb = mesh_.position(b), middle = 0.5 * (pa + pb);
    const glm::dvec3 foot = model_.snap(curve, middle);
    const double away = glm::length(foot - middle);
    if (away > 0.5 * glm::length(pb - pa)) return;
    const double to_ends = std::min(glm::length(pa - foot), glm::length(pb - foot));
    const auto between = [&](Vertex v) {
      return v != a && v != b && glm::length(mesh_.position(v) - foot) < to_ends;
    };
    if (const auto on = on_.find(curve); on != on_.end())
      if (std::any_of(on->second.begin(), on->second.end(), between)) return;
    nearest.consider(away, curve);
  }

  void leave_unused_model_edges() {
    for (const Vertex v : mesh_.vertices()) {
      const ModelRef m = vertices_[v];
      const auto along = mesh_.row<1>(v);
      if (m.dimension() == 1 &&
          std::none_of(along.begin(), along.end(), [&](Edge e) { return edges_[e] == m; }))
        vertices_[v] = {};
    }
  }

  void check_border() const {
    for (const Edge e : mesh_.edges())
      if (mesh_.row<2>(e).size() != 2 && !edges_[e].valid())
        throw ModelError("the mesh does not fit the model: edge " + std::to_string(e.index) +
                         " has " + std::to_string(mesh_.row<2>(e).size()) +
                         " faces but lies on no model edge");
  }

  Patch patch_from(Face seed) {
    constexpr ModelRef waiting(2, ModelRef::min_tag);  // replaced in place()
    Patch patch{{seed}, {}, {}};
    faces_[seed] = waiting;
    for (std::size_t i = 0; i < patch.faces.size(); ++i) {
      for (const Vertex v : mesh_.row<0>(patch.faces[i]))
        if (!vertices_[v].valid()) vertices_[v] = waiting, patch.inside.push_back(v);
      for (const Edge e : mesh_.row<1>(patch.faces[i])) {
        if (edges_[e].dimension() == 1) {
          patch.curves.insert(edges_[e]);
          continue;
        }
        for (const Face g : mesh_.row<2>(e))
          if (!faces_[g].valid()) faces_[g] = waiting, patch.faces.push_back(g);
      }
    }
    return patch;
  }

  [[nodiscard]] glm::dvec3 middle(Face f) const {
    glm::dvec3 sum(0);
    for (const Vertex v : mesh_.row<0>(f)) sum += mesh_.position(v);
    return sum / static_cast<double>(mesh_.row<0>(f).size());
  }

  // How far the patch is from a model face; gives up past a limit.
  [[nodiscard]] double distance(const Patch& patch, ModelRef face, double limit) const {
    double largest = 0;
    const auto consider_point = [&](const glm::dvec3& p) {
      largest = std::max(largest, glm::length(model_.snap(face, p) - p));
    };
    for (std::size_t i = 0; i < patch.inside.size() && largest < limit; ++i)
      consider_point(mesh_.position(patch.inside[i]));
    if (patch.inside.empty())
      for (std::size_t i = 0; i < patch.faces.size() && largest < limit; ++i)
        consider_point(middle(patch.faces[i]));
    return largest;
  }

  void place(const Patch& patch) {
    Nearest nearest;
    for (const ModelRef m : model_.entities(2)) {
      const bool possible = std::all_of(patch.curves.begin(), patch.curves.end(),
                                        [&](ModelRef curve) { return bounds(curve, m); });
      if (possible) nearest.consider(distance(patch, m, nearest.distance), m);
    }
    if (!nearest.model.valid())
      throw ModelError(
          "the mesh does not fit the model: no model face has the border of the faces around "
          "face " +
          std::to_string(patch.faces[0].index));
    if (!patch.inside.empty() && nearest.distance > largest_) {
      largest_ = nearest.distance;
      furthest_ = patch.faces[0];
    }
    for (const Face f : patch.faces) faces_[f] = nearest.model;
    for (const Vertex v : patch.inside) vertices_[v] = nearest.model;
  }

  void check_distance() const {
    if (largest_ > tolerance_)
      throw ModelError("the mesh does not lie on the model: up to " + number_text(largest_, 3) +
                       " between them around face " + std::to_string(furthest_.index) +
                       " (tolerance " + number_text(tolerance_, 3) + ")");
  }

  void apply() {
    const JournalScope step(mesh_, StepKind::Classify, {});
    for (const Face f : mesh_.faces()) mesh_.set_classification(f, faces_[f]);
    for (const Edge e : mesh_.edges())
      mesh_.set_classification(e, edges_[e].valid() ? edges_[e] : faces_[mesh_.row<2>(e)[0]]);
    for (const Vertex v : mesh_.vertices()) mesh_.set_classification(v, vertices_[v]);
  }

  Mesh& mesh_;
  const Model& model_;
  double tolerance_;
  std::array<Request, 4> needs_;
  std::map<ModelRef, std::vector<ModelRef>> closures_;
  std::map<ModelRef, std::vector<Vertex>> on_;  ///< the vertices on each model vertex and edge
  Column<Vertex, ModelRef> vertices_;
  Column<Edge, ModelRef> edges_;
  Column<Face, ModelRef> faces_;
  double largest_ = 0;
  Face furthest_;
};

}  // namespace

bool is_classified(const Mesh& mesh) {
  bool any = false;
  for_each_entity(mesh, [&](EntityRef e) { any = any || mesh.classification(e).valid(); });
  return any;
}

void check_entities(const Mesh& mesh, const Model& model) {
  std::set<ModelRef> missing;
  for_each_entity(mesh, [&](EntityRef e) {
    const ModelRef m = mesh.classification(e);
    if (m.valid() && !model.contains(m)) missing.insert(m);
  });
  if (!missing.empty())
    throw ModelError("the mesh lies on " + name_of(*missing.begin()) +
                     (missing.size() > 1
                          ? " and " + std::to_string(missing.size() - 1) + " more that"
                          : ", which") +
                     " the model does not have");
}

void check_against(const Mesh& mesh, const Model& model) {
  check_entities(mesh, model);
  const double limit = 0.01 * model.box().diagonal();
  for (const Vertex v : mesh.vertices()) {
    const ModelRef m = mesh.classification(v);
    if (!m.valid()) continue;
    if (const double d = glm::length(model.snap(m, mesh.position(v)) - mesh.position(v)); d > limit)
      throw ModelError(name_of(v) + " is " + number_text(d, 3) + " away from " + name_of(m) +
                       ", on which it is classified: another model, or other units");
  }
}

void classify_on(Mesh& mesh, const Model& model, double tolerance) {
  if (mesh.count(3) > 0) throw ModelError("a mesh with regions cannot be classified on a model");
  Fitter(mesh, model, tolerance).run();
}

}  // namespace aomd
