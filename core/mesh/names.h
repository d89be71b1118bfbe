#pragma once
// What entities and relations are called in messages; model entities: name_of() in
// core/model/model.h.

#include <string>

#include "core/mesh/handle.h"

namespace aomd {

/// "face 812"
[[nodiscard]] std::string name_of(EntityRef e);
/// "vertices", "edges", "faces" or "regions".
[[nodiscard]] const char* entity_plural(int dimension);
/// "T(0,2)"
[[nodiscard]] std::string relation_name(int i, int j);
/// A text with a capital at its start, where that is a letter from a to z.
[[nodiscard]] std::string capitalized(std::string text);

}  // namespace aomd
