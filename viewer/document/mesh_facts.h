#pragma once
// Counts that describe a mesh; for a surface, kept up to date from its changes.

#include <array>
#include <cstdint>
#include <vector>

#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "viewer/document/skin.h"
#include "viewer/document/surface_changes.h"
#include "viewer/document/volume_changes.h"

namespace aomd::scene {

struct MeshFacts {
  std::int64_t vertices = 0;
  std::int64_t unused = 0;  ///< vertices that no face (of a volume: nothing) uses
  std::int64_t edges = 0;
  std::int64_t faces = 0;
  std::int64_t boundary = 0;     ///< edges with one face
  std::int64_t nonmanifold = 0;  ///< edges with more than two
  std::int64_t regions = 0;
  std::int64_t outer_faces = 0;  ///< of a volume: its surface, also where the mesh has no faces
  std::array<std::int64_t, max_shapes> shapes{};  ///< by Shape, of the highest level

  /// Over the vertices that are used.
  [[nodiscard]] std::int64_t euler() const { return vertices - unused - edges + faces; }
  friend bool operator==(const MeshFacts&, const MeshFacts&) = default;
};

/// Of a mesh with regions, whatever it stores. Edges are not looked at: boundary and nonmanifold
/// are 0. O(entities).
[[nodiscard]] MeshFacts volume_facts(const Mesh& mesh, const Skin& skin);

/// The same, kept up to date from the changes of a prepared volume (prepare_volume).
class VolumeFactsKeeper {
 public:
  /// All counts anew. O(entities).
  void start(const Mesh& mesh, const Skin& skin);
  /// The mesh must store T(0,1), T(0,2) and T(0,3), since the last start. O(changes).
  void update(const Mesh& mesh, const VolumeChanges& changes);
  [[nodiscard]] const MeshFacts& facts() const { return facts_; }

 private:
  MeshFacts facts_;
  Column<Face, std::uint8_t> outer_;  ///< of those that are entities
  Column<Vertex, std::uint8_t> unused_;
};

/// Of a surface. The mesh must store T(0,1) and T(0,2).
class FactsKeeper {
 public:
  /// O(changes), or O(size) when everything changed.
  void update(const Mesh& mesh, const SurfaceChanges& changes);
  /// Counts that somebody else made.
  void set(const MeshFacts& facts) { facts_ = facts; }
  [[nodiscard]] const MeshFacts& facts() const { return facts_; }

 private:
  enum class EdgeKind : std::uint8_t { Dead, Boundary, Inner, NonManifold, Bare };
  [[nodiscard]] static EdgeKind kind_of(const Mesh& mesh, Edge edge);
  void look_at_all(const Mesh& mesh);
  void look_at(const Mesh& mesh, Edge edge);
  void look_at(const Mesh& mesh, Vertex vertex);
  static void count(EdgeKind kind, std::int64_t by, MeshFacts& facts);

  MeshFacts facts_;
  Column<Edge, EdgeKind> edges_;
  Column<Vertex, std::uint8_t> unused_;
};

}  // namespace aomd::scene
