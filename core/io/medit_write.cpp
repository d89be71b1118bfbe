// Medit .mesh, text.

#include <algorithm>
#include <array>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/medit.h"

namespace aomd::io::detail {
namespace {

class MeditWriter {
 public:
  explicit MeditWriter(const MeshData& mesh) : mesh_(mesh) {}

  std::string write() {
    out_.reserve(48 * mesh_.positions.size() + 32 * mesh_.faces.size() + 40 * mesh_.regions.size());
    out_ << "MeshVersionFormatted 2\nDimension 3\n";
    vertices();
    corners();
    if (const Attribute* required = find(medit_required, 0))
      marks("RequiredVertices", required->values);
    for (int d = 1; d <= 3; ++d) elements(d);
    if (const Attribute* ridges = find(medit_ridge, 1)) marks("Ridges", ridges->values);
    vectors("Normals", "NormalAtVertices", find(medit_normal, 0));
    vectors("Tangents", "TangentAtVertices", find(medit_tangent, 0));
    out_ << "End\n";
    return out_.take();
  }

 private:
  [[nodiscard]] const Attribute* find(std::string_view name, int d) const {
    const auto found =
        std::find_if(mesh_.attributes.begin(), mesh_.attributes.end(),
                     [&](const Attribute& a) { return a.dimension == d && a.name == name; });
    return found == mesh_.attributes.end() ? nullptr : &*found;
  }

  void vertices() {
    const Attribute* references = find(medit_reference, 0);
    out_ << "Vertices\n" << mesh_.positions.size() << '\n';
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      const glm::dvec3& p = mesh_.positions[i];
      out_ << p.x << ' ' << p.y << ' ' << p.z << ' ' << (references ? references->values[i] : 0.0)
           << '\n';
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
    out_ << "Corners\n" << corners.size() << '\n';
    for (const auto& [model, i] : corners) out_ << i + 1 << '\n';
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
    out_ << part.keyword << '\n' << n << '\n';
    std::size_t i = 0;
    for_each_entity(list, [&](auto corners, ModelRef model) {
      if (list.shapes[i++] != part.shape) return;
      for (const std::uint32_t v : corners) out_ << std::uint64_t{v} + 1 << ' ';
      out_ << (model.valid() ? model.tag() : 0) << '\n';
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
    out_ << keyword << '\n' << n << '\n';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != 0) out_ << i + 1 << '\n';
    }
  }

  void vectors(std::string_view keyword, std::string_view use_keyword, const Attribute* a) {
    if (!a || a->components != 3) return;
    std::vector<std::size_t> vertices;
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      const double* x = &a->values[3 * v];
      if (x[0] != 0 || x[1] != 0 || x[2] != 0) vertices.push_back(v);
    }
    if (vertices.empty()) return;
    out_ << keyword << '\n' << vertices.size() << '\n';
    for (const std::size_t v : vertices)
      out_ << a->values[3 * v] << ' ' << a->values[3 * v + 1] << ' ' << a->values[3 * v + 2]
           << '\n';
    out_ << use_keyword << '\n' << vertices.size() << '\n';
    for (std::size_t i = 0; i < vertices.size(); ++i)
      out_ << vertices[i] + 1 << ' ' << i + 1 << '\n';
  }

  const MeshData& mesh_;
  ByteWriter out_;
};

}  // namespace

std::string write_medit(const MeshData& mesh) { return MeditWriter(mesh).write(); }

}  // namespace aomd::io::detail
