#pragma once
// What of the original a cell of the result covers.

#include <map>
#include <vector>

#include "core/fields/surface_pairing.h"
#include "core/fields/tet_tree.h"
#include "core/model/triangle_tree.h"

namespace aomd::fields {

/// A cell of the original and how much of it counts.
struct CellPart {
  std::uint32_t cell = no_index;
  double amount = 0;
};

/// Finds the parts of cells of one dimension.
class CellParts {
 public:
  virtual ~CellParts() = default;
  /// Appends what cell `i` of the result covers of cells of its own class; the nearest one alone
  /// where that is nothing. Safe from several threads.
  virtual void of(std::uint32_t i, std::vector<CellPart>& parts) const = 0;
};

/// Tetrahedra: the volumes that both have in common.
class TetParts final : public CellParts {
 public:
  TetParts(const Cells& original, const TetTree& tree, const Cells& result)
      : original_(original), tree_(tree), result_(result) {}
  void of(std::uint32_t i, std::vector<CellPart>& parts) const override;

 private:
  const Cells& original_;
  const TetTree& tree_;
  const Cells& result_;
};

/// The faces of a surface: the original's at 16 points of each, on its own side.
class FaceParts final : public CellParts {
 public:
  FaceParts(const SurfacePairing& pairing, const Cells& result)
      : pairing_(pairing), result_(result) {}
  void of(std::uint32_t i, std::vector<CellPart>& parts) const override;

 private:
  const SurfacePairing& pairing_;
  const Cells& result_;
};

/// Edges, and faces of volumes: 16 points of each and what they are nearest to.
class SideParts final : public CellParts {
 public:
  SideParts(const Cells& original, const Cells& result, int threads);
  void of(std::uint32_t i, std::vector<CellPart>& parts) const override;

 private:
  /// Cells of one class as triangles, those of edges with two corners in one place.
  struct Nearby {
    TriangleTree tree;
    std::vector<std::uint32_t> cells;  ///< the cell that each triangle is of
  };
  void add(ModelRef model, const std::vector<std::uint32_t>& cells, int threads);

  const Cells &original_, &result_;
  std::map<ModelRef, Nearby> nearby_;
};

}  // namespace aomd::fields
