#pragma once
// A surface in one file that need not fit into memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/source.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// Its vertices and triangles, gone through in pieces of a MB. Each has a record: the bytes of what
/// the file says of it, all of one size. What a whole reader would refuse is refused.
class StreamedFile {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  StreamedFile(const StreamedFile&) = delete;
  StreamedFile& operator=(const StreamedFile&) = delete;
  virtual ~StreamedFile() = default;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] virtual std::uint32_t vertices() const = 0;
  [[nodiscard]] virtual std::uint32_t faces() const = 0;
  /// What there is beside vertices, faces and arrays, and what these are classified on.
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }
  /// Records of files that say the same here may stand in each other's place.
  [[nodiscard]] virtual std::string kind_of_records() const = 0;

  /// Calls visit(positions, records) for pieces of the vertices, and visit(triangles, records) for
  /// pieces of the faces, in the order of the file. Throws ReadError for a coordinate that is not
  /// finite, a corner that does not exist, a face that is no triangle, and where the file has
  /// become shorter.
  using VisitVertices = std::function<void(std::span<const glm::dvec3>, std::string_view)>;
  using VisitFaces = std::function<void(std::span<const Triangle>, std::string_view)>;
  virtual void each_vertices(const VisitVertices& visit) const = 0;
  virtual void each_faces(const VisitFaces& visit) const = 0;
  /// One of some records that one of these has handed over.
  [[nodiscard]] std::string_view vertex_record(std::string_view records, std::size_t i) const {
    return records.substr(i * vertex_size(), vertex_size());
  }
  [[nodiscard]] std::string_view face_record(std::string_view records, std::size_t i) const {
    return records.substr(i * face_size(), face_size());
  }

  /// A mesh of these records, whose faces have these corners.
  [[nodiscard]] virtual MeshData mesh_of(const std::string& vertex_records,
                                         std::string face_records,
                                         const std::vector<Triangle>& corners) const = 0;

 protected:
  explicit StreamedFile(const std::filesystem::path& path) : path_(path), name_(path.string()) {}

  /// Bytes of a record.
  [[nodiscard]] virtual std::size_t vertex_size() const = 0;
  [[nodiscard]] virtual std::size_t face_size() const = 0;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void leave_out(std::string what) { left_out_.push_back(std::move(what)); }
  /// "FILE: WHAT cannot be read in blocks, only as a whole", and what helps.
  [[noreturn]] void refuse(const std::string& what) const;

  /// The bytes of `count` records from one byte of the file on, piece by piece: with the place in
  /// the file, and the number of records.
  using VisitPiece = std::function<void(const Source&, std::size_t count)>;
  void each_piece(std::uint64_t begin, std::size_t size, std::uint64_t count,
                  const VisitPiece& visit) const;

 private:
  std::filesystem::path path_;
  std::string name_;
  std::vector<std::string> left_out_;
};

using StreamedFiles = std::vector<std::unique_ptr<const StreamedFile>>;

/// By what it holds: PLY, STL or VTU, of bytes. Throws ReadError and LimitError.
[[nodiscard]] std::unique_ptr<const StreamedFile> open_streamed(const std::filesystem::path& path);

}  // namespace aomd::io::detail
