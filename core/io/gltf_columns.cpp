#include "core/io/gltf_columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// What an attribute is called here and what it means: COLOR_0 is "color", COLOR_1 "color_1".
Attribute named(const std::string& semantic) {
  Attribute a;
  constexpr std::pair<std::string_view, std::pair<const char*, Meaning>> known[] = {
      {"COLOR_", {"color", Meaning::Colour}}, {"TEXCOORD_", {"uv", Meaning::Texture}}};
  for (const auto& [start, meant] : known) {
    if (!semantic.starts_with(start)) continue;
    const std::string number = semantic.substr(start.size());
    a.name = number == "0" ? meant.first : meant.first + ("_" + number);
    a.meaning = meant.second;
    return a;
  }
  a.name = semantic == "NORMAL" ? "normal" : semantic.substr(1);
  if (semantic == "NORMAL") a.meaning = Meaning::Normal;
  return a;
}

/// Upwards, as other formats have it; glTF counts the second coordinate downwards.
void turn_upwards(GltfNumbers& numbers) {
  const auto n = static_cast<std::size_t>(numbers.components);
  for (std::size_t i = 1; n > 1 && i < numbers.values.size(); i += n)
    numbers.values[i] = 1 - numbers.values[i];
}

void turn_normals(GltfNumbers& numbers, const glm::dmat3& turn) {
  if (turn == glm::dmat3(1)) return;
  for (std::size_t i = 0; i + 2 < numbers.values.size(); i += 3) {
    double* const x = &numbers.values[i];
    const glm::dvec3 turned = turn * glm::dvec3(x[0], x[1], x[2]);
    const double length = glm::length(turned);
    for (int k = 0; k < 3 && length > 0; ++k) x[k] = turned[k] / length;
  }
}

/// As the mesh holds them: whole numbers stay only as colours, and as what means nothing.
void make_usual(GltfNumbers& numbers, Attribute& a, const glm::dmat3& turn) {
  if (a.meaning != Meaning::Colour) use_floats(numbers);
  if (a.meaning == Meaning::Texture) turn_upwards(numbers);
  if (a.meaning == Meaning::Normal && numbers.components == 3) turn_normals(numbers, turn);
  const bool doubles =
      a.meaning == Meaning::Texture || (a.meaning == Meaning::Normal && turn != glm::dmat3(1));
  a.components = numbers.components;
  store_as(a, doubles ? NumberType::Float64 : numbers.type);
}

GltfNumbers taken_rows(const GltfNumbers& numbers, const std::vector<std::uint32_t>& rows) {
  GltfNumbers taken{numbers.components, numbers.type, numbers.normalized, {}};
  taken.values.reserve(static_cast<std::size_t>(numbers.components) * rows.size());
  for (const std::uint32_t row : rows) {
    const auto at = numbers.values.begin() + std::ptrdiff_t{numbers.components} * row;
    taken.values.insert(taken.values.end(), at, at + numbers.components);
  }
  return taken;
}

bool same_bits(const double* a, const double* b, std::size_t n) {
  return std::equal(a, a + n, b, [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

}  // namespace

void GltfColumns::begin(std::vector<std::uint32_t> vertices) {
  first_ = static_cast<std::uint32_t>(vertex_of_use_.size());
  vertex_of_use_.insert(vertex_of_use_.end(), vertices.begin(), vertices.end());
}

void GltfColumns::add(const std::string& semantic, const GltfNumbers& numbers,
                      const std::vector<std::uint32_t>& rows, const glm::dmat3& turn) {
  Attribute like = named(semantic);
  GltfNumbers taken = taken_rows(numbers, rows);
  make_usual(taken, like, turn);
  const std::string key = semantic + ' ' + std::to_string(like.components) + ' ' +
                          std::to_string(static_cast<int>(stored_type(like)));
  Attribute& a = columns_.try_emplace(key, std::move(like)).first->second;
  a.values.resize(static_cast<std::size_t>(a.components) * first_, no_number);
  a.values.insert(a.values.end(), taken.values.begin(), taken.values.end());
}

/// Uses without the attribute have no number; what is whole then becomes real.
void GltfColumns::fill(Attribute& array) const {
  array.values.resize(static_cast<std::size_t>(array.components) * vertex_of_use_.size(),
                      no_number);
  if (!array.integer || std::none_of(array.values.begin(), array.values.end(),
                                     [](double x) { return std::isnan(x); }))
    return;
  if (array.meaning == Meaning::Colour) {
    const double full = array.type == NumberType::UInt8 ? 255 : 65535;
    for (double& x : array.values) x /= full;
  }
  store_as(array, NumberType::Float64);
}

bool GltfColumns::spread_to_vertices(Attribute& array, std::size_t vertices) const {
  const auto n = static_cast<std::size_t>(array.components);
  std::vector<double> values(n * vertices, no_number);
  std::vector<bool> known(vertices, false);
  for (std::size_t use = 0; use < vertex_of_use_.size(); ++use) {
    const std::uint32_t v = vertex_of_use_[use];
    if (!known[v]) std::copy_n(&array.values[n * use], n, &values[n * v]);
    if (known[v] && !same_bits(&array.values[n * use], &values[n * v], n)) return false;
    known[v] = true;
  }
  array.values = std::move(values);
  return true;
}

void GltfColumns::finish(MeshData& mesh, const std::vector<std::uint32_t>& use_of_corner,
                         const std::vector<FaceOrigin>& origins) {
  for (auto& [key, array] : columns_) {
    fill(array);
    if (spread_to_vertices(array, mesh.positions.size())) {
      mesh.attributes.push_back(std::move(array));
    } else {
      array.dimension = 2;
      take_values(array, use_of_corner);
      spread_to_corners(array, origins);
      mesh.corners.push_back(std::move(array));
    }
  }
  columns_.clear();
}

}  // namespace aomd::io::detail
