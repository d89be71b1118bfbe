#include "core/fields/surface_pairing.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/fields/rims.h"
#include "core/mesh/geometry.h"

namespace aomd::fields {
namespace {

using Items = std::vector<SidedTree::Item>;

Items rim_items(const std::vector<RimSide>& rims) {
  Items items;
  for (const RimSide& side : rims)
    items.push_back({{side.ends[0], side.ends[1], side.ends[1]}, side.face, 0, glm::dvec3(0)});
  return items;
}

/// The pieces that shared vertices make of the faces: a number for each face, the same for all of a
/// piece.
std::vector<std::uint32_t> pieces_of(const Cells& faces) {
  DisjointSets sets(faces.mesh().positions.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (const std::uint32_t v : faces.vertices(f)) sets.unite(faces.vertices(f)[0], v);
  std::vector<std::uint32_t> pieces;
  pieces.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    pieces.push_back(sets.find(faces.vertices(f)[0]));
  return pieces;
}

bool all_one(const std::vector<std::uint32_t>& pieces) {
  return std::adjacent_find(pieces.begin(), pieces.end(), std::not_equal_to<>()) == pieces.end();
}

double longest_side(const Cells& faces, std::uint32_t f) {
  double longest = 0;
  const std::size_t n = faces.vertices(f).size();
  for (std::size_t k = 0; k < n; ++k)
    longest = std::max(longest, glm::distance(faces.corner(f, k), faces.corner(f, (k + 1) % n)));
  return longest;
}

}  // namespace

SurfacePairing::SurfacePairing(const Cells& original, const Cells& result, const SameVertices& same,
                               int threads)
    : original_(original),
      result_(result),
      same_(same),
      threads_(threads),
      faces_(original.mesh().positions, face_items(original), threads),
      rims_(original.mesh().positions, rim_items(rims_of(original)), threads) {
  face_sides_.reserve(result.size());
  for (std::uint32_t f = 0; f < result.size(); ++f)
    face_sides_.push_back({result.area_normal(f), longest_side(result, f), no_index});
  find_parts();
  find_sides();
}

/// Faces of one piece on one model face are a part.
void SurfacePairing::find_parts() {
  std::vector<std::uint32_t> pieces = pieces_of(original_), voted;
  const bool one = all_one(pieces), by_class = !original_.mesh().faces.classes.empty() &&
                                               !result_.mesh().faces.classes.empty();
  if (one && !by_class) return;
  if (one)
    voted.assign(result_.size(), pieces.empty() ? 0 : pieces[0]);
  else
    voted = pieces_by_vote(pieces);
  std::map<std::pair<std::uint32_t, ModelRef>, std::uint32_t> numbers;
  const auto key = [&](const std::vector<std::uint32_t>& piece, const Cells& cells,
                       std::uint32_t f) {
    return std::pair(piece[f], by_class ? cells.model(f) : ModelRef());
  };
  std::vector<std::uint32_t> parts;
  for (std::uint32_t f = 0; f < original_.size(); ++f)
    parts.push_back(
        numbers.try_emplace(key(pieces, original_, f), static_cast<std::uint32_t>(numbers.size()))
            .first->second);
  for (SidedTree* tree : {&faces_, &rims_})
    for (SidedTree::Item& item : tree->items()) item.part = parts[item.owner];
  for (std::uint32_t f = 0; f < result_.size(); ++f) {
    const auto found = numbers.find(key(voted, result_, f));
    if (found != numbers.end()) face_sides_[f].part = found->second;
  }
}

/// The piece of the original that most faces of each piece of the result lie on.
std::vector<std::uint32_t> SurfacePairing::pieces_by_vote(
    const std::vector<std::uint32_t>& pieces) const {
  const std::vector<std::uint32_t> after = pieces_of(result_);
  std::vector<std::uint32_t> votes(result_.size(), no_index);
  parallel_for(result_.size(), threads_, 128, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f)
      if (const std::uint32_t face = face_at(result_.centre(f), f); face != no_index)
        votes[f] = pieces[face];
  });
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> counts;
  for (std::uint32_t f = 0; f < result_.size(); ++f) ++counts[after[f]][votes[f]];
  std::map<std::uint32_t, std::uint32_t> winner;
  for (const auto& [piece, list] : counts)
    winner[piece] = std::max_element(list.begin(), list.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                    })->first;
  for (std::uint32_t f = 0; f < result_.size(); ++f) votes[f] = winner[after[f]];
  return votes;
}

