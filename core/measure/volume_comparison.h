#pragma once
// What a coarser volume mesh has kept of its original: volumes, interfaces, model edges and
// vertices.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/measure/distance.h"
#include "core/measure/volume_complex.h"
#include "core/measure/volume_curves.h"

namespace aomd::measure {

/// A mesh with what comparing it needs; the mesh must outlive it.
struct Volume {
  explicit Volume(const Mesh& m, int threads = 1) : mesh(m), complex(analyse_volume(m, threads)) {}

  const Mesh& mesh;
  VolumeComplex complex;

  /// The faces of its skin as a mesh of their own, in their order.
  [[nodiscard]] Mesh skin() const;
  /// The box around what its regions use.
  [[nodiscard]] Box box() const;
  /// Whether it lists faces of the skin on model faces, or edges on model edges.
  [[nodiscard]] bool lists_faces() const;
  [[nodiscard]] bool lists_edges() const;
};

/// One model region in both meshes, as far as they have it.
struct RegionChange {
  std::optional<RegionFacts> before, after;

  [[nodiscard]] ModelRef model() const { return before ? before->model : after->model; }
  /// In percent of the volume before; infinite where that was none, -100 where the region is lost.
  [[nodiscard]] double volume_percent() const;
  /// Whether both have it with one Euler number and as many parts.
  [[nodiscard]] bool kept() const;
};

/// What a surface is by itself.
struct SurfaceFacts {
  std::size_t faces = 0;
  double area = 0;
  std::int64_t euler = 0;  ///< vertices - edges + faces
};

/// Distances between the points of two sets, both ways.
struct SetDistance {
  double rms = 0, max = 0;
};

/// One interface in both meshes. Distances are between its own faces: another interface near by is
/// none of it. They are zero where one mesh lacks it.
struct InterfaceChange {
  Interface on;
  std::optional<SurfaceFacts> before, after;
  Distance to_result, to_original;

  [[nodiscard]] bool measured() const { return before && after; }
  [[nodiscard]] bool kept() const { return measured() && before->euler == after->euler; }
  /// The mean of the squares is over the areas of both.
  [[nodiscard]] SetDistance distance() const;
};

/// The same over several interfaces. None where none is in both.
[[nodiscard]] std::optional<SetDistance> distance_over(std::span<const InterfaceChange> list,
                                                       bool boundary);

/// Model edges, both sets as a whole.
struct CurveChange {
  std::size_t edges_before = 0, edges_after = 0;
  double length_before = 0, length_after = 0;
  SetDistance to_result, to_original;
  SetDistance both;  ///< the mean of the squares over both lengths
};

/// Model vertices of the original, and whether a vertex of the result lies there.
struct ModelVertexChange {
  std::size_t before = 0, after = 0;
  std::size_t kept = 0;      ///< within a millionth of the diagonal
  std::size_t near = 0;      ///< within a thousandth
  std::vector<Vertex> lost;  ///< of the original: not kept
};

struct VolumeComparison {
  double diagonal = 0;  ///< of the box around the original
  std::vector<RegionChange> regions;
  std::vector<InterfaceChange> interfaces;   ///< by pairs of model regions
  std::vector<InterfaceChange> model_faces;  ///< by model face too; empty unless both list some
  CurveChange curves;
  ModelVertexChange vertices;

  /// The finest that both meshes tell apart.
  [[nodiscard]] const std::vector<InterfaceChange>& surfaces() const {
    return model_faces.empty() ? interfaces : model_faces;
  }
};

/// About `samples` points are spread over the interfaces of each mesh by area, at least as many on
/// each as it has faces, and once more over model faces; model edges are measured at every
/// 2000th of the diagonal. Model regions are the same where their tags are. Equal input, equal
/// result, for any number of threads. About a microsecond a point.
[[nodiscard]] VolumeComparison compare_volumes(const Volume& original, const Volume& result,
                                               std::size_t samples, int threads = 1);

}  // namespace aomd::measure
