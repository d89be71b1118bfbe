#include "core/model/model.h"

#include <algorithm>

namespace aomd {

std::string name_of(ModelRef entity) {
  if (!entity.valid()) return "no model entity";
  return "model " + std::string(entity_name(entity.dimension())) + " " +
         std::to_string(entity.tag());
}

Model::Model(std::vector<Entry> entries) : entries_(std::move(entries)) {
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.ref < b.ref; });
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    if (!e.ref.valid()) throw std::invalid_argument("a model entity without a dimension");
    if (i > 0 && entries_[i - 1].ref == e.ref)
      throw std::invalid_argument(name_of(e.ref) + " is there twice");
    for (const ModelRef b : e.boundary)
      if (!(b.dimension() < e.ref.dimension()) || !find(b))
        throw std::invalid_argument(name_of(e.ref) + " is bounded by " + name_of(b) +
                                    ", which is not a lower entity of the model");
  }
}

std::optional<std::size_t> Model::find(ModelRef entity) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), entity,
                                   [](const Entry& e, ModelRef ref) { return e.ref < ref; });
  if (at == entries_.end() || at->ref != entity) return {};
  return static_cast<std::size_t>(at - entries_.begin());
}

std::size_t Model::index_of(ModelRef entity) const {
  if (const auto index = find(entity)) return *index;
  throw std::invalid_argument("the model has no " +
                              (entity.valid() ? name_of(entity) : "entity without a dimension"));
}

int Model::dimension() const { return entries_.empty() ? -1 : entries_.back().ref.dimension(); }

std::vector<ModelRef> Model::entities(int dim) const {
  std::vector<ModelRef> refs;
  for (const Entry& e : entries_)
    if (e.ref.dimension() == dim) refs.push_back(e.ref);
  return refs;
}

bool Model::contains(ModelRef entity) const { return find(entity).has_value(); }

std::vector<ModelRef> Model::closure(ModelRef entity) const {
  std::vector<ModelRef> found = entries_[index_of(entity)].boundary;
  for (std::size_t begin = 0; begin < found.size();) {  // one dimension lower every round
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      const auto& below = entries_[index_of(found[begin])].boundary;
      found.insert(found.end(), below.begin(), below.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

ClosestPoint Model::closest(ModelRef entity, const glm::dvec3& point) const {
  const std::size_t index = index_of(entity);
  return entity.dimension() == 3 ? ClosestPoint{point, {}} : closest_on(index, point);
}

glm::dvec3 Model::normal(ModelRef face, const glm::dvec3& point) const {
  const std::size_t index = index_of(face);
  if (face.dimension() != 2) throw std::invalid_argument(name_of(face) + " has no normal");
  return normal_of(index, point);
}

bool Model::has_parameters(ModelRef entity) const { return range_of(index_of(entity)).has_value(); }

ParameterRange Model::range(ModelRef entity) const {
  if (const auto range = range_of(index_of(entity))) return *range;
  throw std::invalid_argument(name_of(entity) + " has no parametrisation");
}

glm::dvec3 Model::evaluate(ModelRef entity, const glm::dvec2& parameters) const {
  const std::size_t index = index_of(entity);
  if (!range_of(index)) throw std::invalid_argument(name_of(entity) + " has no parametrisation");
  return evaluate_at(index, parameters);
}

Box Model::box(ModelRef entity) const {
  const std::size_t index = index_of(entity);
  return entity.dimension() == 3 ? Box() : box_of(index);
}

Box Model::box() const {
  Box all;
  for (std::size_t i = 0; i < entries_.size() && entries_[i].ref.dimension() < 3; ++i)
    all.add(box_of(i));
  return all;
}

double snap(const Model& model, Mesh& mesh, Vertex v) {
  const glm::dvec3 from = mesh.position(v), to = model.snap(mesh.classification(v), from);
  if (to != from) mesh.move(v, to);
  return glm::length(to - from);
}

}  // namespace aomd
