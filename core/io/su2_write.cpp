// SU2's native mesh format. What is classified on model faces (in the plane: model edges) becomes
// markers.

#include <algorithm>
#include <cstdlib>
#include <map>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/vtk_cells.h"

namespace aomd::io::detail {
namespace {

class Su2Writer {
 public:
  explicit Su2Writer(const MeshData& mesh)
      : mesh_(mesh), dimension_(mesh.regions.empty() ? 2 : 3) {}

  std::string write() {
    out_.reserve(64 * mesh_.positions.size() + 48 * mesh_.list(dimension_).size());
    out_ << "NDIME= " << dimension_ << '\n';
    const EntityList& list = mesh_.list(dimension_);
    out_ << "NELEM= " << list.size() << '\n';
    std::size_t i = 0;
    for_each_entity(list, [&](auto corners, ModelRef) {
      element(out_, list.shapes[i], corners);
      out_ << ' ' << i++ << '\n';
    });
    points();
    markers();
    return out_.take();
  }

 private:
  static void element(ByteWriter& out, Shape shape, std::span<const std::uint32_t> corners) {
    const std::uint8_t type = cell_type(shape);
    out << int{type};
    for (const std::uint8_t k : corner_order(*cell_kind(type))) out << ' ' << corners[k];
  }

  void points() {
    out_ << "NPOIN= " << mesh_.positions.size() << '\n';
    std::size_t i = 0;
    for (const glm::dvec3& p : mesh_.positions) {
      out_ << p.x << ' ' << p.y << ' ';
      if (dimension_ == 3) out_ << p.z << ' ';
      out_ << i++ << '\n';
    }
  }

  /// A physical group, or a model entity that is in none.
  void markers() {
    struct Marker {
      std::int32_t first_tag = 0;
      std::size_t count = 0;
      ByteWriter elements;
    };
    name_entities();
    std::map<std::string, Marker> markers;
    std::map<ModelRef, Marker*> of_entity;
    const EntityList& list = mesh_.list(dimension_ - 1);
    for (const ModelRef m : list.classes) {
      if (m.dimension() != dimension_ - 1 || of_entity.contains(m)) continue;
      const auto [at, fresh] = markers.try_emplace(marker_name(m));
      at->second.first_tag = fresh ? m.tag() : std::min(at->second.first_tag, m.tag());
      of_entity[m] = &at->second;
    }
    std::size_t i = 0;
    for_each_entity(list, [&](auto corners, ModelRef m) {
      const Shape shape = list.shapes[i++];
      const auto found = of_entity.find(m);
      if (found == of_entity.end()) return;
      element(found->second->elements, shape, corners);
      found->second->elements << '\n';
      ++found->second->count;
    });
    std::vector<std::pair<std::string, Marker*>> ordered;
    ordered.reserve(markers.size());
    for (auto& [name, marker] : markers) ordered.emplace_back(name, &marker);
    std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) {
      return a.second->first_tag < b.second->first_tag;
    });
    out_ << "NMARK= " << ordered.size() << '\n';
    for (auto& [name, marker] : ordered)
      out_ << "MARKER_TAG= " << name << "\nMARKER_ELEMS= " << marker->count << '\n'
           << marker->elements.take();
  }

  /// The name of the first group of each model entity that markers may be made of.
  void name_entities() {
    std::map<std::int32_t, std::string> groups;
    for (const PhysicalGroup& group : mesh_.model.groups) {
      if (group.dimension == dimension_ - 1 && !group.name.empty())
        groups.emplace(group.tag, group.name);
    }
    for (const ModelEntity& e : mesh_.model.entities) {
      if (e.groups.empty()) continue;
      const auto group = groups.find(std::abs(e.groups[0]));
      if (group != groups.end()) names_.emplace(e.ref, group->second);
    }
  }

  [[nodiscard]] std::string marker_name(ModelRef m) const {
    const auto name = names_.find(m);
    return name != names_.end() ? name->second : "marker_" + std::to_string(m.tag());
  }

  const MeshData& mesh_;
  int dimension_;
  std::map<ModelRef, std::string> names_;
  ByteWriter out_;
};

}  // namespace

std::string write_su2(const MeshData& mesh) { return Su2Writer(mesh).write(); }

}  // namespace aomd::io::detail
