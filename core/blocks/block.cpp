#include "core/blocks/block.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>

#include "core/decimate/decimation.h"
#include "core/io/left_out.h"

namespace aomd {
namespace {

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

/// What has become of a part of the file: its vertices had these ids.
Block block_of(const Mesh& mesh, const std::vector<std::uint32_t>& ids, const MeshData& original,
               int threads) {
  MeshData result = to_data(mesh);
  if (!original.attributes.empty()) static_cast<void>(io::carry_along(original, result, threads));
  Block block;
  for (const Attribute& array : original.attributes) {
    const auto same = [&](const Attribute& a) {
      return a.name == array.name && a.dimension == array.dimension;
    };
    const auto found = std::find_if(result.attributes.begin(), result.attributes.end(), same);
    block.values.push_back(found == result.attributes.end() ? std::vector<double>()
                                                            : std::move(found->values));
  }
  for (const Vertex v : mesh.vertices()) block.ids.push_back(ids[v.index]);
  block.positions = std::move(result.positions);
  for (std::size_t i = 0; i + 2 < result.faces.vertices.size(); i += 3)
    block.faces.push_back(
        {result.faces.vertices[i], result.faces.vertices[i + 1], result.faces.vertices[i + 2]});
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

DecimationOptions options_for(const std::vector<std::uint32_t>& ids, std::uint32_t goal,
                              const BlockRules& rules) {
  DecimationOptions options = rules.decimation;
  options.target_faces = goal;
  options.without |= 1u << static_cast<int>(Idea::SecondStage);
  auto keep = std::make_shared<Column<Vertex, std::uint8_t>>(ids.size(), std::uint8_t{0});
  for (std::uint32_t v = 0; v < ids.size(); ++v) (*keep)[Vertex(v)] = ids[v] != no_index;
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
  std::size_t numbers = 0;
  for (const std::vector<double>& array : values) numbers += array.size() + 1;
  bytes.reserve(48 + positions.size() * (sizeof positions[0] + sizeof ids[0]) +
                faces.size() * sizeof faces[0] + samples.size() * sizeof samples[0] +
                numbers * sizeof(double));
  put(bytes, positions);
  put(bytes, ids);
  put(bytes, faces);
  put(bytes, samples);
  for (const std::vector<double>& array : values) put(bytes, array);
  return bytes;
}

Block Block::from(std::string_view bytes) {
  Block block;
  take(bytes, block.positions);
  take(bytes, block.ids);
  take(bytes, block.faces);
  take(bytes, block.samples);
  while (!bytes.empty()) take(bytes, block.values.emplace_back());
  return block;
}

Block coarse_block(const io::StreamedSurface& surface, const BlockCut& cut, std::size_t block,
                   const BlockRules& rules) {
  io::StreamedSurface::Part part =
      surface.part([&](const Block::Triangle& t) { return cut.is_of(block, t); });
  if (part.mesh.faces.empty()) return {};
  for (std::uint32_t& id : part.ids)
    if (!cut.on_seam(id)) id = no_index;
  Mesh mesh(part.mesh);
  if (const char* obstacle = decimation_obstacle(mesh))
    throw io::LimitError(surface.name(), {}, obstacle);
  if (part.mesh.attributes.empty()) part.mesh = {};
  classify(mesh, rules.classify);
  keep_edges_for_quality(mesh);
  Decimation decimation(mesh, options_for(part.ids, goal_of(surface, mesh.count(2), rules), rules));
  decimation.run_phase();
  OriginalSamples samples = thinned(decimation.original(), every_how_many(surface, rules));
  renumber_faces(mesh, samples);
  Block coarse = block_of(mesh, part.ids, part.mesh, rules.decimation.threads);
  coarse.samples = std::move(samples);
  return coarse;
}

}  // namespace aomd
