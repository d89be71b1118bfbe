#pragma once
// How the scalar properties of PLY files make up arrays, and what properties arrays become.

#include <string>
#include <vector>

#include "core/io/ply_header.h"
#include "core/mesh/mesh_data.h"

namespace aomd::io::detail {

/// An array, still without values, and the properties of the file that are its components: those
/// from number `first` on.
struct PlyGroup {
  Attribute array;
  std::size_t first = 0;
};

/// The arrays of an element on entities of a dimension: of neighbouring properties of one type the
/// known ones together (nx ny nz; red green blue alpha; s t; ...), and NAME_0 NAME_1 ... ; every
/// other one by itself. `free` says which properties are to be looked at.
[[nodiscard]] std::vector<PlyGroup> arrays_of(const PlyElement& element, int dimension,
                                              const std::vector<bool>& free);

/// An array of the mesh and the names of its properties.
struct PlyColumns {
  const Attribute* array = nullptr;
  std::vector<std::string> names;
  NumberType type = NumberType::Float64;
};

/// What the arrays on entities of a dimension become: arrays_of() turned round. Names are made such
/// that each is one word and there once.
[[nodiscard]] std::vector<PlyColumns> columns_of(const MeshData& mesh, int dimension);

}  // namespace aomd::io::detail
