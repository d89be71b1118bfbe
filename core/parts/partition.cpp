#include "core/parts/partition.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "core/parts/hilbert.h"

namespace aomd {
namespace {

constexpr int bits = 5;  // a side of the cube has 32 cells; all their places fit into 16 bits
constexpr std::size_t vertices_a_piece = 8192;

/// A cube of cells around a mesh.
struct Grid {
  glm::dvec3 low{0.0};
  double cells_per_unit = 0;

  // The planes that halve one cube, and the halves again, are not those of the next.
  Grid(const Mesh& mesh, int cut) {
    Box box;
    for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
    if (box.empty()) return;
    const glm::dvec3 size = box.high - box.low;
    const double side = std::max({size.x, size.y, size.z}) * (1 + 0.3 * cut);
    low = box.low - glm::dvec3(0.17 * cut * side);
    if (side > 0) cells_per_unit = (1u << bits) / side;
  }

  [[nodiscard]] std::uint32_t place(const glm::dvec3& p) const {
    std::array<std::uint32_t, 3> cell{};
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(
          std::clamp((p[k] - low[k]) * cells_per_unit, 0.0, double((1u << bits) - 1)));
    return hilbert_place(cell, bits);
  }
};

}  // namespace

std::size_t part_count(const Mesh& mesh) {
  constexpr std::size_t fewest_faces = 200'000, faces_a_part = 50'000;
  const std::size_t faces = mesh.count(2);
  return faces < fewest_faces ? 1 : std::min(faces / faces_a_part, Partition::most_parts);
}

Partition::Partition(const Mesh& mesh, std::size_t parts, int cut, int threads) : count_(parts) {
  if (parts == 1) return;
  place_.assign(mesh.capacity(0), 0);
  share_out(mesh, cut, threads);
  for (const Face f : mesh.faces()) mark_seam(mesh, f);
}

// A cell of the grid goes to the part that the middle of its vertices, counted along the curve,
// falls into.
void Partition::share_out(const Mesh& mesh, int cut, int threads) {
  const Grid grid(mesh, cut);
  parallel_for(place_.size(), threads, vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
      place_[Vertex(id)] = static_cast<std::uint16_t>(grid.place(mesh.position(Vertex(id))));
    });
  });
  std::vector<std::uint32_t> count(std::size_t{1} << 3 * bits, 0);
  for (const Vertex v : mesh.vertices()) ++count[place_[v]];
  std::uint64_t before = 0;
  for (std::uint32_t& c : count) {
    const std::uint64_t middle = before + c / 2;
    before += c;
    c = static_cast<std::uint32_t>(middle * count_ / std::max(1u, mesh.count(0)));
  }
  for (const Vertex v : mesh.vertices())
    place_[v] = static_cast<std::uint16_t>(2 * count[place_[v]]);
}

void Partition::mark_seam(const Mesh& mesh, Face f) {
  const auto t = mesh.triangle(f);
  if (part_of(t[0]) == part_of(t[1]) && part_of(t[1]) == part_of(t[2])) return;
  for (const Vertex v : t) place_[v] |= 1;
}

void Partition::joined(const Mesh& mesh, Vertex kept) {
  if (count_ == 1) return;
  for (const Face f : mesh.row<2>(kept)) mark_seam(mesh, f);
}

}  // namespace aomd
