#include "viewer/drawing/surface_texture.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/vec4.hpp>

#include "core/io/named_faces.h"
#include "core/io/picture.h"
#include "core/io/picture_files.h"

namespace aomd::scene {
namespace {

using io::detail::find_named;

/// Two numbers or more at each corner: the first array of texture coordinates that there is.
struct Places {
  const Attribute* array = nullptr;
  bool on_corners = false;
};

Places places_of(const MeshData& data) {
  const auto fits = [](const Attribute& a) {
    return a.meaning == Meaning::Texture && a.components >= 2;
  };
  const auto corners = std::find_if(data.corners.begin(), data.corners.end(), fits);
  if (corners != data.corners.end()) return {&*corners, true};
  for (const Attribute& a : data.attributes)
    if (fits(a) && a.dimension == 0) return {&a, false};
  return {};
}

Color shade(const std::array<double, 4>& colour) {
  return pack_color(glm::vec4(colour[0], colour[1], colour[2], 1));
}

/// Which material each face has, by its label; without one all have the only one.
class Materials {
 public:
  explicit Materials(const MeshData& data)
      : looks_(data.appearance), label_(find_named(data, io::detail::obj_material)) {
    for (const Material& m : looks_.materials) by_name_.try_emplace(m.name, &m);
  }

  [[nodiscard]] const Material* of(std::size_t face) const {
    if (!label_) return looks_.materials.size() == 1 ? looks_.materials.data() : nullptr;
    const auto found = by_name_.find(io::detail::name_of(*label_, face));
    return found == by_name_.end() ? nullptr : found->second;
  }

 private:
  const Appearance& looks_;
  const Attribute* label_;
  std::map<std::string, const Material*> by_name_;
};

}  // namespace

Pictures read_pictures(const Appearance& looks) {
  Pictures pictures;
  for (const Picture& picture : looks.pictures) {
    pictures.images.emplace_back();
    const auto bytes = io::detail::picture_bytes(looks, picture);
    if (!bytes) {
      pictures.notes.push_back("the picture " + shown(picture.name) + " is not there");
      continue;
    }
    try {
      pictures.images.back() = io::decode_picture(picture.name, *bytes);
    } catch (const io::FileError& error) {
      pictures.notes.push_back("the picture " + std::string(error.what()));
    }
  }
  return pictures;
}

bool has_looks(const Appearance& looks) { return !looks.materials.empty(); }

std::vector<PaintedFace> painted_faces(const MeshData& data) {
  std::vector<PaintedFace> faces(data.faces.size());
  const Places places = places_of(data);
  const Materials materials(data);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Material* const material = materials.of(f);
    if (!material) continue;
    faces[f].color = shade(material->colour);
    if (material->picture >= data.appearance.pictures.size() || !places.array) continue;
    const auto n = static_cast<std::size_t>(places.array->components);
    bool known = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = places.on_corners ? 3 * f + k : data.faces.vertices[3 * f + k];
      const double* const at = &places.array->values[n * i];
      faces[f].at[k] = glm::vec2(at[0], at[1]);
      known = known && std::isfinite(at[0]) && std::isfinite(at[1]);
    }
    if (known) faces[f].picture = static_cast<std::uint16_t>(material->picture + 1);
  }
  return faces;
}

}  // namespace aomd::scene
