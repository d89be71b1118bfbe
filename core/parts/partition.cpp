#include "core/parts/partition.h"

#include <algorithm>
#include <vector>

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "core/parts/hilbert_grid.h"

namespace aomd {
namespace {

constexpr int bits = 5;  // a side of the cube has 32 cells; all their places fit into 16 bits
constexpr std::size_t vertices_a_piece = 8192;

Box box_of(const Mesh& mesh) {
  Box box;
  for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
  return box;
}

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
  if (mesh.count(3) == 0)
    for (const Face f : mesh.faces()) mark_seam(mesh.triangle(f));
  else
    for (const Region r : mesh.regions()) mark_seam(mesh.row<0>(r));
}

void Partition::share_out(const Mesh& mesh, int cut, int threads) {
  const HilbertGrid grid(box_of(mesh), bits, cut);
  parallel_for(place_.size(), threads, vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
      place_[Vertex(id)] = static_cast<std::uint16_t>(grid.place(mesh.position(Vertex(id))));
    });
  });
  std::vector<std::uint32_t> part(grid.cells(), 0);
  for (const Vertex v : mesh.vertices()) ++part[place_[v]];
  cut_into_pieces(part, mesh.count(0), count_);
  for (const Vertex v : mesh.vertices())
    place_[v] = static_cast<std::uint16_t>(2 * part[place_[v]]);
}

template <typename Corners>
void Partition::mark_seam(const Corners& corners) {
  const std::size_t part = part_of(*corners.begin());
  bool apart = false;
  for (const Vertex v : corners) apart = apart || part_of(v) != part;
  if (!apart) return;
  for (const Vertex v : corners) place_[v] |= 1;
}

void Partition::joined(const Mesh& mesh, Vertex kept) {
  if (count_ == 1) return;
  if (mesh.count(3) == 0)
    for (const Face f : mesh.row<2>(kept)) mark_seam(mesh.triangle(f));
  else
    for (const Region r : mesh.row<3>(kept)) mark_seam(mesh.row<0>(r));
}

}  // namespace aomd
