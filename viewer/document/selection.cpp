#include "viewer/document/selection.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

std::vector<EntityRef> sorted(std::span<const EntityRef> entities) {
  std::vector<EntityRef> result(entities.begin(), entities.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Calls visit(entity, vertices) for the live entities of a level.
template <typename Visit>
void for_level(const Mesh& mesh, int dim, Visit&& visit) {
  VertexBuffer buffer;
  for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id)
    if (mesh.alive({dim, id})) visit(EntityRef(dim, id), mesh.vertices_of({dim, id}, buffer));
}

}  // namespace

bool Selection::contains(EntityRef e) const {
  return std::binary_search(entities_.begin(), entities_.end(), e);
}

void Selection::replace(std::vector<EntityRef> entities) {
  entities_ = sorted(entities);
  ++revision_;
}

void Selection::add(std::span<const EntityRef> entities) {
  std::vector<EntityRef> all = entities_;
  all.insert(all.end(), entities.begin(), entities.end());
  replace(std::move(all));
}

void Selection::remove(std::span<const EntityRef> entities) {
  const std::vector<EntityRef> gone = sorted(entities);
  std::vector<EntityRef> rest;
  std::set_difference(entities_.begin(), entities_.end(), gone.begin(), gone.end(),
                      std::back_inserter(rest));
  replace(std::move(rest));
}

void Selection::toggle(EntityRef e) {
  contains(e) ? remove(std::span(&e, 1)) : add(std::span(&e, 1));
}

void Selection::drop_dead(const Mesh& mesh) {
  const auto dead = [&](EntityRef e) { return !mesh.alive(e); };
  if (std::erase_if(entities_, dead) > 0) ++revision_;
}

std::string selection_text(const Selection& selection) {
  std::array<std::size_t, 4> counts{};
  for (const EntityRef e : selection.entities()) ++counts[e.dimension];
  return selection.empty() ? "nothing" : counts_text(counts);
}

std::vector<EntityRef> grown(const Mesh& mesh, const Selection& selection) {
  std::vector<std::uint8_t> touched(mesh.capacity(0), 0);
  std::array<bool, 4> kinds{};
  VertexBuffer buffer;
  for (const EntityRef e : selection.entities()) {
    kinds[e.dimension] = true;
    if (e.dimension == 0) touched[e.index] = 1;
    if (e.dimension > 0)
      for (const std::uint32_t v : mesh.vertices_of(e, buffer)) touched[v] = 1;
  }
  std::vector<EntityRef> result(selection.entities().begin(), selection.entities().end());
  const auto near = [&](std::span<const std::uint32_t> vertices) {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](std::uint32_t v) { return touched[v] != 0; });
  };
  for (int dim = 1; dim <= 3; ++dim)
    for_level(mesh, dim, [&](EntityRef e, std::span<const std::uint32_t> vertices) {
      if (!near(vertices)) return;
      if (kinds[e.dimension]) result.push_back(e);
      if (kinds[0] && dim >= 2)
        for (const std::uint32_t v : vertices) result.emplace_back(0, v);
    });
  return result;
}

}  // namespace aomd::scene
