#include "core/io/gltf_arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

bool all_fit(const Attribute& a, NumberType type) {
  return std::all_of(a.values.begin(), a.values.end(), [&](double x) {
    bool fits = false;
    use_as(type, x, [&](auto held) { fits = static_cast<double>(held) == x; });
    return fits;
  });
}

bool fit_float(const Attribute& a) {
  return std::all_of(a.values.begin(), a.values.end(), [](double x) {
    return !std::isfinite(x) || std::abs(x) <= double{std::numeric_limits<float>::max()};
  });
}

/// The array's own type where glTF has it, else the smallest one that holds all its numbers.
std::optional<NumberType> type_for(const Attribute& a) {
  const NumberType own = stored_type(a);
  const bool small = own <= NumberType::UInt16;
  if (a.meaning == Meaning::Colour && (own == NumberType::UInt8 || own == NumberType::UInt16))
    return own;
  const bool scaled = a.meaning == Meaning::Texture || a.meaning == Meaning::Normal ||
                      a.meaning == Meaning::Colour || a.components > 4;
  if (a.integer && small && !scaled) return own;
  if (a.integer && !scaled)
    for (const NumberType t :
         {NumberType::UInt8, NumberType::Int8, NumberType::UInt16, NumberType::Int16})
      if (all_fit(a, t)) return t;
  if (a.integer && !all_fit(a, NumberType::Float32)) return {};
  return fit_float(a) ? std::optional(NumberType::Float32) : std::nullopt;
}

/// Which of several sets an array is by its name: "uv" and "color" are 0, "uv_1" is 1. What else
/// pictures go by is told by these numbers.
int set_of(const Attribute& a) {
  const std::size_t line = a.name.rfind('_');
  const bool numbered = (a.meaning == Meaning::Texture || a.meaning == Meaning::Colour) &&
                        line != std::string::npos && line + 2 == a.name.size() &&
                        a.name.back() >= '0' && a.name.back() <= '9';
  return numbered ? a.name.back() - '0' : 0;
}

/// Gives arrays their semantics, in the order in which it gets them.
class Names {
 public:
  std::string next(const Attribute& a, NumberType type) {
    const bool shade = type == NumberType::Float32 ? !a.integer : type <= NumberType::UInt16;
    if (a.meaning == Meaning::Normal && a.components == 3 && !normals_) {
      normals_ = true;
      return "NORMAL";
    }
    if (a.meaning == Meaning::Colour && (a.components == 3 || a.components == 4) && shade)
      return "COLOR_" + std::to_string(colours_++);
    if (a.meaning == Meaning::Texture && a.components == 2)
      return "TEXCOORD_" + std::to_string(textures_++);
    const std::string own = "_" + a.name;
    return known_.insert(own).second ? own : std::string();
  }

 private:
  bool normals_ = false;
  int colours_ = 0, textures_ = 0;
  std::set<std::string> known_{"_AOMD_VERTEX", "_"};
};

}  // namespace

std::vector<GltfArray> gltf_arrays(const MeshData& mesh) {
  std::vector<GltfArray> found;
  const auto look = [&](const Attribute& a, bool on_corners) {
    const int n = a.components;
    const auto count = static_cast<std::size_t>(n) *
                       (on_corners ? mesh.faces.vertices.size() : mesh.positions.size());
    const bool shaped = (n >= 1 && n <= 4) || n == 9 || n == 16;
    if (!shaped || a.values.size() != count || a.name.starts_with("medit:")) return;
    if (const auto type = type_for(a)) found.push_back({&a, on_corners, {}, *type});
  };
  for (const Attribute& a : mesh.corners) look(a, true);
  for (const Attribute& a : mesh.attributes)
    if (a.dimension == 0) look(a, false);
  std::stable_sort(found.begin(), found.end(), [](const GltfArray& a, const GltfArray& b) {
    return set_of(*a.array) < set_of(*b.array);
  });
  Names names;
  for (GltfArray& one : found) one.semantic = names.next(*one.array, one.type);
  std::erase_if(found, [](const GltfArray& one) { return one.semantic.empty(); });
  return found;
}

bool has_numbers(const Attribute& array, std::size_t at) {
  const auto n = static_cast<std::size_t>(array.components);
  const auto given = std::span(array.values).subspan(n * at, n);
  return std::all_of(given.begin(), given.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace aomd::io::detail
