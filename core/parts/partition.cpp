#include "core/parts/partition.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/mesh/id_pool.h"
#include "core/parts/hilbert_grid.h"

namespace aomd {
namespace {

constexpr int bits = 5;  // a side of the cube has 32 cells; all their places fit into 16 bits
constexpr std::size_t vertices_a_piece = 8192, entities_a_piece = 16384;

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
  const auto of_face = [&](Face f) { return mesh.triangle(f); };
  const auto of_region = [&](Region r) { return mesh.row<0>(r); };
  if (mesh.count(3) == 0)
    mark_seams<Face>(mesh, of_face, threads);
  else
    mark_seams<Region>(mesh, of_region, threads);
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
  parallel_for(place_.size(), threads, vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    each_alive(mesh.ids(0), begin, end, [&](std::uint32_t id) {
      place_[Vertex(id)] = static_cast<std::uint16_t>(2 * part[place_[Vertex(id)]]);
    });
  });
}

template <typename Corners>
bool Partition::is_across(const Corners& corners) const {
  const std::size_t part = part_of(*corners.begin());
  bool apart = false;
  for (const Vertex v : corners) apart = apart || part_of(v) != part;
  return apart;
}

// Few entities have corners in several parts: these are found by all threads, and marked by one.
template <typename H, typename CornersOf>
void Partition::mark_seams(const Mesh& mesh, const CornersOf& corners_of, int threads) {
  const IdPool& ids = mesh.ids(H::dimension);
  std::vector<H> across;
  std::mutex mutex;
  parallel_for(ids.capacity(), threads, entities_a_piece, [&](std::size_t begin, std::size_t end) {
    std::vector<H> found;
    each_alive(ids, begin, end, [&](std::uint32_t id) {
      if (is_across(corners_of(H(id)))) found.emplace_back(id);
    });
    const std::scoped_lock lock(mutex);
    across.insert(across.end(), found.begin(), found.end());
  });
  for (const H entity : across) mark_seam(corners_of(entity));
}

template <typename Corners>
void Partition::mark_seam(const Corners& corners) {
  if (!is_across(corners)) return;
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
