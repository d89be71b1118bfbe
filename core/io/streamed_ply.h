#pragma once
// A surface in one binary PLY file that need not fit into memory.

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/io/ply_header.h"
#include "core/io/streamed_file.h"

namespace aomd::io::detail {

/// What has no records of one size is refused: text, lists beside that of three corners.
class StreamedPly final : public StreamedFile {
 public:
  /// Looks at the header. Throws ReadError and LimitError.
  explicit StreamedPly(const std::filesystem::path& path);

  [[nodiscard]] std::uint32_t vertices() const override { return count_of(vertices_); }
  [[nodiscard]] std::uint32_t faces() const override { return count_of(faces_); }
  [[nodiscard]] std::string kind_of_records() const override;
  void each_vertices(const VisitVertices& visit) const override;
  void each_faces(const VisitFaces& visit) const override;
  /// As a small file of the same kind, which the whole reader reads.
  [[nodiscard]] MeshData mesh_of(const std::string& vertex_records, std::string face_records,
                                 const std::vector<Triangle>& corners) const override;

 private:
  /// The records of one element.
  struct Records {
    PlyElement element;
    std::uint64_t begin = 0;  ///< offset in the file
    std::size_t size = 0;     ///< bytes of one: a face has three corners
  };

  [[nodiscard]] std::size_t vertex_size() const override { return vertices_.size; }
  [[nodiscard]] std::size_t face_size() const override { return faces_.size; }
  void take(const PlyHeader& header, std::uint64_t file_size);
  [[nodiscard]] std::size_t record_size(const PlyElement& element) const;
  void name_what_is_left_out(const PlyElement& element);
  [[nodiscard]] std::string header_for(std::size_t vertex_count, std::size_t face_count) const;
  void put_corners(std::string& records, const std::vector<Triangle>& corners) const;
  [[nodiscard]] static std::uint32_t count_of(const Records& records) {
    return static_cast<std::uint32_t>(records.element.count);
  }

  template <std::endian Order, typename Visit>
  void vertices_in(const Source& piece, std::size_t count, const Visit& visit) const;
  template <std::endian Order, typename Visit>
  void faces_in(const Source& piece, std::size_t count, const Visit& visit) const;

  PlyEncoding encoding_ = PlyEncoding::LittleEndian;
  Records vertices_, faces_;
  std::string header_;
  std::vector<int> axes_;  ///< of the properties of vertices
};

}  // namespace aomd::io::detail
