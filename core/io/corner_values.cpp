#include "core/io/corner_values.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>

#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

using Numbers = std::span<const double>;

bool same_bits(Numbers a, Numbers b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

std::size_t hash_of(Numbers numbers) {
  std::uint64_t h = 0;
  for (const double x : numbers) {
    h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return static_cast<std::size_t>(h);
}

bool has_numbers(Numbers numbers) {
  return std::none_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); });
}

}  // namespace

bool move_to_vertices(const Attribute& on_corners, MeshData& mesh) {
  const auto n = static_cast<std::size_t>(on_corners.components);
  Attribute a = on_corners;
  a.dimension = 0;
  a.values.assign(n * mesh.positions.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<bool> known(mesh.positions.size(), false);
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c) {
    const std::uint32_t v = mesh.faces.vertices[c];
    const Numbers given = Numbers(on_corners.values).subspan(n * c, n);
    const std::span<double> held = std::span(a.values).subspan(n * v, n);
    if (known[v] && !same_bits(held, given)) return false;
    std::copy(given.begin(), given.end(), held.begin());
    known[v] = true;
  }
  mesh.attributes.push_back(std::move(a));
  return true;
}

IndexedValues indexed(const Attribute& array, bool on_corners, const MeshData& mesh) {
  IndexedValues list{array.components, {}, {}};
  const auto n = static_cast<std::size_t>(array.components);
  const auto value = [&](std::size_t i) { return Numbers(array.values).subspan(n * i, n); };
  if (!on_corners) {
    list.numbers = array.values;
    for (const std::uint32_t v : mesh.faces.vertices)
      list.corners.push_back(has_numbers(value(v)) ? v : no_index);
    for (double& x : list.numbers) x = std::isnan(x) ? 0 : x;
    return list;
  }
  std::unordered_multimap<std::size_t, std::uint32_t> known;
  for (std::size_t c = 0; c < mesh.faces.vertices.size(); ++c) {
    const Numbers given = value(c);
    list.corners.push_back(no_index);
    if (!has_numbers(given)) continue;
    const auto [begin, end] = known.equal_range(hash_of(given));
    const auto found = std::find_if(begin, end, [&](const auto& entry) {
      return same_bits(Numbers(list.numbers).subspan(n * entry.second, n), given);
    });
    if (found == end) {
      list.corners.back() = static_cast<std::uint32_t>(list.numbers.size() / n);
      known.emplace(hash_of(given), list.corners.back());
      list.numbers.insert(list.numbers.end(), given.begin(), given.end());
    } else {
      list.corners.back() = found->second;
    }
  }
  return list;
}

}  // namespace aomd::io::detail
