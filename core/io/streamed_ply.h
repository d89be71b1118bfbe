#pragma once
// A surface in one binary PLY file that need not fit into memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/ply_header.h"

namespace aomd::io::detail {

/// Its triangles, gone through in pieces of a MB. What a whole reader would refuse is refused, with
/// the byte; so is what has no records of one size: text, lists beside that of three corners.
class StreamedPly {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Looks at the header. Throws ReadError and LimitError.
  explicit StreamedPly(const std::filesystem::path& path);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint32_t vertices() const { return count_of(vertices_); }
  [[nodiscard]] std::uint32_t faces() const { return count_of(faces_); }
  /// Elements beside vertices and faces, and what these are classified on.
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }
  /// Whether records of this file could stand in the other one.
  [[nodiscard]] bool has_records_of(const StreamedPly& other) const;

  /// Calls visit(positions, records) for pieces of the vertices, and visit(triangles, records) for
  /// pieces of the faces, in the order of the file. Throws ReadError for a coordinate that is not
  /// finite, a corner that does not exist, a face that is no triangle, and where the file has
  /// become shorter.
  void each_vertices(
      const std::function<void(std::span<const glm::dvec3>, std::string_view)>& visit) const;
  void each_faces(
      const std::function<void(std::span<const Triangle>, std::string_view)>& visit) const;
  /// One of some records that one of these has handed over.
  [[nodiscard]] std::string_view vertex_record(std::string_view records, std::size_t i) const {
    return records.substr(i * vertices_.size, vertices_.size);
  }
  [[nodiscard]] std::string_view face_record(std::string_view records, std::size_t i) const {
    return records.substr(i * faces_.size, faces_.size);
  }

  /// A file of the same kind with these records, whose faces have these corners instead of theirs.
  [[nodiscard]] std::string file_of(const std::string& vertex_records, std::string face_records,
                                    const std::vector<Triangle>& corners) const;

 private:
  /// The records of one element.
  struct Records {
    PlyElement element;
    std::uint64_t begin = 0;  ///< offset in the file
    std::size_t size = 0;     ///< bytes of one: a face has three corners
  };

  void take(const PlyHeader& header, std::uint64_t file_size);
  [[nodiscard]] std::size_t record_size(const PlyElement& element) const;
  void name_what_is_left_out(const PlyElement& element);
  [[nodiscard]] std::string header_for(std::size_t vertex_count, std::size_t face_count) const;
  void put_corners(std::string& records, const std::vector<Triangle>& corners) const;
  [[nodiscard]] static std::uint32_t count_of(const Records& records) {
    return static_cast<std::uint32_t>(records.element.count);
  }

  template <typename Visit>
  void pieces(const Records& records, const Visit& visit) const;
  template <std::endian Order, typename Visit>
  void vertices_in(const Source& piece, std::size_t count, const Visit& visit) const;
  template <std::endian Order, typename Visit>
  void faces_in(const Source& piece, std::size_t count, const Visit& visit) const;

  std::filesystem::path path_;
  std::string name_;
  PlyEncoding encoding_ = PlyEncoding::LittleEndian;
  Records vertices_, faces_;
  std::string header_;
  std::vector<int> axes_;  ///< of the properties of vertices
  std::vector<std::string> left_out_;
};

}  // namespace aomd::io::detail
