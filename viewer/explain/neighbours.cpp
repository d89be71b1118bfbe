#include "viewer/explain/neighbours.h"

#include <algorithm>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/document/adjacency.h"

namespace aomd::scene {
namespace {

/// What the stored rows of T(I,J) give for several entities of level I, each once.
std::vector<std::uint32_t> next_level(const Mesh& mesh, int i, int j,
                                      const std::vector<std::uint32_t>& from) {
  std::vector<std::uint32_t> all, row;
  for (const std::uint32_t id : from) {
    adjacent(mesh, {i, id}, j, row);
    all.insert(all.end(), row.begin(), row.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// All but the two ends of the path; its steps up to there are stored rows.
std::vector<EntityRef> passed(const Mesh& mesh, EntityRef e, const LevelPath& levels) {
  std::vector<EntityRef> result;
  std::vector<std::uint32_t> ids{e.index};
  for (std::size_t k = 1; k + 1 < levels.size(); ++k) {
    ids = next_level(mesh, levels[k - 1], levels[k], ids);
    for (const std::uint32_t id : ids) result.emplace_back(levels[k], id);
  }
  return result;
}

std::string store_line(int i, int j) {
  return "adjacency " + std::to_string(i) + " " + std::to_string(j) + " on";
}

/// What stands in the way, and the command against it.
void explain_unknown(const Mesh& mesh, Neighbours& n) {
  const int i = n.of.dimension, j = n.level;
  const std::string name = relation_name(i, j);
  const bool no_hash = n.path.by_hash && !mesh.hash(j).built();
  n.remedy = store_line(i, j);
  if (n.path.kind != AdjacencyPath::Kind::None && no_hash) {
    n.words = name + " needs the hash set of the " + entity_plural(j) +
              ", which is not built: build it, or store " + name;
    return;
  }
  const bool incomplete = j > 0 && !mesh.complete(j);
  n.words = incomplete ? name + " is not stored, and not every " + entity_name(j) +
                             " exists: store " + name
                       : name + ": nothing that is stored leads there; store " + name;
}

}  // namespace

Neighbours find_neighbours(const Mesh& mesh, EntityRef e, int level) {
  Neighbours n{e, level, {}, false, {}, {}, {}, {}};
  if (level == e.dimension) {
    n.words = "T has no relation of a level to itself: choose another than " +
              std::string(entity_name(level));
    return n;
  }
  const std::string name = relation_name(e.dimension, level);
  if (mesh.count(level) == 0 && level > e.dimension) {
    n.words = name + ": there are no " + entity_plural(level);
    return n;
  }
  n.path = explain(mesh, e.dimension, level);
  const bool no_hash = n.path.by_hash && !mesh.hash(level).built();
  n.known = n.path.kind != AdjacencyPath::Kind::None && !no_hash;
  if (!n.known) {
    explain_unknown(mesh, n);
    return n;
  }
  std::vector<std::uint32_t> ids;
  adjacent(mesh, e, level, ids);
  for (const std::uint32_t id : ids) n.entities.emplace_back(level, id);
  n.between = passed(mesh, e, n.path.levels);
  n.words = name + (n.stored() ? " stored: one row" : " derived: " + n.path.text());
  return n;
}

std::uint32_t stored_bits(const Mesh& mesh) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i == j ? mesh.hash(i).built() : mesh.stored(i, j)) bits |= 1u << (4 * i + j);
  return bits;
}

OverlayStyle stored_style() { return {rgb(0x0a6cff), 4.2f, 6.0f, 0.38f}; }
OverlayStyle derived_style() { return {rgb(0x00a878), 3.4f, 6.4f, 0.26f, true}; }
OverlayStyle between_style() { return {rgb(0x8b95a5), 1.6f, 3.4f, 0.10f}; }

void draw_neighbours(const Mesh& mesh, const Neighbours& neighbours, const glm::dvec3& origin,
                     Overlay& overlay) {
  if (!neighbours.known) return;
  draw_entities(mesh, neighbours.between, between_style(), origin, overlay);
  draw_entities(mesh, neighbours.entities, neighbours.stored() ? stored_style() : derived_style(),
                origin, overlay);
  draw_entities(mesh, std::span(&neighbours.of, 1), selected_style(), origin, overlay);
}

}  // namespace aomd::scene
