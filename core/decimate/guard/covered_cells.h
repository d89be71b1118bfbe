#pragma once
// What an original has, and the cells of the mesh as it is now that it is near.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

namespace aomd {

/// A face, or an edge as a triangle (a, b, b), on a model entity.
struct ModelCell {
  std::uint32_t id = no_index;
  ModelRef model;
  Triangle corners;
};

/// The cells of an original on model entities of one dimension, and for each of them cells of the
/// present mesh, on the same model entity, that together all its points are near. Where no single
/// one will do, the original cell is cut into parts that are near one each: as what is near a cell
/// is convex, the corners of a part speak for all its points.
class CoveredCells {
 public:
  /// Each stands for itself. About 200 bytes a cell.
  CoveredCells(const std::vector<ModelCell>& originals, double distance);
  /// The mesh was changed from outside: these are its cells. O(n log n).
  void attach(std::span<const ModelCell> cells);

  /// The distance of a point of what the replaced cells stand for where no cell comes within the
  /// distance of it, nor as close as those that were near it; 0 where there is none. Where it
  /// cannot tell (of parts shorter than 1/16 of the distance, or too many of them), of a point that
  /// is nearly so. `cells` are all that take the place of the replaced ones or touch it.
  [[nodiscard]] double uncovered(std::span<const std::uint32_t> replaced,
                                 std::span<const ModelCell> cells);
  /// What the replaced cells stand for gets the nearest of these.
  void hand_over(std::span<const std::uint32_t> replaced, std::span<const ModelCell> cells);

 private:
  struct Original {
    Triangle corners;
    ModelRef model;
    std::uint32_t near = no_index;  ///< links to cells
    std::uint32_t stamp = 0;
    double distance2 = 0;  ///< to those cells, of the furthest corner of a part
  };
  struct Cell {
    Triangle corners;
    std::uint32_t stands_for = no_index;  ///< links to originals, and to some that it stood for
  };
  struct Link {
    std::uint32_t to, next;
  };
  /// A cell that parts of an original may be near.
  struct Candidate {
    std::uint32_t id;
    const Triangle* corners;
    Box box;
    bool linked = false;  ///< it has a link to the original already
  };
  struct Nearest {
    const Candidate* cell = nullptr;
    double of_centre2 = std::numeric_limits<double>::infinity(),
           of_part2 = std::numeric_limits<double>::infinity();  ///< of its furthest corner
  };

  void put(const ModelCell& cell);
  void link(std::uint32_t& first, std::uint32_t to);
  void unlink(std::uint32_t& first);
  void join(std::uint32_t original, const Candidate& cell, double distance2);
  void gather(std::span<const std::uint32_t> replaced);
  void choose(ModelRef model, std::span<const ModelCell> cells);
  void choose(const Original& original, std::span<const std::uint32_t> replaced,
              std::span<const ModelCell> cells);
  [[nodiscard]] Nearest nearest(const Triangle& part, double most2, std::size_t hint) const;
  [[nodiscard]] double furthest2(const Triangle& part) const;
  [[nodiscard]] double reach2(const Original& original) const;
  [[nodiscard]] bool laid_over(const Triangle& original, double most2);
  template <typename Find, typename Take>
  void cover(const Triangle& original, double most2, const Find& find, const Take& take);

  double distance_;
  std::vector<Original> originals_;
  std::vector<Cell> cells_;  ///< by id
  std::vector<Link> links_;
  std::uint32_t free_ = no_index;  ///< links that are not in use
  std::uint32_t stamp_ = 0;
  std::vector<std::uint32_t> gathered_;  ///< originals
  std::vector<Candidate> candidates_;
  std::vector<Nearest> over_;
  std::size_t on_model_ = 0;  ///< of the candidates, those that are new or touch what is
  ModelRef model_;
  std::vector<Triangle> parts_;
};

}  // namespace aomd
