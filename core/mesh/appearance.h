#pragma once
// What faces look like: materials, and the pictures that they show.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#pragma GCC visibility push(default)

namespace aomd {

/// A picture that lies on faces by their texture coordinates, PNG or JPEG.
struct Picture {
  std::string name;  ///< of its file, from Appearance::folder on; of bytes whatever they are called
  std::string bytes;  ///< where the picture is part of the mesh's file
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// What faces look like whose label "material" has this name.
struct Material {
  static constexpr std::uint32_t no_picture = 0xffffffffu;

  std::string name;
  std::array<double, 4> colour{1, 1, 1, 1};  ///< red, green, blue, opacity; times the picture's
  std::uint32_t picture = no_picture;        ///< of Appearance::pictures
  double metallic = 0, roughness = 1;        ///< as glTF has them
  bool two_sided = false;
  friend bool operator==(const Material&, const Material&) = default;
};

/// Where there is one material and no label, all faces have it.
struct Appearance {
  std::vector<Material> materials;
  std::vector<Picture> pictures;
  std::string folder;  ///< of the mesh's file: names of other files start from there

  [[nodiscard]] bool empty() const { return materials.empty() && pictures.empty(); }
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

}  // namespace aomd

#pragma GCC visibility pop
