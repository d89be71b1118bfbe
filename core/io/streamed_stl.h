#pragma once
// A surface in one binary STL file that need not fit into memory.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/facet_corners.h"
#include "core/io/record_layout.h"
#include "core/io/streamed_file.h"

namespace aomd::io::detail {

/// Facets have no vertices in common: corners at the same place become one, with the numbers that
/// the whole reader gives them. Which vertex each corner is takes 12 bytes a facet, in memory.
class StreamedStl final : public StreamedFile {
 public:
  /// Goes through the file, up to 18 times. Throws ReadError and LimitError.
  explicit StreamedStl(const std::filesystem::path& path);

  /// Whether the size is what the count in the header promises.
  [[nodiscard]] static bool is_binary(std::string_view head, std::uint64_t file_size);

  [[nodiscard]] std::uint32_t vertices() const override { return corners_.vertices(); }
  [[nodiscard]] std::uint32_t faces() const override { return facets_; }
  [[nodiscard]] std::string kind_of_records() const override;
  void each_vertices(const VisitVertices& visit) const override;
  void each_faces(const VisitFaces& visit) const override;
  [[nodiscard]] MeshData mesh_of(const std::string& vertex_records, std::string face_records,
                                 const std::vector<Triangle>& corners) const override;

 private:
  [[nodiscard]] std::size_t vertex_size() const override { return layout_.vertex_size(); }
  [[nodiscard]] std::size_t face_size() const override { return layout_.face_size(); }
  void take_header(std::uint64_t file_size);
  void look_at_marks();
  void each_facets(const VisitPiece& visit) const;
  [[nodiscard]] Triangle facet(std::size_t i) const {
    return {corners_[3 * i], corners_[3 * i + 1], corners_[3 * i + 2]};
  }
  void put_mark(std::uint16_t mark, std::string& records) const;

  std::uint32_t facets_ = 0;
  bool magics_ = false;  ///< colours have the order of Magics
  FacetCorners corners_;
  RecordLayout layout_;
};

}  // namespace aomd::io::detail
