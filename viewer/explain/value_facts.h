#pragma once
// What arrays of the file say of one entity.

#include <string>
#include <utility>
#include <vector>

#include "viewer/document/document.h"

namespace aomd::scene {

/// Appends the name and the value of each array on the entity, labels by what their numbers stand
/// for; of a face and a vertex also the values on corners, as long as the mesh is as it was loaded.
void add_value_facts(const Document& document, EntityRef e,
                     std::vector<std::pair<std::string, std::string>>& facts);

}  // namespace aomd::scene
