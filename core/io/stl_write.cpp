// STL: binary without classes, text with a solid for each.

#include <array>
#include <map>

#include <glm/geometric.hpp>

#include "core/io/byte_writer.h"
#include "core/io/class_names.h"
#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/polygon.h"
#include "core/io/stl_marks.h"

namespace aomd::io::detail {
namespace {

using Facet = std::array<glm::dvec3, 3>;

/// The faces as triangles, each with the number of its face; quads and the like are split.
template <class Use>
void for_each_facet(const MeshData& mesh, Use&& use) {
  std::vector<std::uint32_t> t;
  std::size_t face = 0;
  for_each_entity(mesh.faces, [&](auto corners, ModelRef model) {
    t.clear();
    triangulate(mesh.positions, corners, t);
    for (std::size_t i = 0; i < t.size(); i += 3) {
      use(Facet{mesh.positions[t[i]], mesh.positions[t[i + 1]], mesh.positions[t[i + 2]]}, model,
          face);
    }
    ++face;
  });
}

glm::dvec3 normal_of(const Facet& f) {
  const glm::dvec3 n = glm::cross(f[1] - f[0], f[2] - f[0]);
  const double length = glm::length(n);
  return length > 0 ? n / length : glm::dvec3(0);
}

/// The attribute of a facet: the one that a file had, or the colour of its face.
std::uint16_t mark_of(const StlArrays& arrays, std::size_t face) {
  if (arrays.marks) return nearest_whole<std::uint16_t>(arrays.marks->values[face]);
  if (!arrays.colours) return 0;
  const Attribute& a = *arrays.colours;
  const double* const c = a.values.data() + static_cast<std::size_t>(a.components) * face;
  const double full = full_colour(a);
  return stl_coloured({c[0] / full, c[1] / full, c[2] / full});
}

std::string write_binary(const MeshData& mesh) {
  ByteWriter out;
  std::uint32_t n = 0;
  for_each_facet(mesh, [&](const Facet&, ModelRef, std::size_t) { ++n; });
  out.reserve(data_start + facet_size * n);
  // Not "solid": some readers take that for text.
  std::string header = "AOMD Studio binary STL";
  header.resize(header_size, ' ');
  out << header;
  const auto point = [&](const glm::dvec3& p) {
    for (int axis = 0; axis < 3; ++axis) out.raw<std::endian::little>(static_cast<float>(p[axis]));
  };
  out.raw<std::endian::little>(n);
  const StlArrays arrays = stl_arrays(mesh);
  for_each_facet(mesh, [&](const Facet& f, ModelRef, std::size_t face) {
    point(normal_of(f));
    for (const glm::dvec3& p : f) point(p);
    out.raw<std::endian::little>(mark_of(arrays, face));
  });
  return out.take();
}

void write_facet(ByteWriter& out, const Facet& f) {
  const auto point = [&](const glm::dvec3& p) {
    out << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
  };
  out << "facet normal";
  const glm::dvec3 n = normal_of(f);
  out << ' ' << static_cast<float>(n.x) << ' ' << static_cast<float>(n.y) << ' '
      << static_cast<float>(n.z) << '\n';
  out << "outer loop\n";
  for (const glm::dvec3& p : f) {
    out << "vertex";
    point(p);
  }
  out << "endloop\nendfacet\n";
}

/// Of a mesh that is one solid.
std::string only_name(const MeshData& mesh) {
  for (const Remark& remark : mesh.remarks)
    if (remark.keyword == stl_solid) return remark.text;
  return stl_usual_name;
}

}  // namespace

std::string write_stl(const MeshData& mesh, bool binary) {
  if (binary) return write_binary(mesh);
  const Attribute* const names = stl_arrays(mesh).solids;
  std::map<ModelRef, ByteWriter> solids;
  std::map<ModelRef, std::string> name_of_solid;
  for_each_facet(mesh, [&](const Facet& f, ModelRef model, std::size_t face) {
    const ModelRef solid =
        names ? ModelRef(2, static_cast<std::int32_t>(names->values[face])) : model;
    write_facet(solids[solid], f);
    if (names) name_of_solid[solid] = name_of(*names, face);
  });
  if (solids.empty()) solids[ModelRef()];
  ByteWriter out;
  for (auto& [model, facets] : solids) {
    const std::string name = names                        ? name_of_solid[model]
                             : mesh.faces.classes.empty() ? only_name(mesh)
                                                          : class_name(model);
    out << "solid " << name << '\n' << facets.take() << "endsolid " << name << '\n';
  }
  return out.take();
}

}  // namespace aomd::io::detail