void SurfacePairing::find_sides() {
  vertex_sides_.resize(result_.mesh().positions.size());
  for (std::uint32_t f = 0; f < result_.size(); ++f)
    for (const std::uint32_t v : result_.vertices(f)) {
      VertexSide& side = vertex_sides_[v];
      side.normal += face_sides_[f].direction;
      side.inward += result_.centre(f) - result_.mesh().positions[v];
      if (side.face == no_index) side.face = f;
    }
  if (rims_.empty()) return;
  for (const RimSide& side : rims_of(result_))
    for (const std::uint32_t v : side.ends) vertex_sides_[v].on_rim = true;
}

SurfacePlace SurfacePairing::place_at(const glm::dvec3& p, std::uint32_t face) const {
  const SidedTree::Item* const found = faces_.nearest(p, face_sides_[face]);
  return found ? SurfacePlace{found->owner, weighted(*found, p)} : SurfacePlace();
}

std::uint32_t SurfacePairing::face_at(const glm::dvec3& p, std::uint32_t face) const {
  const SidedTree::Item* const found = faces_.nearest(p, face_sides_[face]);
  return found ? found->owner : no_index;
}

std::vector<VertexSource> SurfacePairing::vertex_sources() const {
  std::vector<VertexSource> sources(vertex_sides_.size());
  parallel_for(sources.size(), threads_, 256, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v) sources[v] = source_of(v);
  });
  return sources;
}

const SidedTree::Item* SurfacePairing::item_of(std::uint32_t vertex) const {
  const VertexSide& own = vertex_sides_[vertex];
  if (own.face == no_index) return nullptr;
  Side side = face_sides_[own.face];
  if (own.on_rim) return rim_of(vertex, side.part);
  side.direction = own.normal;
  return faces_.nearest(result_.mesh().positions[vertex], side);
}

/// Of rims that are equally near the one whose face lies most the way into the vertex's own faces.
const SidedTree::Item* SurfacePairing::rim_of(std::uint32_t vertex, std::uint32_t part) const {
  const glm::dvec3& p = result_.mesh().positions[vertex];
  const SidedTree::Item* best = nullptr;
  double most = 0;
  rims_.each_nearest(p, part, [&](const SidedTree::Item& item) {
    const double cosine =
        cosine_between(original_.centre(item.owner) - p, vertex_sides_[vertex].inward);
    if (!best || cosine > most) best = &item, most = cosine;
  });
  return best;
}

/// By the nearest point of the triangle or segment.
VertexSource SurfacePairing::weighted(const SidedTree::Item& item, const glm::dvec3& p) const {
  const std::vector<glm::dvec3>& places = original_.mesh().positions;
  const auto [a, b, c] = item.corners;
  glm::dvec3 at;
  nearest_barycentric(p, places[a], places[b], places[c], at);
  return {{a, b, c, a}, {at.x, at.y, at.z, 0}};
}

VertexSource SurfacePairing::source_of(std::uint32_t vertex) const {
  const std::span<const std::uint32_t> same = same_.at(vertex);
  if (same.size() == 1) return VertexSource::only(same[0]);
  const SidedTree::Item* const found = item_of(vertex);
  if (!found) return same.empty() ? VertexSource() : VertexSource::only(same[0]);
  const glm::dvec3& p = result_.mesh().positions[vertex];
  for (const std::uint32_t v : found->corners)
    if (original_.mesh().positions[v] == p) return VertexSource::only(v);
  return same.empty() ? weighted(*found, p) : VertexSource::only(same[0]);
}

}  // namespace aomd::fields
