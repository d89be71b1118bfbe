#include "core/blocks/block.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>

#include "core/blocks/vertex_ranks.h"
#include "core/decimate/decimation.h"

namespace aomd {
namespace {

Block read_block(const io::StreamedSurface& surface, const BlockCut& cut, std::size_t block) {
  Block read;
  VertexRanks used(surface.vertices());
  read.faces.reserve(cut.faces(block));
  surface.each_faces([&](std::uint32_t, std::span<const Block::Triangle> triangles) {
    for (const Block::Triangle& t : triangles) {
      if (cut.block_of(t[0]) != block || !cut.is_inside(t) || !BlockCut::has_three_corners(t))
        continue;
      read.faces.push_back(t);
      for (const std::uint32_t v : t) used.add(v);
    }
  });
  used.finish();
  for (Block::Triangle& t : read.faces)
    for (std::uint32_t& v : t) v = used.rank(v);
  read.positions.reserve(used.count());
  read.ids.reserve(used.count());
  surface.each_vertices([&](std::uint32_t first, std::span<const glm::dvec3> positions) {
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
      if (!used.has(first + i)) continue;
      read.positions.push_back(positions[i]);
      read.ids.push_back(cut.on_seam(first + i) ? first + i : no_index);
    }
  });
  return read;
}

MeshData mesh_of(Block&& block) {
  MeshData data;
  data.positions = std::move(block.positions);
  data.faces.shapes.assign(block.faces.size(), Shape::Triangle);
  data.faces.vertices.reserve(3 * block.faces.size());
  for (const Block::Triangle& t : block.faces)
    data.faces.vertices.insert(data.faces.vertices.end(), t.begin(), t.end());
  return data;
}

// Which of so many samples stays does not hang on what was decimated: each stands for its
// neighbours in the order of the file too.
OriginalSamples thinned(const OriginalSamples& all, std::uint32_t every) {
  OriginalSamples kept;
  kept.reserve(all.size() / every + 1);
  for (std::size_t i = every / 2; i < all.size(); i += every) {
    kept.push_back(all[i]);
    kept.back().weight *= static_cast<float>(every);
  }
  return kept;
}

/// The faces of a mesh whose vertices had these ids.
Block block_of(const Mesh& mesh, const std::vector<std::uint32_t>& ids) {
  Block block;
  Column<Vertex, std::uint32_t> number(mesh.capacity(0), no_index);
  for (const Vertex v : mesh.vertices()) {
    number[v] = static_cast<std::uint32_t>(block.positions.size());
    block.positions.push_back(mesh.position(v));
    block.ids.push_back(ids[v.index]);
  }
  for (const Face f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    block.faces.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return block;
}

/// Where the faces of a mesh are among those that are left.
void renumber_faces(const Mesh& mesh, OriginalSamples& samples) {
  Column<Face, std::uint32_t> number(mesh.capacity(2), no_index);
  std::uint32_t count = 0;
  for (const Face f : mesh.faces()) number[f] = count++;
  for (OriginalSample& s : samples) s.face = Face(number[s.face]);
}

std::uint32_t goal_of(const io::StreamedSurface& surface, std::size_t faces,
                      const BlockRules& rules) {
  const double share = double(faces) / std::max(1u, surface.faces());
  return static_cast<std::uint32_t>(
      std::ceil(std::max(1.0, rules.above * rules.target(surface.faces()) * share)));
}

// More points than a fit can make use of only take memory.
std::uint32_t every_how_many(const io::StreamedSurface& surface, const BlockRules& rules) {
  constexpr std::uint64_t enough = 16;  // for each face of the result
  const std::uint64_t wanted = enough * std::max(1u, rules.target(surface.faces()));
  return static_cast<std::uint32_t>(std::max<std::uint64_t>(1, surface.vertices() / wanted));
}

DecimationOptions options_for(const Block& block, std::uint32_t goal, const BlockRules& rules) {
  DecimationOptions options = rules.decimation;
  options.target_faces = goal;
  options.without |= 1u << static_cast<int>(Idea::SecondStage);
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(block.ids.size(), std::uint8_t{0});
  for (std::uint32_t v = 0; v < block.ids.size(); ++v)
    (*keep)[Vertex(v)] = block.ids[v] != no_index;
  options.keep = std::move(keep);
  options.seal_kept = true;
  return options;
}

// Vectors of plain values, each behind its length.
template <typename Value>
void put(std::string& bytes, const std::vector<Value>& values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(Value));
}

template <typename Value>
void take(std::string_view& bytes, std::vector<Value>& values) {
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data(), sizeof count);
  values.resize(count);
  std::memcpy(values.data(), bytes.data() + sizeof count, count * sizeof(Value));
  bytes.remove_prefix(sizeof count + count * sizeof(Value));
}

}  // namespace

std::string Block::bytes() const {
  std::string bytes;
  bytes.reserve(32 + positions.size() * (sizeof positions[0] + sizeof ids[0]) +
                faces.size() * sizeof faces[0] + samples.size() * sizeof samples[0]);
  put(bytes, positions);
  put(bytes, ids);
  put(bytes, faces);
  put(bytes, samples);
  return bytes;
}

Block Block::from(std::string_view bytes) {
  Block block;
  take(bytes, block.positions);
  take(bytes, block.ids);
  take(bytes, block.faces);
  take(bytes, block.samples);
  return block;
}

Block coarse_block(const io::StreamedSurface& surface, const BlockCut& cut, std::size_t block,
                   const BlockRules& rules) {
  Block read = read_block(surface, cut, block);
  if (read.faces.empty()) return {};
  const DecimationOptions options =
      options_for(read, goal_of(surface, read.faces.size(), rules), rules);
  const std::vector<std::uint32_t> ids = std::move(read.ids);
  Mesh mesh(mesh_of(std::move(read)));
  if (const char* obstacle = decimation_obstacle(mesh))
    throw io::LimitError(surface.name(), {}, obstacle);
  classify(mesh, rules.classify);
  keep_edges_for_quality(mesh);
  Decimation decimation(mesh, options);
  decimation.run_phase();
  OriginalSamples samples = thinned(decimation.original(), every_how_many(surface, rules));
  renumber_faces(mesh, samples);
  Block coarse = block_of(mesh, ids);
  coarse.samples = std::move(samples);
  return coarse;
}

}  // namespace aomd
