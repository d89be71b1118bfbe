// Medit meshes, text and binary.

#include <algorithm>
#include <array>

#include "core/io/formats.h"
#include "core/io/medit.h"
#include "core/io/medit_out.h"

namespace aomd::io::detail {
namespace {

class MeditWriter {
 public:
  MeditWriter(const MeshData& mesh, bool binary) : mesh_(mesh), out_(binary, most_bytes(mesh)) {}

  std::string write() {
    out_.reserve(48 * mesh_.positions.size() + 32 * mesh_.faces.size() + 40 * mesh_.regions.size());
    vertices();
    corners();
    if (const Attribute* required = find(medit_required, 0))
      marks("RequiredVertices", required->values);
    for (int d = 1; d <= 3; ++d) elements(d);
    if (const Attribute* ridges = find(medit_ridge, 1)) marks("Ridges", ridges->values);
    vectors("Normals", "NormalAtVertices", find(medit_normal, 0, 3));
    vectors("Tangents", "TangentAtVertices", find(medit_tangent, 0, 3));
    return out_.finish();
  }

 private:
  /// Vertices take 28 bytes, and 80 with all that may be attached; an element 8 and 4 a vertex.
  static std::uint64_t most_bytes(const MeshData& mesh) {
    std::uint64_t sum = 4096 + 112 * std::uint64_t{mesh.positions.size()};
    for (int d = 1; d <= 3; ++d) sum += 4 * mesh.list(d).vertices.size() + 12 * mesh.list(d).size();
    return sum;
  }

  [[nodiscard]] const Attribute* find(std::string_view name, int d, int components = 1) const {
    const auto found =
        std::find_if(mesh_.attributes.begin(), mesh_.attributes.end(), [&](const Attribute& a) {
          return a.dimension == d && a.name == name && a.components == components;
        });
    return found == mesh_.attributes.end() ? nullptr : &*found;
  }

  /// What the reader takes as a reference, else 0.
  static std::int64_t reference(double value) {
    return value >= ModelRef::min_tag && value <= ModelRef::max_tag
               ? static_cast<std::int64_t>(value)
               : 0;
  }

  void vertices() {
    const Attribute* references = find(medit_reference, 0);
    out_.begin("Vertices", mesh_.positions.size(), 1, 3);
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) out_.real(mesh_.positions[i][axis]);
      out_.integer(references ? reference(references->values[i]) : 0);
      out_.end_line();
    }
  }

  /// In the order of their tags, which become 1, 2, ... when the file is read.
  void corners() {
    std::vector<std::pair<ModelRef, std::size_t>> corners;
    for (std::size_t i = 0; i < mesh_.vertex_classes.size(); ++i) {
      if (mesh_.vertex_classes[i].dimension() == 0)
        corners.emplace_back(mesh_.vertex_classes[i], i);
    }
    if (corners.empty()) return;
    std::sort(corners.begin(), corners.end());
    out_.begin("Corners", corners.size(), 1);
    for (const auto& [model, i] : corners) index(i);
  }

  /// One list a shape, in the order in which the shapes first occur.
  void elements(int d) {
    const EntityList& list = mesh_.list(d);
    std::array<std::size_t, builtin_shapes> count{}, first{};
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto k = static_cast<std::size_t>(list.shapes[i]);
      if (count[k]++ == 0) first[k] = i;
    }
    std::vector<MeditList> parts;
    std::copy_if(medit_lists.begin(), medit_lists.end(), std::back_inserter(parts),
                 [&](const MeditList& p) { return count[static_cast<std::size_t>(p.shape)] > 0; });
    std::sort(parts.begin(), parts.end(), [&](const MeditList& a, const MeditList& b) {
      return first[static_cast<std::size_t>(a.shape)] < first[static_cast<std::size_t>(b.shape)];
    });
    const Attribute* required = find(medit_required, d);
    for (const MeditList& part : parts) {
      element_list(list, part, count[static_cast<std::size_t>(part.shape)]);
      if (required) required_elements(list, part, required->values);
    }
  }

  void element_list(const EntityList& list, const MeditList& part, std::size_t n) {
    const auto count = static_cast<std::size_t>(shape_template(part.shape).vertex_count);
    out_.begin(part.keyword, n, count + 1);
    std::size_t i = 0;
    for_each_entity(list, [&](auto corners, ModelRef model) {
      if (list.shapes[i++] != part.shape) return;
      for (const std::uint32_t v : corners) out_.integer(std::int64_t{v} + 1);
      out_.integer(model.valid() ? model.tag() : 0);
      out_.end_line();
    });
  }

  void required_elements(const EntityList& list, const MeditList& part,
                         const std::vector<double>& values) {
    std::vector<double> of_part;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list.shapes[i] == part.shape) of_part.push_back(values[i]);
    }
    marks("Required" + std::string(part.keyword), of_part);
  }

  /// The numbers of the items that have a value other than 0.
  void marks(std::string_view keyword, const std::vector<double>& values) {
    const auto n = static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](double x) { return x != 0; }));
    if (n == 0) return;
    out_.begin(keyword, n, 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != 0) index(i);
    }
  }

  void index(std::size_t i) {
    out_.integer(static_cast<std::int64_t>(i) + 1);
    out_.end_line();
  }

  void vectors(std::string_view keyword, std::string_view use_keyword, const Attribute* a) {
    if (!a) return;
    std::vector<std::size_t> vertices;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const double* x = &a->values[3 * v];
      if (x[0] != 0 || x[1] != 0 || x[2] != 0) vertices.push_back(v);
    }
    if (vertices.empty()) return;
    out_.begin(keyword, vertices.size(), 0, 3);
    for (const std::size_t v : vertices) {
      for (std::size_t k = 0; k < 3; ++k) out_.real(a->values[3 * v + k]);
      out_.end_line();
    }
    out_.begin(use_keyword, vertices.size(), 2);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      out_.integer(static_cast<std::int64_t>(vertices[i]) + 1);
      index(i);
    }
  }

  const MeshData& mesh_;
  MeditOut out_;
};

}  // namespace

std::string write_medit(const MeshData& mesh, bool binary) {
  return MeditWriter(mesh, binary).write();
}

}  // namespace aomd::io::detail
