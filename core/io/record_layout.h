#pragma once
// Records of vertices and faces, of numbers one after the other, as a mesh.

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// The numbers that an array has for each record.
struct RecordArray {
  std::string name;
  NumberType type = NumberType::Float32;
  int components = 1;
  Meaning meaning = Meaning::Any;

  [[nodiscard]] std::size_t size() const {
    return size_of(type) * static_cast<std::size_t>(components);
  }
};

/// A vertex has three coordinates and then its arrays; a face has its arrays alone.
struct RecordLayout {
  std::endian order = std::endian::little;
  NumberType coordinate = NumberType::Float32;
  std::vector<RecordArray> of_vertices, of_faces;

  [[nodiscard]] std::size_t vertex_size() const;
  [[nodiscard]] std::size_t face_size() const;
  [[nodiscard]] MeshData mesh_of(std::string_view vertices, std::string_view faces,
                                 const std::vector<std::array<std::uint32_t, 3>>& corners) const;
  /// Layouts that say the same are the same.
  [[nodiscard]] std::string text() const;
};

}  // namespace aomd::io::detail
