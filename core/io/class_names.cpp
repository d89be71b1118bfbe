#include "core/io/class_names.h"

#include <algorithm>
#include <charconv>

namespace aomd::io::detail {
namespace {

constexpr std::string_view face_prefix = "model_face_", region_prefix = "model_region_";
constexpr std::string_view unclassified = "unclassified";

std::optional<ModelRef> numbered(std::string_view name, std::string_view prefix, int dimension) {
  if (!name.starts_with(prefix)) return {};
  name.remove_prefix(prefix.size());
  std::int32_t tag = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), tag);
  const bool whole = error == std::errc{} && end == name.data() + name.size();
  if (!whole || tag < ModelRef::min_tag || tag > ModelRef::max_tag) return {};
  return ModelRef(dimension, tag);
}

}  // namespace

std::string class_name(ModelRef model) {
  if (!model.valid()) return std::string(unclassified);
  return std::string(model.dimension() == 3 ? region_prefix : face_prefix) +
         std::to_string(model.tag());
}

std::optional<ModelRef> class_of_name(std::string_view name) {
  if (name == unclassified) return ModelRef();
  const auto face = numbered(name, face_prefix, 2);
  return face ? face : numbered(name, region_prefix, 3);
}

std::vector<ModelRef> classes_of_parts(std::span<const std::string> names) {
  const bool ours = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return class_of_name(name).has_value();
  });
  std::vector<ModelRef> classes(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ours) {
      classes[i] = *class_of_name(names[i]);
    } else if (names.size() > 1) {
      classes[i] = ModelRef(2, static_cast<std::int32_t>(i) + 1);
    }
  }
  return classes;
}

}  // namespace aomd::io::detail
