#include "core/model/class_rules.h"

#include <algorithm>
#include <set>

#include "core/base/assertion.h"
#include "core/mesh/derive.h"
#include "core/mesh/journal_scope.h"
#include "core/mesh/names.h"
#include "core/model/model.h"

namespace aomd {
namespace {

class ClassJudge {
 public:
  explicit ClassJudge(const ClassOverlay& classes) : classes_(classes), mesh_(classes.mesh()) {}

  ClassVerdict run() {
    const std::vector<EntityRef> changed = classes_.changed();
    if (changed.empty()) return {ClassRule::Nothing, {}, {}, {}, {}, 0};
    for (const EntityRef e : changed)
      if (!dimension_fits(e)) return verdict_;
    for (const Vertex v : vertices_at(changed))
      if (!curve_fits(v)) return verdict_;
    for (auto e = changed.rbegin(); e != changed.rend(); ++e)
      if (!border_fits(*e) || !sides_fit(*e) || !users_fit(*e)) return verdict_;
    points_fit(changed);
    return verdict_;
  }

 private:
  bool refuse(ClassRule rule, EntityRef e, EntityRef other = {}, std::uint32_t count = 0) {
    verdict_ = {rule, e, other, classes_.of(e), other.valid() ? classes_.of(other) : ModelRef(),
                count};
    return false;
  }

  bool dimension_fits(EntityRef e) {
    return classes_.of(e).may_classify(e.dimension) || refuse(ClassRule::Dimension, e);
  }

  bool bounds_well(EntityRef side, EntityRef user) {
    const ModelRef low = classes_.of(side), high = classes_.of(user);
    const bool fits =
        !low.valid() || !high.valid() || low == high || low.dimension() < high.dimension();
    return fits || refuse(ClassRule::Closure, side, user);
  }

  bool sides_fit(EntityRef e) {
    for (int level = e.dimension - 1; level >= 0; --level) {
      if (!mesh_.complete(level)) continue;
      adjacent(mesh_, e, level, ids_);
      for (const std::uint32_t id : ids_)
        if (!bounds_well({level, id}, e)) return false;
    }
    return true;
  }

  bool users_fit(EntityRef e) {
    for (int level = e.dimension + 1; level < 4; ++level) {
      if (mesh_.count(level) == 0) continue;
      adjacent(mesh_, e, level, ids_);
      for (const std::uint32_t id : ids_)
        if (!bounds_well(e, {level, id})) return false;
    }
    return true;
  }

  // Files may put other edges inside model faces: only those that come there are asked.
  bool border_fits(EntityRef e) {
    const bool comes_inside = e.dimension == 1 && mesh_.count(3) == 0 &&
                              classes_.of(e).dimension() == 2 &&
                              mesh_.classification(e).dimension() != 2;
    if (!comes_inside) return true;
    adjacent(mesh_, e, 2, ids_);
    return ids_.size() == 2 ||
           refuse(ClassRule::Border, e, {}, static_cast<std::uint32_t>(ids_.size()));
  }

  std::set<Vertex> vertices_at(const std::vector<EntityRef>& changed) const {
    std::set<Vertex> vertices;
    for (const EntityRef e : changed) {
      if (e.dimension == 0) vertices.insert(Vertex(e.index));
      if (e.dimension != 1) continue;
      for (const Vertex v : mesh_.edge_vertices(Edge(e.index))) vertices.insert(v);
    }
    return vertices;
  }

  bool curve_fits(Vertex v) {
    const ModelRef model = classes_.of(v);
    if (model.dimension() != 1) return true;
    adjacent(mesh_, v, 1, ids_);
    const auto on_it = std::count_if(ids_.begin(), ids_.end(), [&](std::uint32_t id) {
      return classes_.of({1, id}).dimension() == 1;
    });
    return on_it == 2 || refuse(ClassRule::Curve, v, {}, static_cast<std::uint32_t>(on_it));
  }

