#pragma once
// Collects the faces of a file: checks them, and turns polygons into triangles once all positions
// are known.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/notes.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// A face of more vertices is an error.
inline constexpr std::size_t max_polygon = 10'000;

/// What is wrong with a polygon (too many vertices, or out of range), or an empty string. What
/// repeats and what is too short is no error: see trim_walk().
[[nodiscard]] std::string polygon_defect(std::span<const std::int64_t> polygon,
                                         std::uint64_t vertex_count, int first = 0);

/// Splits a polygon that trim_walk() has seen, and appends the triangles that have three different
/// corners: all of them unless the polygon passes a vertex twice, as one that bridges to its hole
/// does.
void triangles_of_walk(std::span<const glm::dvec3> positions,
                       std::span<const std::uint32_t> polygon, std::vector<std::uint32_t>& out);

/// What of a file a triangle comes from: the face, and the corners, counted over all faces.
struct FaceOrigin {
  std::uint32_t face = 0;
  std::array<std::uint32_t, 3> corners{};
};

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
  /// string. Repeated corners are cut out; a face that nothing is left of is dropped.
  [[nodiscard]] std::string add(std::span<const std::int64_t> polygon, ModelRef model = {});
  /// Adds one edge. Returns what is wrong with it, or an empty string; one from a vertex to itself
  /// is dropped.
  [[nodiscard]] std::string add_edge(std::int64_t a, std::int64_t b, ModelRef model = {});
  /// It is remembered where triangles, and edges, come from, for values that go with them: from the
  /// first one on, or not at all.
  void keep_origins() { keeps_origins_ = true; }
  void keep_edge_origins() { keeps_edge_origins_ = true; }
  /// After finish(): one for each face of the mesh; and for each edge, which of the file's it is.
  [[nodiscard]] const std::vector<FaceOrigin>& origins() const { return origins_; }
  [[nodiscard]] const std::vector<std::uint32_t>& edge_origins() const { return edge_origins_; }

  /// Counts faces and edges that the reader has dropped itself.
  void drop(std::size_t faces, std::size_t edges) {
    repeats_.faces += faces;
    repeats_.edges += edges;
  }

  /// Splits the polygons, hands triangles and edges over, and notes what had to be done.
  void finish(MeshData& mesh, std::vector<std::string>& notes);

 private:
  struct Polygon {
    std::size_t triangle, start, size;
  };

  [[nodiscard]] std::string add_any(std::span<const std::int64_t> polygon, ModelRef model);
  void push(std::uint32_t a, std::uint32_t b, std::uint32_t c, ModelRef model);
  void add_walk(std::span<const std::int64_t> polygon, ModelRef model);
  void keep_place(std::span<const std::int64_t> polygon, std::span<const std::int64_t> whole,
                  ModelRef model);
  void find_corners(const Polygon& polygon);
  void drop_empty_places();

  std::uint64_t vertex_count_;
  int first_;
  EntityList faces_, edges_;
  std::vector<Polygon> polygons_;
  std::vector<std::uint32_t> corners_;  ///< of the polygons
  std::vector<std::int64_t> walk_;
  bool keeps_origins_ = false, keeps_edge_origins_ = false;
  std::uint32_t file_faces_ = 0, file_corners_ = 0, file_edges_ = 0;
  std::vector<FaceOrigin> origins_;
  std::vector<std::uint32_t> edge_origins_;
  std::vector<std::uint32_t> places_;  ///< of `corners_` in the file, where origins are kept
  std::size_t bridged_ = 0;            ///< polygons that pass a vertex twice
  Repeats repeats_;
};

/// Values that a file lists by face become those of the triangles, or, by corner, of their corners.
void spread_to_faces(Attribute& array, const std::vector<FaceOrigin>& origins);
void spread_to_corners(Attribute& array, const std::vector<FaceOrigin>& origins);
/// The values of the entities from which others come, one each.
void take_values(Attribute& array, const std::vector<std::uint32_t>& from);

/// Forgets classifications that classify nothing.
void drop_empty_classes(MeshData& mesh);

/// "12 polygons triangulated", where there were any.
void note_polygons(std::vector<std::string>& notes, std::size_t polygons);

}  // namespace aomd::io::detail
