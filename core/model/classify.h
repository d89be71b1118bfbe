#pragma once
// Classification of every mesh entity on a model that the mesh itself implies (paper, sections 2.1
// and 3).

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/model/features.h"

#pragma GCC visibility push(default)

namespace aomd {

struct ClassifyOptions {
  /// Edges whose faces meet at more than this become model edges; none: only boundary, non-manifold
  /// edges and borders between model faces do.
  std::optional<double> feature_angle_deg = 20.0;
  /// A model edge is cut by a model vertex where it turns by more than this.
  double corner_angle_deg = 60.0;
  /// Edges with more than two faces become model edges. Off for the paper's own loop, which knows
  /// no such rule.
  bool nonmanifold_edges = true;
  /// Keep what is classified already (it came with the file, and wins) and derive only the rest.
  /// Regions keep their model regions either way.
  bool keep_present = true;
  /// Edges, by their vertices, that become model edges whatever the angle says: where values on the
  /// corners of faces jump. Of surfaces only.
  std::vector<std::array<std::uint32_t, 2>> seams{};
  /// All edges and faces of a volume become entities. Without it only those on model edges and
  /// model faces do, beside what is listed; all the same where an edge on a model edge, or one that
  /// nothing implies, bounds no model face.
  bool complete = true;
};

/// How many model entities of each dimension the mesh is classified on afterwards.
struct ClassifyResult {
  int model_vertices = 0, model_edges = 0, model_faces = 0;
  FeatureCount features;
  /// Edges were classified already, or all faces, on more than one model face: the angle had no
  /// say.
  bool given = false;
};

/// Classifies all vertices, edges and faces. An edge lies on a model edge where it has one face or
/// more than two, where its faces lie on different model faces, or past the feature angle (see
/// find_features); elsewhere on its face's model face. Model edges are chained between model
/// vertices, which stand where other than two of them meet, where the curve turns sharply, and
/// where model faces touch in a point; model faces are flooded between model edges. The rule cannot
/// always be right (paper, figure 4): what the file says therefore wins, as far as it can be meant.
/// Faces, model edges and model vertices that it names stay; a vertex or edge that it puts on a
/// model face although model edges pass through goes down onto them, since many files classify
/// nothing but faces. Afterwards what bounds an entity lies on the same model entity or on one of
/// lower dimension (paper, section 2.1), whatever the mesh said before; Decimation demands that.
/// Vertices that nothing uses keep their class. Creates the edges when there are none. Journalled
/// as one step. O(entities).
ClassifyResult classify(Mesh& mesh, const ClassifyOptions& options = {});

}  // namespace aomd

#pragma GCC visibility pop