  bool points_fit(const std::vector<EntityRef>& changed) {
    std::unordered_map<std::uint32_t, Vertex> taken;  // by ModelRef::bits
    for (const EntityRef e : changed) {
      const ModelRef model = classes_.of(e);
      if (e.dimension != 0 || model.dimension() != 0) continue;
      const auto [place, fresh] = taken.emplace(model.bits(), Vertex(e.index));
      if (!fresh) return refuse(ClassRule::Point, e, place->second);
    }
    return others_leave_free(taken);
  }

  /// Of the vertices that stay where they are, none lies on what others come to.
  bool others_leave_free(const std::unordered_map<std::uint32_t, Vertex>& taken) {
    const auto free_of = [&](Vertex v) {
      const auto found = taken.find(classes_.of(v).bits());
      return found == taken.end() || found->second == v ||
             refuse(ClassRule::Point, found->second, v);
    };
    if (const ClassLists* lists = mesh_.class_lists()) {
      for (const auto& [bits, vertex] : taken)
        for (const std::uint32_t id : lists->entities(0, ModelRef::from_bits(bits)))
          if (!free_of(Vertex(id))) return false;
      return true;
    }
    if (taken.empty()) return true;
    for (const Vertex v : mesh_.vertices())
      if (!free_of(v)) return false;
    return true;
  }

  const ClassOverlay& classes_;
  const Mesh& mesh_;
  ClassVerdict verdict_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace

ModelRef ClassOverlay::of(EntityRef e) const {
  const auto& level = classes_[e.dimension];
  const auto found = level.find(e.index);
  return found == level.end() ? mesh_->classification(e) : found->second;
}

void ClassOverlay::set(EntityRef e, ModelRef model) { classes_[e.dimension][e.index] = model; }

std::vector<EntityRef> ClassOverlay::changed() const {
  std::vector<EntityRef> result;
  for (int dim = 0; dim < 4; ++dim)
    for (const auto& [id, model] : classes_[static_cast<std::size_t>(dim)])
      if (mesh_->classification({dim, id}) != model) result.emplace_back(dim, id);
  std::sort(result.begin(), result.end());
  return result;
}

ClassVerdict judge_classes(const ClassOverlay& classes) { return ClassJudge(classes).run(); }

void apply_classes(Mesh& mesh, const ClassOverlay& classes) {
  AOMD_CHECK(&mesh == &classes.mesh());
  const std::vector<EntityRef> changed = classes.changed();
  const JournalScope step(mesh, StepKind::Classify,
                          changed.empty() ? EntityRef() : changed.front());
  for (const EntityRef e : changed) mesh.set_classification(e, classes.of(e));
}

std::string class_words(const ClassVerdict& v) {
  const std::string who = v.entity.valid() ? name_of(v.entity) : "";
  switch (v.rule) {
    case ClassRule::None:
      return "no rule is broken";
    case ClassRule::Nothing:
      return "nothing would change";
    case ClassRule::Dimension:
      return who + " cannot lie on " + name_of(v.model) +
             ": an entity lies on a model entity of its own dimension or of a higher one";
    case ClassRule::Closure:
      return who + " on " + name_of(v.model) + " would bound " + name_of(v.other) + " on " +
             name_of(v.other_model) +
             ": what bounds an entity lies on the same model entity or on one of lower dimension";
    case ClassRule::Border:
      return who + " has " + std::to_string(v.count) + (v.count == 1 ? " face" : " faces") +
             " and would lie inside " + name_of(v.model) +
             ": inside a model face every edge has two faces";
    case ClassRule::Curve:
      return who + " would lie inside " + name_of(v.model) + ", but " + std::to_string(v.count) +
             (v.count == 1 ? " edge" : " edges") +
             " on model edges would meet there: where other than two meet stands a model vertex";
    case ClassRule::Point:
      return who + " and " + name_of(v.other) + " would lie on the same " + name_of(v.model) +
             ": a model vertex holds one vertex";
  }
  return {};
}

}  // namespace aomd
