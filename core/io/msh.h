#pragma once
// What the readers and writers of Gmsh's MSH formats share: element types, header and boxes of
// model entities.

#include <bit>
#include <cstdint>
#include <optional>
#include <span>

#include "core/io/source.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// One of Gmsh's element types. Its first nodes are the corners, in the order of our templates; an
/// element of higher order has more.
struct MshType {
  Shape shape = Shape::Point;
  int nodes = 0;
};

/// The most nodes of a type that msh_type() knows.
inline constexpr std::size_t max_msh_nodes = 125;

/// The type of this number; nothing where it is not one that we read. Source: Gmsh reference
/// manual, "MSH file format"; for orders 3 and 4 what Gmsh 4.8 itself says.
[[nodiscard]] std::optional<MshType> msh_type(std::int64_t number);
/// Whether one of the types of a shape has so many nodes.
[[nodiscard]] bool msh_has_nodes(Shape shape, std::int64_t nodes);
/// The number of the first-order type of a shape. Throws WriteError for a shape that a program
/// added.
[[nodiscard]] int msh_number(Shape shape);

/// Versions 2.0 to 2.2 are one.
enum class MshVersion : std::uint8_t { V1, V2, V40, V41 };

/// What $MeshFormat says. Version 1 has no header: it starts with $NOD.
struct MshHeader {
  MshVersion version = MshVersion::V41;
  bool binary = false;
  std::endian order = std::endian::native;  ///< of the numbers, where binary
  std::size_t end = 0;                      ///< offset of the first section after it
};

/// Throws ReadError for other versions, and for sizes that no 64-bit Gmsh writes.
[[nodiscard]] MshHeader read_msh_header(const Source& source);

/// Sets the box of each entity to that of the vertices that lie on it, and of the vertices of the
/// elements that do. Cost: the size of the mesh, times the logarithm of the number of entities.
void set_boxes(const MeshData& mesh, std::span<ModelEntity> entities);

}  // namespace aomd::io::detail
