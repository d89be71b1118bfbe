#pragma once
// Levels and model entities as commands name them.

#include <optional>
#include <string>
#include <string_view>

#include "core/mesh/mesh.h"

namespace aomd::scene {

/// How large a mesh is: "7,160 faces", of a volume "165,295 regions".
[[nodiscard]] std::string size_words(const Mesh& mesh);

/// "vertex", "edge", "face" or "region" as 0 to 3.
[[nodiscard]] std::optional<int> level_named(std::string_view word);

/// "face:3": what Arguments::model_entity() reads. Empty for what is not classified.
[[nodiscard]] std::string model_entity_text(ModelRef ref);

}  // namespace aomd::scene
