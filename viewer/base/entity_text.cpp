#include "viewer/base/entity_text.h"

#include "core/mesh/names.h"
#include "viewer/base/text.h"

namespace aomd::scene {

std::string size_words(const Mesh& mesh) {
  return mesh.count(3) > 0 ? counted(mesh.count(3), "region") : counted(mesh.count(2), "face");
}

std::optional<int> level_named(std::string_view word) {
  for (int level = 0; level < 4; ++level)
    if (word == entity_name(level)) return level;
  return {};
}

std::string model_entity_text(ModelRef ref) {
  if (!ref.valid()) return {};
  return std::string(entity_name(ref.dimension())) + ":" + std::to_string(ref.tag());
}

}  // namespace aomd::scene
