#pragma once
// What a file says about the model itself: its entities, what bounds them, and named groups of
// them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/model_ref.h"

#pragma GCC visibility push(default)

namespace aomd {

/// One model entity as a file describes it.
struct ModelEntity {
  ModelRef ref;
  std::vector<std::int32_t>
      groups;  ///< tags of the physical groups it belongs to, negative where reversed
  std::vector<std::int32_t>
      boundary;  ///< tags of the entities one dimension lower, negative where reversed
  std::array<double, 6> box{};  ///< smallest x, y, z, then largest; a point's position twice
  friend bool operator==(const ModelEntity&, const ModelEntity&) = default;
};

/// A named set of model entities of one dimension ("physical group" in Gmsh).
struct PhysicalGroup {
  int dimension = 0;
  std::int32_t tag = 0;
  std::string name;
  friend bool operator==(const PhysicalGroup&, const PhysicalGroup&) = default;
};

/// The model behind a mesh as far as its file tells. Empty for formats that know none.
struct ModelTable {
  std::vector<ModelEntity> entities;
  std::vector<PhysicalGroup> groups;

  [[nodiscard]] bool empty() const { return entities.empty() && groups.empty(); }
  friend bool operator==(const ModelTable&, const ModelTable&) = default;
};

}  // namespace aomd

#pragma GCC visibility pop
