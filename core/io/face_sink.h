#pragma once
// Collects the faces of a file: checks them, and turns polygons into triangles once all positions
// are known.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// A face of more vertices is an error.
inline constexpr std::size_t max_polygon = 10'000;

/// What is wrong with a polygon (too few or many vertices, out of range, one of them twice), or an
/// empty string.
[[nodiscard]] std::string polygon_defect(std::span<const std::int64_t> polygon,
                                         std::uint64_t vertex_count, int first = 0);

/// The readers add every face here, in the order of the file, and call finish() once.
class FaceSink {
 public:
  /// Faces refer to vertices 0 .. vertex_count - 1; `first` is what the format's own count starts
  /// with (0 or 1), for messages.
  explicit FaceSink(std::uint64_t vertex_count, int first = 0)
      : vertex_count_(vertex_count), first_(first) {}

  /// Expects about n triangles.
  void reserve(std::size_t n);

  /// Adds one face of any number of vertices, 0-based. Returns what is wrong with it, or an empty
  /// string.
  [[nodiscard]] std::string add(std::span<const std::int64_t> polygon, ModelRef model = {});

  /// Splits the polygons, and hands the triangles over. Returns how many polygons there were.
  std::size_t finish(MeshData& mesh);

 private:
  struct Polygon {
    std::size_t triangle, start, size;
  };

  void push(std::uint32_t a, std::uint32_t b, std::uint32_t c, ModelRef model);

  std::uint64_t vertex_count_;
  int first_;
  EntityList faces_;
  std::vector<Polygon> polygons_;
  std::vector<std::uint32_t> corners_;  ///< of the polygons
};

/// What is wrong with an edge between two vertices, or an empty string.
[[nodiscard]] std::string edge_defect(std::int64_t a, std::int64_t b, std::uint64_t vertex_count,
                                      int first = 0);

/// Forgets classifications that classify nothing.
void drop_empty_classes(MeshData& mesh);

/// "12 polygons triangulated", where there were any.
void note_polygons(std::vector<std::string>& notes, std::size_t polygons);

}  // namespace aomd::io::detail
