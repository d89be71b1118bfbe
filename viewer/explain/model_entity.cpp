#include "viewer/explain/model_entity.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "core/mesh/derive.h"
#include "core/mesh/geometry.h"
#include "core/mesh/names.h"
#include "core/model/model.h"
#include "viewer/base/entity_text.h"
#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

class ModelReader {
 public:
  ModelReader(const Mesh& mesh, ModelRef ref) : mesh_(mesh), lists_(*mesh.class_lists()) {
    result_.ref = ref;
  }

  ModelEntityFacts run() {
    for (int level = 0; level < 4; ++level)
      result_.counts[static_cast<std::size_t>(level)] = lists_.entities(level, result_.ref).size();
    const auto ids = lists_.entities(result_.ref.dimension(), result_.ref);
    result_.ids.assign(ids.begin(), ids.end());
    std::sort(result_.ids.begin(), result_.ids.end());
    measure();
    if (mesh_.count(3) == 0 && mesh_.stored(0, 1) && mesh_.stored(0, 2)) find_neighbours();
    take_sets();
    return std::move(result_);
  }

 private:
  void measure() {
    VertexBuffer buffer;
    double sum = 0;
    for (const std::uint32_t id : result_.ids) {
      const auto v = mesh_.vertices_of({result_.ref.dimension(), id}, buffer);
      const auto at = [&](std::size_t k) { return mesh_.position(Vertex(v[k])); };
      if (result_.ref.dimension() == 1) sum += glm::length(at(1) - at(0));
      for (std::size_t k = 2; result_.ref.dimension() == 2 && k < v.size(); ++k)
        sum += 0.5 * glm::length(area_normal(at(0), at(k - 1), at(k)));
    }
    if (result_.ref.dimension() == 1) result_.facts.emplace_back("Length", significant(sum));
    if (result_.ref.dimension() == 2) result_.facts.emplace_back("Area", significant(sum));
  }

  void find_neighbours() {
    if (result_.ref.dimension() == 2) return around_face();
    if (result_.ref.dimension() == 1) around_edge();
    if (result_.ref.dimension() == 0)
      for (const std::uint32_t id : result_.ids) around_vertex(Vertex(id));
  }

  std::set<ModelRef> faces_at(Edge e) const {
    std::set<ModelRef> faces;
    for (const Face f : adjacent<2>(mesh_, e)) faces.insert(mesh_.classification(f));
    return faces;
  }

  // By way of the model edges: they are few.
  void around_face() {
    for (const ModelRef curve : lists_.models(1)) {
      if (curve.dimension() != 1) continue;
      for (const std::uint32_t id : lists_.entities(1, curve)) {
        const std::set<ModelRef> faces = faces_at(Edge(id));
        if (!faces.contains(result_.ref)) continue;
        low_.insert(curve);
        beside_.insert(faces.begin(), faces.end());
        for (const Vertex v : mesh_.edge_vertices(Edge(id))) low_.insert(mesh_.classification(v));
      }
    }
  }

  void around_edge() {
    for (const std::uint32_t id : result_.ids) {
      const std::set<ModelRef> faces = faces_at(Edge(id));
      high_.insert(faces.begin(), faces.end());
      for (const Vertex v : mesh_.edge_vertices(Edge(id))) {
        if (mesh_.classification(v).dimension() != 0) continue;
        low_.insert(mesh_.classification(v));
        for (const Edge e : mesh_.row<1>(v))
          if (mesh_.classification(e).dimension() == 1) beside_.insert(mesh_.classification(e));
      }
    }
  }

  void around_vertex(Vertex v) {
    for (const Edge e : mesh_.row<1>(v)) high_.insert(mesh_.classification(e));
    for (const Face f : mesh_.row<2>(v)) high_.insert(mesh_.classification(f));
  }

  void take_sets() {
    for (auto* set : {&low_, &high_, &beside_}) set->erase(result_.ref), set->erase(ModelRef());
    result_.bounded_by.assign(low_.begin(), low_.end());
    std::stable_sort(result_.bounded_by.begin(), result_.bounded_by.end(),
                     [](ModelRef a, ModelRef b) { return a.dimension() > b.dimension(); });
    result_.bounds.assign(high_.begin(), high_.end());
    result_.beside.assign(beside_.begin(), beside_.end());
  }

  const Mesh& mesh_;
  const ClassLists& lists_;
  ModelEntityFacts result_;
  std::set<ModelRef> low_, high_, beside_;
};

}  // namespace

ModelEntityFacts model_entity_facts(const Mesh& mesh, ModelRef ref) {
  return ModelReader(mesh, ref).run();
}

std::string model_entity_title(ModelRef ref) { return capitalized(name_of(ref)); }

std::string model_entity_label(ModelRef ref) {
  return capitalized(entity_name(ref.dimension())) + " " + std::to_string(ref.tag());
}

std::string model_entity_text(const ModelEntityFacts& facts) {
  std::string text = model_entity_title(facts.ref) + "\n";
  for (int level = 0; level < 4; ++level)
    if (const std::size_t n = facts.counts[static_cast<std::size_t>(level)]; n > 0)
      text += std::string("Mesh entities, ") + entity_name(level) + ": " + std::to_string(n) + "\n";
  for (const auto& [name, value] : facts.facts) text += name + ": " + value + "\n";
  const auto list = [&](const char* title, const std::vector<ModelRef>& refs) {
    if (refs.empty()) return;
    text += title;
    for (const ModelRef ref : refs) text += " " + model_entity_text(ref);
    text += "\n";
  };
  list("Bounded by:", facts.bounded_by);
  list("Bounds:", facts.bounds);
  list("Beside:", facts.beside);
  text += "Ids:";
  for (const std::uint32_t id : facts.ids) text += " " + std::to_string(id);
  return text + "\n";
}

}  // namespace aomd::scene
