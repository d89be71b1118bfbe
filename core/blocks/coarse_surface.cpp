#include "core/blocks/coarse_surface.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/blocks/vertex_ranks.h"
#include "core/mesh/geometry.h"

namespace aomd {
namespace {

/// Puts blocks together, the strip between them first.
class Glue {
 public:
  Glue(const io::StreamedSurface& surface, const BlockCut& cut) : seam_(surface.vertices()) {
    for (const Block::Triangle& t : cut.strip())
      for (const std::uint32_t v : t) seam_.add(v);
    seam_.finish();
    surface.each_vertices([&](std::uint32_t first, std::span<const glm::dvec3> positions) {
      for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (seam_.has(first + i)) mesh_.positions.push_back(positions[i]);
    });
    for (Block::Triangle t : cut.strip()) {
      for (std::uint32_t& v : t) v = seam_.rank(v);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
      add_sample(t);
      add_face(t);
    }
  }

  void add(const Block& block) {
    const auto first_face = static_cast<std::uint32_t>(mesh_.faces.size());
    std::vector<std::uint32_t> number;
    number.reserve(block.ids.size());
    for (std::size_t v = 0; v < block.ids.size(); ++v) number.push_back(number_of(block, v));
    for (const Block::Triangle& t : block.faces)
      add_face({number[t[0]], number[t[1]], number[t[2]]});
    for (OriginalSample s : block.samples) {
      s.face = Face(first_face + s.face.index);
      samples_.push_back(s);
    }
  }

  CoarseSurface finish() {
    return {std::move(mesh_), std::make_shared<const OriginalSamples>(std::move(samples_))};
  }

 private:
  std::uint32_t number_of(const Block& block, std::size_t v) {
    if (block.ids[v] != no_index) return seam_.rank(block.ids[v]);
    mesh_.positions.push_back(block.positions[v]);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }

  void add_face(const Block::Triangle& t) {
    mesh_.faces.shapes.push_back(Shape::Triangle);
    mesh_.faces.vertices.insert(mesh_.faces.vertices.end(), t.begin(), t.end());
  }

  // Of a face of the strip: one point in its middle, for all of it.
  void add_sample(const Block::Triangle& t) {
    const auto& p = mesh_.positions;
    const glm::dvec3 normal = area_normal(p[t[0]], p[t[1]], p[t[2]]);
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    samples_.push_back({(p[t[0]] + p[t[1]] + p[t[2]]) / 3.0, glm::vec3(normal / length),
                        static_cast<float>(length / 2),
                        Face(static_cast<std::uint32_t>(mesh_.faces.size()))});
  }

  VertexRanks seam_;
  MeshData mesh_;
  OriginalSamples samples_;
};

// More points than a fit can make use of only take memory.
std::uint32_t every_how_many(const io::StreamedSurface& surface, std::uint32_t target) {
  constexpr std::uint64_t enough = 16;  // for each face of the result
  return static_cast<std::uint32_t>(
      std::max<std::uint64_t>(1, surface.vertices() / (enough * std::max(1u, target))));
}

}  // namespace

std::optional<CoarseSurface> coarsen_in_blocks(const io::StreamedSurface& surface,
                                               std::size_t blocks, BlockRules rules,
                                               Exchange& exchange,
                                               const std::function<void(double)>& done) {
  rules.every = every_how_many(surface, rules.decimation.target_faces);
  const BlockCut cut(surface, blocks);
  std::optional<Glue> glue;
  if (exchange.rank() == 0) glue.emplace(surface, cut);
  for (std::size_t first = 0; first < blocks; first += exchange.ranks()) {
    done(double(first) / double(blocks));
    const std::size_t mine = first + exchange.rank();
    Block block;
    if (mine < blocks) block = coarse_block(surface, cut, mine, rules);
    const auto all = exchange.gather(block.bytes());
    for (std::size_t k = 0; k < all.size() && first + k < blocks; ++k)
      glue->add(Block::from(all[k]));
  }
  if (!glue) return {};
  return glue->finish();
}

}  // namespace aomd
