#include "core/blocks/coarse_surface.h"

#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/vertex_ranks.h"
#include "core/mesh/geometry.h"

namespace aomd {
namespace {

/// Puts blocks together, the strip between them first.
class Glue {
 public:
  Glue(const io::StreamedSurface& surface, const BlockCut& cut) : seam_(surface.vertices()) {
    io::StreamedSurface::Part strip =
        surface.part([&](const Block::Triangle& t) { return cut.is_of_strip(t); });
    for (const std::uint32_t v : strip.ids) seam_.add(v);
    seam_.finish();
    mesh_ = std::move(strip.mesh);
    const auto& corners = mesh_.faces.vertices;
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i)
      add_sample({corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]},
                 Face(static_cast<std::uint32_t>(i)));
  }

  void add(const Block& block) {
    const auto first_face = static_cast<std::uint32_t>(mesh_.faces.size());
    add_values(block);
    std::vector<std::uint32_t> number;
    number.reserve(block.ids.size());
    for (std::size_t v = 0; v < block.ids.size(); ++v) number.push_back(number_of(block, v));
    for (const Block::Triangle& t : block.faces) {
      mesh_.faces.shapes.push_back(Shape::Triangle);
      for (const std::uint32_t v : t) mesh_.faces.vertices.push_back(number[v]);
    }
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

  // Vertices on the seam have theirs from the strip.
  void add_values(const Block& block) {
    for (std::size_t i = 0; i < block.values.size(); ++i) {
      Attribute& array = mesh_.attributes[i];
      const auto n = static_cast<std::size_t>(array.components);
      const std::vector<double>& values = block.values[i];
      for (std::size_t k = 0; k < values.size(); ++k)
        if (array.dimension == 2 || block.ids[k / n] == no_index) array.values.push_back(values[k]);
    }
  }

  // Of a face of the strip: one point in its middle, for all of it.
  void add_sample(const Block::Triangle& t, Face f) {
    const auto& p = mesh_.positions;
    const glm::dvec3 normal = area_normal(p[t[0]], p[t[1]], p[t[2]]);
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    samples_.push_back({(p[t[0]] + p[t[1]] + p[t[2]]) / 3.0, glm::vec3(normal / length),
                        static_cast<float>(length / 2), f});
  }

  VertexRanks seam_;
  MeshData mesh_;
  OriginalSamples samples_;
};

/// The message of a process that could not do its part begins with what kind of failure it is.
enum class Part : char { Made = 'm', Failed = 'f', OutOfLimits = 'l' };

std::string message(Part part, const std::string& text) { return static_cast<char>(part) + text; }

/// What this process made, as a message, or why it could not.
struct Attempt {
  std::string message;
  std::exception_ptr failure;
};

template <typename Make>
Attempt attempt(const Make& make) {
  try {
    return {message(Part::Made, make()), nullptr};
  } catch (const std::bad_alloc&) {
    return {message(Part::OutOfLimits, "out of memory"), std::current_exception()};
  } catch (const io::LimitError& e) {
    return {message(Part::OutOfLimits, e.what()), std::current_exception()};
  } catch (const std::exception& e) {
    return {message(Part::Failed, e.what()), std::current_exception()};
  }
}

/// The failure of the first of the others who could not do its part; none where all could.
std::exception_ptr failure_in(const std::vector<std::string>& all) {
  for (std::size_t rank = 1; rank < all.size(); ++rank) {
    const auto part = static_cast<Part>(all[rank].front());
    const std::string process = "process " + std::to_string(rank), what = all[rank].substr(1);
    if (part == Part::OutOfLimits)
      return std::make_exception_ptr(io::LimitError(process, {}, what));
    if (part == Part::Failed) return std::make_exception_ptr(io::ReadError(process, {}, what));
  }
  return nullptr;
}

/// What all processes make, each behind one byte: for the first one. Nothing where one has failed:
/// then all end, and the first one throws what it was.
template <typename Make>
std::optional<std::vector<std::string>> share(Exchange& exchange, const Make& make) {
  Attempt mine = attempt(make);
  std::vector<std::string> all = exchange.gather(std::move(mine.message));
  const std::exception_ptr failure = mine.failure ? mine.failure : failure_in(all);
  if (exchange.told(!failure)) return all;
  if (exchange.rank() == 0) std::rethrow_exception(failure);
  return {};
}

}  // namespace

std::optional<CoarseSurface> coarsen_in_blocks(const std::filesystem::path& path,
                                               std::size_t blocks, const BlockRules& rules,
                                               Exchange& exchange,
                                               const std::function<void(double)>& done) {
  std::optional<io::StreamedSurface> surface;
  std::optional<BlockCut> cut;
  const auto look = [&] {
    surface.emplace(path, rules.weld);
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
      glue->add(Block::from(std::string_view((*all)[k]).substr(1)));
  }
  if (!glue) return {};
  return glue->finish(*surface);
}

}  // namespace aomd
