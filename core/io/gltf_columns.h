#pragma once
// Arrays of a glTF file, collected over all primitives.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "core/io/face_sink.h"
#include "core/io/gltf_accessors.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// The names by which a glTF file and a mesh call one vertex by its number, where its place does
/// not tell it apart.
inline constexpr const char* gltf_vertex = "_AOMD_VERTEX";

/// What primitives say of vertices. A use is a vertex of the file in one primitive; several may
/// come from one vertex of the mesh, where values jump.
class GltfColumns {
 public:
  /// As many uses follow, of these vertices of the mesh.
  void begin(std::vector<std::uint32_t> vertices);
  /// What rows of these numbers say of the uses that began last; normals turn by `turn`.
  void add(const std::string& semantic, const GltfNumbers& numbers,
           const std::vector<std::uint32_t>& rows, const glm::dmat3& turn);
  [[nodiscard]] std::uint32_t first_use() const { return first_; }

  /// Makes arrays of them: on vertices where all uses of each vertex agree, else on corners of
  /// faces, which come from corners of the file, which are these uses.
  void finish(MeshData& mesh, const std::vector<std::uint32_t>& use_of_corner,
              const std::vector<FaceOrigin>& origins);

 private:
  void fill(Attribute& array) const;
  [[nodiscard]] bool spread_to_vertices(Attribute& array, std::size_t vertices) const;

  std::vector<std::uint32_t> vertex_of_use_;
  std::uint32_t first_ = 0;
  std::map<std::string, Attribute> columns_;  ///< by semantic, components and type
};

}  // namespace aomd::io::detail
