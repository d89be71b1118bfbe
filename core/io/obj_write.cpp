// Wavefront OBJ: vertices with their colours, texture coordinates and normals, faces by group,
// object, material and smoothing group.

#include <algorithm>
#include <cmath>

#include "core/io/byte_writer.h"
#include "core/io/class_names.h"
#include "core/io/corner_values.h"
#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

class ObjWriter {
 public:
  ObjWriter(const MeshData& mesh, const std::vector<std::string>& libraries)
      : mesh_(mesh),
        libraries_(libraries),
        arrays_(obj_arrays(mesh)),
        classes_(!mesh.faces.classes.empty() && !arrays_.names_classes) {}

  std::string write() {
    out_.reserve(48 * mesh_.positions.size() + 24 * mesh_.faces.size());
    out_ << "# AOMD Studio\n";
    for (const std::string& library : libraries_) out_ << "mtllib " << library << '\n';
    vertices();
    if (arrays_.texture) texture_ = values("vt", *arrays_.texture, arrays_.texture_on_corners);
    if (arrays_.normals) normals_ = values("vn", *arrays_.normals, arrays_.normals_on_corners);
    for_each_entity(mesh_.edges, [&](auto ends, ModelRef) {
      out_ << 'l';
      for (const std::uint32_t v : ends) out_ << ' ' << std::uint64_t{v} + 1;
      out_ << '\n';
    });
    for_each_entity(mesh_.faces, [&](auto corners, ModelRef model) { face(corners, model); });
    return out_.take();
  }

 private:
  void vertices() {
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const glm::dvec3& p = mesh_.positions[v];
      out_ << "v " << p.x << ' ' << p.y << ' ' << p.z;
      if (arrays_.colours) colour(*arrays_.colours, v);
      out_ << '\n';
    }
  }

  /// From 0 to 1; a vertex without has none.
  void colour(const Attribute& a, std::size_t v) {
    const auto n = static_cast<std::size_t>(a.components);
    const auto given = std::span(a.values).subspan(n * v, n);
    if (!std::all_of(given.begin(), given.end(), [](double x) { return std::isfinite(x); })) return;
    const double full = full_colour(a);
    for (const double x : given) out_ << ' ' << x / full;
  }

  IndexedValues values(std::string_view keyword, const Attribute& a, bool on_corners) {
    IndexedValues list = indexed(a, on_corners, mesh_);
    const auto n = static_cast<std::size_t>(list.components);
    for (std::size_t i = 0; i < list.numbers.size(); i += n) {
      out_ << keyword;
      for (std::size_t k = i; k < i + n; ++k) out_ << ' ' << list.numbers[k];
      out_ << '\n';
    }
    return list;
  }

  void face(std::span<const std::uint32_t> corners, ModelRef model) {
    if (classes_ && (face_ == 0 || model != group_)) out_ << "g " << class_name(model) << '\n';
    group_ = model;
    if (!classes_) name("g", arrays_.group);
    name("o", arrays_.object);
    name("usemtl", arrays_.material);
    if (const Attribute* const s = arrays_.smoothing; s && changes(*s))
      out_ << "s " << static_cast<std::int64_t>(s->values[face_]) << '\n';
    out_ << 'f';
    for (const std::uint32_t v : corners) corner(v);
    out_ << '\n';
    ++face_;
  }

  [[nodiscard]] bool changes(const Attribute& label) const {
    return face_ == 0 || label.values[face_] != label.values[face_ - 1];
  }
  void name(std::string_view keyword, const Attribute* label) {
    if (!label || !changes(*label) || (face_ == 0 && name_of(*label, 0).empty())) return;
    out_ << keyword << ' ' << name_of(*label, face_) << '\n';
  }

  void corner(std::uint32_t v) {
    out_ << ' ' << std::uint64_t{v} + 1;
    const std::uint32_t t = texture_.corners.empty() ? no_index : texture_.corners[corner_],
                        n = normals_.corners.empty() ? no_index : normals_.corners[corner_];
    ++corner_;
    if (t == no_index && n == no_index) return;
    out_ << '/';
    if (t != no_index) out_ << std::uint64_t{t} + 1;
    if (n != no_index) out_ << '/' << std::uint64_t{n} + 1;
  }

  const MeshData& mesh_;
  const std::vector<std::string>& libraries_;
  ObjArrays arrays_;
  bool classes_;  ///< groups say the classes
  IndexedValues texture_, normals_;
  std::size_t face_ = 0, corner_ = 0;
  ModelRef group_;
  ByteWriter out_;
};

}  // namespace

std::string write_obj(const MeshData& mesh, const std::vector<std::string>& libraries) {
  return ObjWriter(mesh, libraries).write();
}

}  // namespace aomd::io::detail
