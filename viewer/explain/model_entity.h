#pragma once
// What there is to say about one model entity, as the mesh shows it.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd::scene {

struct ModelEntityFacts {
  ModelRef ref;
  std::array<std::size_t, 4> counts{};  ///< mesh entities of each level that lie on it
  /// Length of a model edge, area of a model face, units of the mesh; with its name.
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<ModelRef>
      bounded_by;  ///< model entities of lower dimension in its closure, highest first
  std::vector<ModelRef> bounds;  ///< those of higher dimension that it bounds
  std::vector<ModelRef>
      beside;  ///< model faces across its model edges, model edges across its vertices
  std::vector<std::uint32_t> ids;  ///< the mesh entities of its own dimension on it, ascending
};

/// The mesh must keep class lists. Neighbours are told of surfaces that store T(0,1) and T(0,2)
/// only. O(mesh entities on it and on all model edges).
[[nodiscard]] ModelEntityFacts model_entity_facts(const Mesh& mesh, ModelRef ref);

/// "Model face 3"
[[nodiscard]] std::string model_entity_title(ModelRef ref);
/// "Face 3": where it is plain that model entities are meant.
[[nodiscard]] std::string model_entity_label(ModelRef ref);
/// All of it as lines of text.
[[nodiscard]] std::string model_entity_text(const ModelEntityFacts& facts);

}  // namespace aomd::scene
