#pragma once
// The solid model behind a mesh, whichever modeler answers for it (paper, section 2.2;
// docs/MODELS.md).

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/box.h"
#include "core/mesh/mesh.h"
#include "core/mesh/model_ref.h"

#pragma GCC visibility push(default)

namespace aomd {

/// A model cannot be read or evaluated, or does not fit the mesh; what() is one line.
struct ModelError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "model face 7".
[[nodiscard]] std::string name_of(ModelRef entity);

/// The point of a model entity that is nearest to another point.
struct ClosestPoint {
  glm::dvec3 position{};
  std::optional<glm::dvec2>
      parameters;  ///< where the entity has a parametrisation; y is 0 on a curve
};

/// Bounds of the parameters of an entity, infinite where it is; y is 0 on a curve.
struct ParameterRange {
  glm::dvec2 low{}, high{};
  std::array<bool, 2> periodic{};  ///< both ends are the same points
};

/// What a solid modeler must answer: the paper's generic function names over its modelers. Lengths
/// are in the units of the mesh. Every function that takes an entity throws std::invalid_argument,
/// naming it, where the model has no such entity; a modeler that fails throws ModelError. Looking
/// an entity up costs O(log n).
class Model {
 public:
  /// One entity and what bounds it directly.
  struct Entry {
    ModelRef ref;
    std::vector<ModelRef> boundary;
  };

  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  virtual ~Model() = default;

  /// The highest dimension that has entities; -1 for an empty model.
  [[nodiscard]] int dimension() const;
  /// The entities of a dimension, 0 to 3, by ascending tag. O(entities).
  [[nodiscard]] std::vector<ModelRef> entities(int dim) const;
  [[nodiscard]] bool contains(ModelRef entity) const;
  /// All lower entities that bound an entity, those that bound these included, sorted. O(their
  /// number).
  [[nodiscard]] std::vector<ModelRef> closure(ModelRef entity) const;

  /// The nearest point of a model vertex, edge or face; where several are, one of them. A region
  /// gives the point itself, inside or not. Edges end at their ends; whether a face ends at its
  /// border depends on the modeler.
  [[nodiscard]] ClosestPoint closest(ModelRef entity, const glm::dvec3& point) const;
  /// The position of closest(): where a vertex on that entity belongs (paper: G_snapVertex_).
  [[nodiscard]] glm::dvec3 snap(ModelRef entity, const glm::dvec3& point) const {
    return closest(entity, point).position;
  }
  /// The unit normal of a face where it is nearest to a point, to the side that the modeler calls
  /// outside. Throws std::invalid_argument for what is no model face.
  [[nodiscard]] glm::dvec3 normal(ModelRef face, const glm::dvec3& point) const;

  /// Whether an edge or face has a parametrisation.
  [[nodiscard]] bool has_parameters(ModelRef entity) const;
  /// Its bounds. Throws std::invalid_argument where there is none; so does evaluate().
  [[nodiscard]] ParameterRange range(ModelRef entity) const;
  [[nodiscard]] glm::dvec3 evaluate(ModelRef entity, const glm::dvec2& parameters) const;

  /// A box that holds an entity, and one that holds all: not always the smallest. Of a region:
  /// empty.
  [[nodiscard]] Box box(ModelRef entity) const;
  [[nodiscard]] Box box() const;

 protected:
  /// Takes the entities in any order. Throws std::invalid_argument where one is listed twice, or
  /// bounded by one that is not listed or not lower.
  explicit Model(std::vector<Entry> entries);

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] ModelRef entity(std::size_t index) const { return entries_[index].ref; }
  /// The position of an entity among all, sorted: what a modeler indexes its own data with.
  [[nodiscard]] std::size_t index_of(ModelRef entity) const;

 private:
  // A modeler answers these, for entities that exist and have the dimension in question.
  [[nodiscard]] virtual ClosestPoint closest_on(std::size_t index,
                                                const glm::dvec3& point) const = 0;
  [[nodiscard]] virtual glm::dvec3 normal_of(std::size_t index, const glm::dvec3& point) const = 0;
  [[nodiscard]] virtual std::optional<ParameterRange> range_of(std::size_t index) const = 0;
  [[nodiscard]] virtual glm::dvec3 evaluate_at(std::size_t index,
                                               const glm::dvec2& parameters) const = 0;
  [[nodiscard]] virtual Box box_of(std::size_t index) const = 0;

  [[nodiscard]] std::optional<std::size_t> find(ModelRef entity) const;

  std::vector<Entry> entries_;
};

/// Moves a mesh vertex to the nearest point of the model entity that it is classified on (paper:
/// G_snapVertex_) and returns how far. One edit in the journal when one is attached and the vertex
/// moves. Throws std::invalid_argument where the vertex is unclassified or the model lacks the
/// entity.
double snap(const Model& model, Mesh& mesh, Vertex v);

}  // namespace aomd

#pragma GCC visibility pop
