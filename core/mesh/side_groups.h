#pragma once
// The edges or faces of a mesh, entities or not, each with all that has it as a side: without
// making entities of them, and without a table of all.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "core/mesh/bulk.h"
#include "core/mesh/relation.h"

namespace aomd {

/// An entity and which of its sides is meant; where it is of the level of the sides, itself.
struct SideUse {
  std::uint64_t tag = 0;  ///< of the side's key
  std::uint32_t index = no_index;
  std::uint8_t dimension = 0, side = 0;
  bool forward = false;  ///< as its key is

  friend bool operator<(const SideUse& a, const SideUse& b) {
    return a.tag != b.tag
               ? a.tag < b.tag
               : std::tie(a.dimension, a.index, a.side) < std::tie(b.dimension, b.index, b.side);
  }
};

/// Finds the sides of one level, 1 or 2, vertex by vertex, each at its smallest, through T(0,J):
/// where that is not stored, it is built for the while. Valid until the next edit.
template <int Level>
class SideGroups {
 public:
  explicit SideGroups(const Mesh& mesh) : vertices_(mesh.capacity(0)) {
    for (int dim = Level; dim < 4; ++dim)
      if (mesh.count(dim) > 0) stars_[static_cast<std::size_t>(dim)].emplace(mesh, dim);
  }
  SideGroups(const SideGroups&) = delete;
  SideGroups& operator=(const SideGroups&) = delete;

  /// Calls visit(uses) for every side: entities of its own level first, then faces, then regions,
  /// by id. Sides come in the order of their smallest vertices. O(sides).
  template <typename Visit>
  void each(Visit&& visit) const {
    std::vector<SideUse> uses;
    for (std::uint32_t v = 0; v < vertices_; ++v) {
      uses.clear();
      for (const auto& star : stars_)
        if (star) star->gather(v, uses);
      std::sort(uses.begin(), uses.end());
      for (auto from = uses.begin(), to = from; from != uses.end(); from = to) {
        to = end_of_side(from, uses.end());
        visit(std::span<const SideUse>(from, to));
      }
    }
  }
  /// The vertices of a side in the order of one that has it.
  [[nodiscard]] SideVertices vertices(const SideUse& use) const {
    const VertexRows& rows = stars_[use.dimension]->rows;
    return use.dimension == Level
               ? SideVertices(rows.vertices(use.index))
               : SideVertices(rows.shape(use.index).sub(Level, use.side), rows.row(use.index));
  }

 private:
  using Uses = std::vector<SideUse>::iterator;

  static auto key(std::span<const std::uint32_t> v) {
    if constexpr (Level == 1)
      return EdgeKey(v[0], v[1]);
    else
      return FaceKey(v);
  }
  static auto key(const SubEntity& side, const std::uint32_t* v) {
    const auto& at = side.vertices;
    if constexpr (Level == 1)
      return EdgeKey(v[at[0]], v[at[1]]);
    else
      return side.shape == Shape::Triangle ? FaceKey(v[at[0]], v[at[1]], v[at[2]])
                                           : FaceKey(SideVertices(side, v).span());
  }

  /// The entities of one level around each vertex.
  struct Star {
    int dim;
    VertexRows rows;
    UpRows made;
    const UpRows* around;

    Star(const Mesh& mesh, int dimension)
        : dim(dimension), rows(mesh, dim), around(&mesh.representation().up(0, dim)) {
      if (around->stored()) return;
      build_upward(mesh, 0, dim, made);
      around = &made;
    }
    void gather(std::uint32_t v, std::vector<SideUse>& uses) const {
      const auto add = [&](std::uint32_t id, int k, const auto& at) {
        if (at.low == v)
          uses.push_back({at.tag, id, static_cast<std::uint8_t>(dim), static_cast<std::uint8_t>(k),
                          at.forward});
      };
      for (const std::uint32_t id : around->row(v)) {
        const ShapeTemplate& shape = rows.shape(id);
        const std::uint32_t* whole = rows.row(id);
        if (dim == Level) add(id, 0, key(rows.vertices(id)));
        for (int k = 0; k < (dim == Level ? 0 : shape.count(Level)); ++k)
          add(id, k, key(shape.sub(Level, k), whole));
      }
    }
  };

  // Tags of edges and triangles are exact; those of other polygons need a second look.
  [[nodiscard]] Uses end_of_side(Uses from, Uses last) const {
    const SideUse first = *from;
    const auto to =
        std::find_if(from, last, [&](const SideUse& use) { return use.tag != first.tag; });
    if (Level == 1) return to;
    const SideVertices side = vertices(first);
    const auto same = [&](const SideUse& use) {
      return same_set(vertices(use).span(), side.span());
    };
    return std::all_of(from, to, same) ? to : std::stable_partition(from, to, same);
  }

  std::uint32_t vertices_;
  std::array<std::optional<Star>, 4> stars_;
};

}  // namespace aomd
