#include "core/mesh/names.h"

namespace aomd {

std::string name_of(EntityRef e) {
  return std::string(entity_name(e.dimension)) + " " + std::to_string(e.index);
}

const char* entity_plural(int dimension) {
  constexpr const char* names[] = {"vertices", "edges", "faces", "regions"};
  return names[dimension];
}

std::string relation_name(int i, int j) {
  return "T(" + std::to_string(i) + "," + std::to_string(j) + ")";
}

std::string capitalized(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace aomd
