#pragma once
// Mends what is safe to mend in a dirty surface, and says what it did.

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd {

/// What to mend. What is on by default keeps every point of the surface where it is, apart from
/// parts that enclose nothing (opposite_faces), and changes nothing in a mesh without these
/// defects.
struct RepairOptions {
  /// Vertices with equal coordinates become one, where that makes no edge of three faces. Off: a
  /// file with indices may mean its seams.
  bool weld = false;
  /// With weld: border vertices become one with others within this distance too, in the units of
  /// the mesh. They go in ascending order, each to the nearest before it that stayed, so that none
  /// moves further and sheets that are further apart stay two. Two corners of one face never become
  /// one.
  double weld_tolerance = 0;
  /// Faces that name a vertex twice lose the repetition; what has fewer than 3 corners left goes.
  bool repeated_vertices = true;
  /// Faces on the same vertices with opposite orientation go in pairs where one model face (or
  /// none) holds both: pockets and flaps without volume. A piece of several pairs and nothing else,
  /// a sheet listed from both sides, keeps one of each.
  bool opposite_faces = true;
  /// Of faces on the same vertices with the same orientation the first stays.
  bool repeated_faces = true;
  /// Faces that two-faced edges connect are turned to agree: the fewer follow the more, the ones
  /// that hold the first face where there are as many. A piece that cannot be oriented stays as it
  /// is.
  bool orient = true;
  /// Vertices are doubled until every edge has at most two faces and the faces at every vertex form
  /// one fan. At an edge of three or more, faces that run along it in opposite directions stay
  /// together, the pairs that bend least first; of equal ones those that enclose the inside; then
  /// in the order of the file. Where that would need two edges on the same vertices, they are
  /// paired another way, else the edge is cut open. Edges that the file puts on a model edge and
  /// vertices that it puts on a model vertex stay: there several faces are meant to meet.
  bool split = true;
  /// Triangles of exactly zero area: a side without length is collapsed, a longest side is swapped
  /// with the neighbour or, at the border, the face removed. Only where the surface stays the same,
  /// closed or not, and so does the model.
  bool zero_area = true;
  /// Pieces whose own box has a diagonal below this share of the whole one, percent, go; the
  /// largest stays. 0 is off.
  double min_piece_pct = 0;
  /// Vertices that no face and no listed edge uses go. Off: other files may count on the numbers.
  bool drop_unused = false;
};

/// One kind of defect and what became of it.
struct RepairItem {
  std::string name;       ///< "opposite faces"; stable, for scripts
  std::string text;       ///< a sentence without its full stop
  std::size_t count = 0;  ///< entities concerned
  int dimension = 0;      ///< of those: 0 vertices, 2 faces; edges (1) by one of their faces
  std::vector<std::uint32_t> first;  ///< the first few, as numbered before: vertices, or faces
};

struct RepairReport {
  std::vector<RepairItem> done;  ///< what was mended, in the order of work
  std::vector<RepairItem> left;  ///< what could not be mended safely
};

/// Mends the faces of `data` in place. Faces and vertices that stay keep their order,
/// classification and attributes; vertices that are doubled are appended with those of the
/// original, and listed edges follow their faces. Where nothing is wrong, nothing is changed, and a
/// second repair does nothing; only after a weld may it pair faces at an edge anew, where faces of
/// zero area have gone from it. Throws std::invalid_argument where there are regions (their sides
/// cannot be mended alone) or the arrays contradict each other. O(n log n): 0.1 s for the 202,520
/// faces of the dragon.
RepairReport repair(MeshData& data, const RepairOptions& options = {});

}  // namespace aomd
