#pragma once
// A surface in a file that need not fit into memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/error.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io {

/// The triangles of a binary PLY, STL or VTU file, of a folder of them, or of what a .pvtu names,
/// gone through piece by piece as often as is wanted: a few MB are in memory at a time, and 12
/// bytes a facet of STL, whose corners are vertices where they are at the same place. Several files
/// are tiles, in the order of their names or of the list: vertices on borders of several of them at
/// the same place are one. What a whole reader would refuse is refused; so are faces that are no
/// triangles.
class StreamedSurface {
 public:
  /// How far apart border vertices of different tiles may be that are one.
  struct Weld {
    double tolerance = 0;      ///< in the units of the files
    bool of_diagonal = false;  ///< as a share of the diagonal of the box of all
  };

  /// Looks at the headers, and for borders of tiles. Throws ReadError where a file has not all that
  /// it promises, or has what cannot be gone through piece by piece: another format, text,
  /// lists beside the one of corners; and where tiles have different properties;
  /// LimitError where the tolerance holds dozens of border vertices around each.
  explicit StreamedSurface(const std::filesystem::path& path, const Weld& weld);
  explicit StreamedSurface(const std::filesystem::path& path) : StreamedSurface(path, Weld{}) {}
  ~StreamedSurface();
  StreamedSurface(StreamedSurface&&) noexcept;
  StreamedSurface& operator=(StreamedSurface&&) noexcept;

  using Triangle = std::array<std::uint32_t, 3>;
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::uint32_t vertices() const;
  [[nodiscard]] std::uint32_t faces() const;
  /// Elements of the first file beside vertices and faces, and what these are classified on, which
  /// are passed over.
  [[nodiscard]] std::vector<std::string> left_out() const;

  /// Calls visit(number of the first, positions) for all vertices, and the same for all faces, in
  /// the order of the file. Throws ReadError for a coordinate that is not finite, a corner that
  /// does not exist, a face that is no triangle, and where the file has become shorter.
  void each_vertices(
      const std::function<void(std::uint32_t, std::span<const glm::dvec3>)>& visit) const;
  void each_faces(const std::function<void(std::uint32_t, std::span<const Triangle>)>& visit) const;

  /// Some of the faces with their vertices, both in the order of the file, and the arrays on them.
  struct Part {
    MeshData mesh;
    std::vector<std::uint32_t> ids;  ///< by vertex: its number in the file
  };
  /// The faces that are wanted, which must have three corners. Once through faces and vertices; in
  /// memory are the records of the part twice, and one and a half bits a vertex of the file.
  [[nodiscard]] Part part(const std::function<bool(const Triangle&)>& wanted) const;

 private:
  struct Tiles;
  using VisitVertices =
      std::function<void(std::uint32_t, std::span<const glm::dvec3>, std::string_view)>;
  using VisitFaces =
      std::function<void(std::uint32_t, std::span<const Triangle>, std::string_view)>;
  void each_vertex_records(const VisitVertices& visit) const;
  void each_face_records(const VisitFaces& visit) const;

  std::unique_ptr<const Tiles> tiles_;
};

}  // namespace aomd::io
