#pragma once
// A surface in one VTU file that need not fit into memory.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "core/io/record_layout.h"
#include "core/io/streamed_file.h"
#include "core/io/vtu_column.h"
#include "core/io/vtu_skeleton.h"

namespace aomd::io::detail {

/// One piece of triangles, whose arrays are bytes: raw or base64, appended or in their elements,
/// compressed by zlib or not. Text is refused. It may have neither points nor cells.
class StreamedVtu final : public StreamedFile {
 public:
  /// Looks at the elements, and at how long the arrays are. Throws ReadError and LimitError.
  explicit StreamedVtu(const std::filesystem::path& path);

  [[nodiscard]] std::uint32_t vertices() const override { return points_; }
  [[nodiscard]] std::uint32_t faces() const override { return cells_; }
  [[nodiscard]] std::string kind_of_records() const override;
  void each_vertices(const VisitVertices& visit) const override;
  void each_faces(const VisitFaces& visit) const override;
  [[nodiscard]] MeshData mesh_of(const std::string& vertex_records, std::string face_records,
                                 const std::vector<Triangle>& corners) const override;

 private:
  /// An array of the file.
  struct Column {
    RecordArray array;
    VtuPlace place;
  };
  class Rows;

  [[nodiscard]] std::size_t vertex_size() const override { return layout_.vertex_size(); }
  [[nodiscard]] std::size_t face_size() const override { return layout_.face_size(); }
  [[noreturn]] void fail(const std::string& what) const;
  void take_root(const pugi::xml_node& root);
  void take_piece(const VtuSkeleton& skeleton, const pugi::xml_node& piece);
  void take_data(const VtuSkeleton& skeleton, const pugi::xml_node& data, const char* of,
                 std::uint64_t count, std::vector<Column>& columns,
                 std::vector<RecordArray>& arrays);
  [[nodiscard]] std::uint32_t count_in(const pugi::xml_node& piece, const char* name) const;
  /// An array of `count` tuples, of as many components, or of what it says where 0 is given.
  [[nodiscard]] Column column(const VtuSkeleton& skeleton, const pugi::xml_node& node,
                              std::uint64_t count, int components) const;
  [[nodiscard]] Column cells_column(const VtuSkeleton& skeleton, const pugi::xml_node& piece,
                                    const char* name, std::uint64_t count) const;
  [[nodiscard]] VtuPlace place_of(const VtuSkeleton& skeleton, const pugi::xml_node& node) const;
  [[nodiscard]] VtuColumn open(const Column& column) const;
  void check_cells(std::uint64_t first, const std::vector<std::int64_t>& ends,
                   const std::vector<std::int64_t>& types) const;

  VtuPacking packing_;
  std::uint32_t points_ = 0, cells_ = 0;
  std::vector<Column> of_points_;  ///< the coordinates, and the arrays
  Column connectivity_, ends_, types_;
  std::vector<Column> of_cells_;  ///< arrays alone
  RecordLayout layout_;
};

}  // namespace aomd::io::detail
