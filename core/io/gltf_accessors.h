#pragma once
// The numbers of glTF accessors.

#include <cstdint>
#include <vector>

#include "core/io/gltf_file.h"
#include "core/mesh/number_type.h"

namespace aomd::io::detail {

/// The numbers of one accessor, row by row, as its file stores them.
struct GltfNumbers {
  int components = 1;
  NumberType type = NumberType::Float32;
  bool normalized = false;  ///< whole numbers stand for 0 to 1, or -1 to 1
  std::vector<double> values;

  [[nodiscard]] std::size_t size() const {
    return values.size() / static_cast<std::size_t>(components);
  }
};

/// Reads an accessor, sparse ones too. Throws ReadError where it is not there, of no known type or
/// goes beyond its buffer; sizes are checked before memory is taken.
[[nodiscard]] GltfNumbers read_accessor(const GltfFile& file, int index);

/// The same where it lists vertices.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfFile& file, int index);

/// Normalized whole numbers as the 32-bit floats that they stand for.
void use_floats(GltfNumbers& numbers);

/// Of glTF: 5126 for 32-bit floats and so on.
[[nodiscard]] int gltf_component(NumberType type);
/// "SCALAR" and so on by the number of components; 0 where there is no such type.
[[nodiscard]] int gltf_type(int components);

}  // namespace aomd::io::detail
