#pragma once
// What has changed on a surface between two places of its history.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "viewer/base/id_set.h"

namespace aomd::scene {

/// Where a mesh stands in its history, and what a reader of it needs to know to go on from where it
/// was.
struct HistoryPlace {
  std::uint64_t creations = 0;  ///< changes of T that made entities, which no journal records
  std::uint64_t epoch = 0;      ///< Journal::epoch
  std::size_t cursor = 0;       ///< Journal::cursor
  std::size_t last_cut = 0;     ///< steps before this one survived the cut that led to `epoch`
  friend bool operator==(const HistoryPlace&, const HistoryPlace&) = default;
};

/// Whether the records between two places say all that has changed: a reader that stood at the
/// first can go on from there.
[[nodiscard]] bool can_follow(const HistoryPlace& from, const HistoryPlace& to);

/// Sorted, without duplicates. Entities may be dead by now.
struct SurfaceChanges {
  bool everything = false;  ///< start afresh; the lists are empty
  std::vector<Face>
      faces;  ///< created, destroyed, rebound, classified, or with a vertex that moved
  std::vector<Vertex>
      vertices;             ///< whose star changed in any way: corners of `faces`, before and after
  std::vector<Edge> edges;  ///< touched themselves, or at `vertices`

  [[nodiscard]] bool nothing() const {
    return !everything && faces.empty() && vertices.empty() && edges.empty();
  }
};

/// Reads the changes of one mesh. Keeps a copy of the triangles, since a journal
/// does not say what stood where a face is gone. The mesh must store T(0,1), T(0,2) and T(2,0).
class ChangeReader {
 public:
  /// Changes since the last call. O(what the steps in between touched); O(size) when it must start
  /// afresh.
  [[nodiscard]] SurfaceChanges read(const Mesh& mesh, const Journal& journal,
                                    const HistoryPlace& now);

 private:
  [[nodiscard]] bool is_far(const Mesh& mesh, const Journal& journal, std::size_t cursor) const;
  void collect(const Mesh& mesh, const Journal& journal, std::size_t cursor,
               SurfaceChanges& changes);
  void add_stars(const Mesh& mesh, SurfaceChanges& changes);
  void remember(const Mesh& mesh);
  void remember(const Mesh& mesh, Face face);

  std::optional<HistoryPlace> place_;             ///< none: nothing is read yet
  std::vector<std::array<Vertex, 3>> triangles_;  ///< by face id, as of `place_`
  IdSet vertices_, edges_, faces_;                ///< scratch
};

}  // namespace aomd::scene
