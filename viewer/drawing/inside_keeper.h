#pragma once
// What is drawn of the inside of a volume, kept in step region by region and edge by edge.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "viewer/document/volume_changes.h"
#include "viewer/drawing/cell_drawing.h"
#include "viewer/drawing/drawable.h"

namespace aomd::scene {

/// Of one mesh and one drawable. What is gone leaves places behind, for what comes next.
class InsideKeeper {
 public:
  /// All of it. O(regions + skin).
  void draw(const Mesh& mesh, const Skin& skin, const CellStyle& style, Drawable& drawable);
  /// What changed, in the style of before. The mesh must store T(0,2) and T(0,3). O(changes), at
  /// the first time O(what is drawn).
  void patch(const Mesh& mesh, const VolumeChanges& changes, const CellStyle& style,
             Drawable& drawable);
  /// Of each triangle of the drawable's cells; invalid: none, or a face that no region has.
  [[nodiscard]] const std::vector<Region>& cell_regions() const { return cell_regions_; }

 private:
  void patch_cells(const Mesh& mesh, const VolumeChanges& changes, const CellStyle& style,
                   Drawable& drawable);
  void patch_edges(const Mesh& mesh, const VolumeChanges& changes, const CellStyle& style,
                   Drawable& drawable);
  void find_places();
  void take_cells_away(Region region, Drawable& drawable);
  void put(Region region, const Corner* corners, Drawable& drawable);
  void set_edge(const EdgeEnds& ends, const Segment* line, Drawable& drawable);

  std::vector<Region> cell_regions_;
  std::vector<EdgeEnds> edges_;  ///< of each interior edge, until the first patch
  bool patched_ = false;         ///< what follows is known
  std::vector<std::uint32_t> first_cell_, next_cell_;  ///< triangles by region, one after the other
  std::vector<std::uint32_t> free_cells_, free_edges_;
  std::unordered_map<std::uint64_t, std::uint32_t> edge_places_;
};

}  // namespace aomd::scene
