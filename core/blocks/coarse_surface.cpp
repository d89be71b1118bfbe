#include "core/blocks/coarse_surface.h"

#include <new>
#include <string>
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

  CoarseSurface finish(const io::StreamedSurface& surface) {
    return {std::move(mesh_), std::make_shared<const OriginalSamples>(std::move(samples_)),
            surface.vertices(), surface.faces(), surface.left_out()};
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

/// The message of a process that could not do its part begins with what kind of failure it is.
enum class Part : char { Made = 'm', Failed = 'f', OutOfLimits = 'l' };

std::string message(Part part, const std::string& text) { return static_cast<char>(part) + text; }

// The first process fails as it does alone; what others could not do it says.
template <typename Make>
std::string made_or_message(const Exchange& exchange, const Make& make) {
  if (exchange.rank() == 0) return message(Part::Made, make());
  try {
    return message(Part::Made, make());
  } catch (const std::bad_alloc&) {
    return message(Part::OutOfLimits, "out of memory");
  } catch (const io::LimitError& e) {
    return message(Part::OutOfLimits, e.what());
  } catch (const std::exception& e) {
    return message(Part::Failed, e.what());
  }
}

/// What all processes make, without the message around it: for the first one. Nothing where this
/// process could not do its part, and is to do no more.
template <typename Make>
std::optional<std::vector<std::string>> share(Exchange& exchange, const Make& make) {
  std::string mine = made_or_message(exchange, make);
  const bool made = mine.front() == static_cast<char>(Part::Made);
  std::vector<std::string> all = exchange.gather(std::move(mine));
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    const auto part = static_cast<Part>(all[rank].front());
    const std::string process = "process " + std::to_string(rank);
    all[rank].erase(0, 1);
    if (part == Part::OutOfLimits) throw io::LimitError(process, {}, all[rank]);
    if (part == Part::Failed) throw io::ReadError(process, {}, all[rank]);
  }
  if (!made) return {};
  return all;
}

}  // namespace

std::optional<CoarseSurface> coarsen_in_blocks(const std::filesystem::path& path,
                                               std::size_t blocks, const BlockRules& rules,
                                               Exchange& exchange,
                                               const std::function<void(double)>& done) {
  std::optional<io::StreamedSurface> surface;
  std::optional<BlockCut> cut;
  const auto look = [&] {
    surface.emplace(path);
    cut.emplace(*surface, blocks);
    return std::string();
  };
  if (!share(exchange, look)) return {};
  std::optional<Glue> glue;
  if (exchange.rank() == 0) glue.emplace(*surface, *cut);
  for (std::size_t first = 0; first < blocks; first += exchange.ranks()) {
    done(double(first) / double(blocks));
    const std::size_t mine = first + exchange.rank();
    const auto make = [&] {
      return mine < blocks ? coarse_block(*surface, *cut, mine, rules) : Block();
    };
    if (exchange.ranks() == 1) {
      glue->add(make());
      continue;
    }
    const auto all = share(exchange, [&] { return make().bytes(); });
    if (!all) return {};
    for (std::size_t k = 0; k < all->size() && first + k < blocks; ++k)
      glue->add(Block::from((*all)[k]));
  }
  if (!glue) return {};
  return glue->finish(*surface);
}

}  // namespace aomd
