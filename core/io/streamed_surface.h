#pragma once
// A surface in a file that need not fit into memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/error.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io {

/// The triangles of a binary PLY file, gone through piece by piece as often as is wanted: a few MB
/// of it are in memory at a time. What a whole reader would refuse is refused, with the byte; so
/// are faces that are no triangles.
class StreamedSurface {
 public:
  /// Looks at the header. Throws ReadError where the file has not all that it promises, or has what
  /// cannot be gone through piece by piece: another format, text, lists beside the one of corners.
  explicit StreamedSurface(const std::filesystem::path& path);
  ~StreamedSurface();
  StreamedSurface(StreamedSurface&&) noexcept;
  StreamedSurface& operator=(StreamedSurface&&) noexcept;

  using Triangle = std::array<std::uint32_t, 3>;
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::uint32_t vertices() const;
  [[nodiscard]] std::uint32_t faces() const;
  /// Elements of the file beside vertices and faces, which are passed over.
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
  struct Layout;
  std::unique_ptr<const Layout> layout_;
};

}  // namespace aomd::io
