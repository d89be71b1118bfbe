#include "core/repair/repair.h"

#include "core/base/text.h"
#include "core/fields/carry_corners.h"
#include "core/io/source.h"
#include "core/repair/stages.h"

namespace aomd {
namespace {

using namespace repair_detail;

void tell(std::vector<RepairItem>& items, const Tally& tally, int dimension, const char* name,
          const std::string& text) {
  if (tally.count() > 0) items.push_back({name, text, tally.count(), dimension, tally.first()});
}

class Repair {
 public:
  Repair(MeshData& data, const RepairOptions& options)
      : surface_(data), data_(data), options_(options) {}

  RepairReport run() {
    if (options_.weld) weld_ = Weld(surface_, options_.weld_tolerance);
    if (options_.repeated_vertices) repeated_vertices();
    if (options_.opposite_faces || options_.repeated_faces) coincident();
    if (options_.orient) orient();
    if (options_.weld || options_.split) fans();
    if (options_.zero_area) zero_area();
    if (options_.min_piece_pct > 0) small_pieces();
    surface_.finish();
    if (options_.drop_unused) unused();
    if (!report_.done.empty()) periodic();
    return std::move(report_);
  }

 private:
  void repeated_vertices() {
    const RepeatedVertices r = mend_repeated_vertices(surface_);
    tell(report_.done, r.removed, 2, "repeated vertices",
         counted(r.removed.count(), "face") + " on fewer than three different vertices removed");
    tell(report_.done, r.shrunk, 2, "repeated corners",
         counted(r.shrunk.count(), "face") + " with a repeated vertex given fewer corners");
    tell(report_.left, r.left, 2, "repeated vertices",
         counted(r.left.count(), "face") + " with a repeated vertex left: no shape for the rest");
  }

  void coincident() {
    const Coincident r =
        mend_coincident(surface_, options_.repeated_faces, options_.opposite_faces);
    tell(report_.done, r.opposite, 2, "opposite faces",
         counted(r.opposite.count(), "face") +
             " in coincident pairs of opposite orientation removed");
    tell(report_.done, r.sheets, 2, "sheets",
         counted(r.sheets.count(), "back face") + " of sheets listed from both sides removed");
    tell(report_.done, r.repeated, 2, "repeated faces",
         counted(r.repeated.count(), "repeated face") + " removed");
  }

  void orient() {
    const Oriented r = mend_orientation(surface_);
    tell(report_.done, r.turned, 2, "orientation",
         counted(r.turned.count(), "face") + " turned to agree with the neighbours");
    tell(report_.left, r.twisted, 2, "orientation",
         counted(r.twisted.count(), "piece") + " left that cannot be oriented");
  }

  void fans() {
    const Split r = mend_fans(surface_, weld_, options_.split);
    tell(report_.done, r.welded, 0, "welded vertices",
         counted(r.welded.count(), "vertex") + (weld_.moves()
                                                    ? " welded to others within the tolerance"
                                                    : " welded to others at the same position"));
    tell(report_.left, weld_.refused(), 0, "welded vertices",
         counted(weld_.refused().count(), "vertex") +
             " left within the tolerance of another: a face has both");
    const std::string opened = r.cut > 0 ? ", " + std::to_string(r.cut) + " of them cut open" : "";
    tell(report_.done, r.edges, 1, "non-manifold edges",
         counted(r.edges.count(), "edge") + " of three or more faces split" + opened);
    tell(report_.done, r.vertices, 0, "split vertices",
         counted(r.vertices.count(), "vertex") +
             " of several fans split: " + counted(r.copies, "vertex") + " added");
    tell(report_.left, r.kept_edges, 1, "non-manifold edges",
         counted(r.kept_edges.count(), "edge") +
             " of three or more faces left: the file puts them on the model");
  }

  void zero_area() {
    const ZeroArea r = mend_zero_area(surface_);
    tell(report_.done, r.collapsed, 2, "zero area, collapsed",
         counted(r.collapsed.count(), "side") + " without length collapsed at faces of zero area");
    tell(report_.done, r.swapped, 2, "zero area, swapped",
         counted(r.swapped.count(), "longest side") + " of faces of zero area swapped");
    tell(report_.done, r.removed, 2, "zero area, removed",
         counted(r.removed.count(), "face") + " of zero area at the border removed");
    tell(report_.left, r.left, 2, "zero area",
         counted(r.left.count(), "face") +
             " of zero area left: mending would change the surface or the model");
  }

  void small_pieces() {
    const Tally pieces = remove_small_pieces(surface_, options_.min_piece_pct);
    tell(report_.done, pieces, 2, "small pieces",
         counted(pieces.count(), "small piece") + " removed");
  }

  void unused() {
    const Tally dropped = drop_unused_vertices(data_);
    tell(report_.done, dropped, 0, "unused vertices",
         counted(dropped.count(), "vertex") + " that nothing uses dropped");
  }

  /// Links name vertices, which have changed.
  void periodic() {
    if (data_.periodic.empty()) return;
    const std::size_t n = data_.periodic.size();
    report_.done.push_back({"periodic links", counted(n, "periodic link") + " dropped", n, 2, {}});
    data_.periodic.clear();
  }

  Surface surface_;
  MeshData& data_;
  RepairOptions options_;
  Weld weld_;
  RepairReport report_;
};

}  // namespace

// Faces that change keep no order of their corners: values there follow at the end.
RepairReport repair(MeshData& data, const RepairOptions& options) {
  if (data.corners.empty()) return Repair(data, options).run();
  MeshData before;
  before.positions = data.positions;
  before.faces = data.faces;
  before.corners = std::exchange(data.corners, {});
  RepairReport report = Repair(data, options).run();
  data.corners = fields::carried_corners(before, data, 1);
  return report;
}

}  // namespace aomd
