#include "core/io/ply_arrays.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string_view>

#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

/// Properties that are one array, by the names that programs give them.
struct KnownArray {
  std::string_view name;
  Meaning meaning;
  std::array<std::string_view, 4> components;

  [[nodiscard]] std::size_t size() const {
    return components[2].empty() ? 2 : components[3].empty() ? 3 : 4;
  }
};

constexpr std::array<KnownArray, 9> known_arrays{
    {{"normal", Meaning::Normal, {"nx", "ny", "nz", ""}},
     {"color", Meaning::Colour, {"red", "green", "blue", "alpha"}},
     {"color", Meaning::Colour, {"red", "green", "blue", ""}},
     {"diffuse",
      Meaning::Colour,
      {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
     {"diffuse", Meaning::Colour, {"diffuse_red", "diffuse_green", "diffuse_blue", ""}},
     {"st", Meaning::Texture, {"s", "t", "", ""}},
     {"uv", Meaning::Texture, {"u", "v", "", ""}},
     {"texture_uv", Meaning::Texture, {"texture_u", "texture_v", "", ""}},
     {"texcoord", Meaning::Texture, {"texcoord_x", "texcoord_y", "", ""}}}};

using Properties = std::span<const PlyProperty>;

/// How many of the first properties are of one type, up to a number.
std::size_t of_one_type(Properties properties, std::size_t most) {
  std::size_t n = 0;
  while (n < std::min(most, properties.size()) && properties[n].type == properties[0].type) ++n;
  return n;
}

const KnownArray* known_at(Properties properties) {
  for (const KnownArray& known : known_arrays) {
    if (of_one_type(properties, known.size()) < known.size()) continue;
    std::size_t n = 0;
    while (n < known.size() && properties[n].name == known.components[n]) ++n;
    if (n == known.size()) return &known;
  }
  return nullptr;
}

std::string numbered(std::string_view base, std::size_t n) {
  return std::string(base) + '_' + std::to_string(n);
}

/// How many of the first properties are NAME_0, NAME_1 and so on.
std::size_t numbered_at(Properties properties) {
  const std::string_view first = properties[0].name;
  if (first.size() < 3 || !first.ends_with("_0")) return 1;
  const std::string_view base = first.substr(0, first.size() - 2);
  const std::size_t most = of_one_type(properties, properties.size());
  std::size_t n = 1;
  while (n < most && properties[n].name == numbered(base, n)) ++n;
  return n;
}

/// The next array and how many properties it takes.
PlyGroup group_at(Properties properties, int dimension) {
  PlyGroup group;
  Attribute& a = group.array;
  a.dimension = dimension;
  a.name = properties[0].name;
  if (const KnownArray* known = known_at(properties)) {
    a.name = known->name;
    a.meaning = known->meaning;
    a.components = static_cast<int>(known->size());
  } else if (const std::size_t n = numbered_at(properties); n > 1) {
    a.name.resize(a.name.size() - 2);
    a.components = static_cast<int>(n);
  }
  store_as(a, properties[0].type);
  return group;
}

/// The first array of this meaning and as many components, one of the same name before all others.
const KnownArray* known_for(const Attribute& a) {
  const KnownArray* found = nullptr;
  for (const KnownArray& known : known_arrays) {
    if (known.meaning != a.meaning || static_cast<int>(known.size()) != a.components) continue;
    if (!found || known.name == a.name) found = &known;
  }
  return found;
}

class Namer {
 public:
  [[nodiscard]] std::vector<std::string> names_for(const Attribute& a) {
    const auto n = static_cast<std::size_t>(a.components);
    std::vector<std::string> names;
    const KnownArray* const known = known_for(a);
    for (std::size_t k = 0; known && k < n; ++k) names.emplace_back(known->components[k]);
    if (known && all_free(names)) return taken(names);
    for (std::string base = word(a.name); names = numbered_names(base, n), !all_free(names);)
      base += '_';
    return taken(names);
  }

 private:
  static std::string word(std::string name) {
    for (char& c : name)
      if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f) c = '_';
    return name.empty() ? "array" : name;
  }
  static std::vector<std::string> numbered_names(const std::string& base, std::size_t n) {
    if (n == 1) return {base};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < n; ++k) names.push_back(numbered(base, k));
    return names;
  }
  [[nodiscard]] bool all_free(const std::vector<std::string>& names) const {
    return std::none_of(names.begin(), names.end(),
                        [&](const std::string& name) { return taken_.contains(name); });
  }
  std::vector<std::string> taken(const std::vector<std::string>& names) {
    taken_.insert(names.begin(), names.end());
    return names;
  }

  /// What our own properties are called.
  std::set<std::string> taken_{"x",
                               "y",
                               "z",
                               "vertex_indices",
                               "vertex_index",
                               "vertex1",
                               "vertex2",
                               "model_dimension",
                               "model_tag"};
};

}  // namespace

std::vector<PlyGroup> arrays_of(const PlyElement& element, int dimension,
                                const std::vector<bool>& free) {
  std::vector<PlyGroup> groups;
  for (std::size_t i = 0; i < free.size();) {
    std::size_t end = i;
    while (end < free.size() && free[end]) ++end;
    if (end == i) {
      ++i;
      continue;
    }
    groups.push_back(group_at(Properties(element.properties).subspan(i, end - i), dimension));
    groups.back().first = i;
    i += static_cast<std::size_t>(groups.back().array.components);
  }
  return groups;
}

std::vector<PlyColumns> columns_of(const MeshData& mesh, int dimension) {
  Namer namer;
  std::vector<PlyColumns> columns;
  for (const Attribute& a : mesh.attributes) {
    if (a.dimension != dimension) continue;
    const NumberType type = stored_type(a);
    const bool wide = type == NumberType::Int64 || type == NumberType::UInt64;
    columns.push_back({&a, namer.names_for(a), wide ? NumberType::Float64 : type});
  }
  return columns;
}

}  // namespace aomd::io::detail
