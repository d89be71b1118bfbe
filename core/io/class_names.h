#pragma once
// Classification in formats that carry only names: OBJ groups and STL solids.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/model_ref.h"

namespace aomd::io::detail {

/// "model_face_7", "model_region_1", or "unclassified": the names that our writers give.
[[nodiscard]] std::string class_name(ModelRef model);

/// The reverse, for faces; nothing where the name is not one of ours.
[[nodiscard]] std::optional<ModelRef> class_of_name(std::string_view name);

/// The class of each named part of a file: by its name where all names are ours, otherwise model
/// faces 1..n in order when there are several parts, and unclassified when there is one.
[[nodiscard]] std::vector<ModelRef> classes_of_parts(std::span<const std::string> names);

}  // namespace aomd::io::detail
