#pragma once
// Levels and model entities as commands name them.

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/model_ref.h"

namespace aomd::scene {

/// "vertex", "edge", "face" or "region" as 0 to 3.
[[nodiscard]] std::optional<int> level_named(std::string_view word);

/// "face:3": what Arguments::model_entity() reads. Empty for what is not classified.
[[nodiscard]] std::string model_entity_text(ModelRef ref);

}  // namespace aomd::scene
