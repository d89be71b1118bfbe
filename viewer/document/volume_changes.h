#pragma once
// What has changed among tetrahedra between two places of their history.

#include <array>
#include <optional>
#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "viewer/base/id_set.h"
#include "viewer/document/surface_changes.h"

namespace aomd::scene {

/// Lists are sorted, without duplicates; entities may be dead by now, or may not have been there
/// before. `before` are the vertices that each had then, invalid ones where it was not there.
struct VolumeChanges {
  bool everything = false;      ///< start afresh; the lists are empty
  std::vector<Region> regions;  ///< created, destroyed, rebound, or with a vertex that moved
  std::vector<std::array<Vertex, 4>> regions_before;
  std::vector<Face> faces;  ///< likewise, of those that are entities
  std::vector<std::array<Vertex, 3>> faces_before;
  std::vector<Edge> edges;  ///< touched themselves
  std::vector<std::array<Vertex, 2>> edges_before;
  std::vector<Vertex> vertices;  ///< touched themselves
  /// All that the regions, faces and edges have or had, and those touched themselves.
  std::vector<Vertex> surroundings;

  [[nodiscard]] bool nothing() const { return !everything && surroundings.empty(); }
};

/// Reads the changes of one prepared volume. Keeps a copy of what its entities are made of, since a
/// journal does not say what stood where one is gone. The mesh must store T(0,1), T(0,2), T(0,3).
class VolumeChangeReader {
 public:
  /// Changes since the last call. O(what the steps in between touched); O(size) where it must start
  /// afresh: where somebody else made entities, far away, and after a classification.
  [[nodiscard]] VolumeChanges read(const Mesh& mesh, const Journal& journal,
                                   const HistoryPlace& now);
  /// The next call starts afresh.
  void forget() { place_.reset(); }

 private:
  [[nodiscard]] bool can_patch(const Mesh& mesh, const Journal& journal,
                               const HistoryPlace& now) const;
  void collect(const Mesh& mesh, const Journal& journal, std::size_t cursor,
               VolumeChanges& changes);
  template <typename H, std::size_t N>
  void look(const Mesh& mesh, const std::vector<H>& entities,
            std::vector<std::array<Vertex, N>>& known, std::vector<std::array<Vertex, N>>& before);
  void remember(const Mesh& mesh);

  std::optional<HistoryPlace> place_;           ///< none: nothing is read yet
  std::vector<std::array<Vertex, 4>> regions_;  ///< by id, as of `place_`
  std::vector<std::array<Vertex, 3>> faces_;
  std::vector<std::array<Vertex, 2>> edges_;
  std::array<IdSet, 4> touched_;  ///< scratch
};

}  // namespace aomd::scene
