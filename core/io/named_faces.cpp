#include "core/io/named_faces.h"

#include <algorithm>
#include <map>

namespace aomd::io::detail {

const Attribute* find_named(const MeshData& mesh, std::string_view name) {
  const auto found =
      std::find_if(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& a) {
        return a.name == name && a.dimension == 2 && a.components == 1 && !a.names.empty();
      });
  if (found == mesh.attributes.end()) return nullptr;
  const auto named = [&](double x) {
    return x >= 0 && x < static_cast<double>(found->names.size()) &&
           x == static_cast<double>(static_cast<std::size_t>(x));
  };
  const bool all = std::all_of(found->values.begin(), found->values.end(), named);
  return all ? &*found : nullptr;
}

bool names_classes(const Attribute& label, const EntityList& faces) {
  std::map<double, ModelRef> class_of;
  std::map<ModelRef, double> label_of;
  for (std::size_t f = 0; f < faces.classes.size(); ++f) {
    const double x = label.values[f];
    const ModelRef m = faces.classes[f];
    if (class_of.try_emplace(x, m).first->second != m) return false;
    if (label_of.try_emplace(m, x).first->second != x) return false;
  }
  return true;
}

}  // namespace aomd::io::detail
