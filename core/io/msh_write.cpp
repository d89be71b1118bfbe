// Gmsh MSH 4.1 and 2.2.
//
// Node tags are 1, 2, ... in the order of the vertices, element tags in the order of the lists
// (points, edges, faces, regions), also where 4.1 groups them by model entity: reading restores the
// order. Entity tag 0 stands for "not classified" in both versions, so a class with tag 0 is lost.
// The class of an edge inside a model face and the like is lost too: Gmsh knows only elements of
// their entity's own dimension. 2.2 has no table of entities (only the first physical group of
// each) and classifies vertices only on model vertices: the others read back on the lowest
// classified entity that touches them.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/msh.h"
#include "core/io/msh_out.h"

namespace aomd::io::detail {
namespace {

/// A name as it can stand between quotes on one line.
std::string quoted(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    if (c == '"') c = '\'';
  }
  return '"' + name + '"';
}

/// The entity that an element lies on, as the format can say it.
ModelRef own_class(ModelRef model, int dim) {
  return model.dimension() == dim ? model : ModelRef(dim, 0);
}

/// Elements of one dimension, with what finds them in another order.
struct Elements {
  const EntityList* list = nullptr;
  std::vector<std::size_t> starts;
  std::uint64_t first_tag = 1;

  [[nodiscard]] ModelRef model(std::size_t i, int dim) const {
    return list->classes.empty() ? ModelRef(dim, 0) : own_class(list->classes[i], dim);
  }
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::size_t i) const {
    const auto n = static_cast<std::size_t>(shape_template(list->shapes[i]).vertex_count);
    return std::span(list->vertices).subspan(starts[i], n);
  }
};

class MshWriter {
 public:
  MshWriter(const MeshData& mesh, bool binary) : mesh_(mesh), out_(binary) {
    for (std::uint32_t v = 0; v < mesh.vertex_classes.size(); ++v)
      if (mesh.vertex_classes[v].dimension() == 0)
        points_.add(Shape::Point, {v}, mesh.vertex_classes[v]);
    std::uint64_t tag = 1;
    for (int dim = 0; dim <= 3; ++dim) {
      Elements& elements = elements_[static_cast<std::size_t>(dim)];
      elements.list = dim == 0 ? &points_ : &mesh.list(dim);
      elements.first_tag = tag;
      for_each_entity(*elements.list, [&, start = std::size_t{0}](auto vertices, ModelRef) mutable {
        elements.starts.push_back(start);
        start += vertices.size();
      });
      tag += elements.list->size();
      if (!elements.list->empty()) highest_ = dim;
    }
    element_count_ = tag - 1;
  }

  std::string write(bool msh2) {
    header(msh2);
    physical_names();
    if (msh2) {
      nodes2();
      elements2();
      if (!mesh_.periodic.empty()) periodic2();
    } else {
      entities();
      nodes4();
      elements4();
      if (!mesh_.periodic.empty()) periodic4();
    }
    for (const Attribute& attribute : mesh_.attributes) view(attribute);
    for (const Attribute* const attribute : msh_corners(mesh_)) corner_view(*attribute);
    return out_.text().take();
  }

 private:
  void header(bool msh2) {
    out_.begin("MeshFormat");
    out_.text() << (msh2 ? "2.2 " : "4.1 ") << (out_.binary() ? "1 8\n" : "0 8\n");
    if (out_.binary()) {
      out_.integer(1);
      out_.text() << '\n';
    }
    out_.text() << "$EndMeshFormat\n";
  }

  void physical_names() {
    if (mesh_.model.groups.empty()) return;
    out_.begin("PhysicalNames");
    out_.text() << mesh_.model.groups.size() << '\n';
    for (const PhysicalGroup& group : mesh_.model.groups)
      out_.text() << group.dimension << ' ' << group.tag << ' ' << quoted(group.name) << '\n';
    out_.text() << "$EndPhysicalNames\n";
  }

  [[nodiscard]] ModelRef vertex_class(std::size_t v) const {
    const ModelRef model = mesh_.vertex_classes.empty() ? ModelRef() : mesh_.vertex_classes[v];
    return model.valid() ? model : ModelRef(highest_, 0);
  }

  /// Every entity that a block will name.
  [[nodiscard]] std::set<ModelRef> named() const {
    std::set<ModelRef> refs;
    ModelRef last;
    const auto add = [&](ModelRef ref) {
      if (ref != last) refs.insert(ref);
      last = ref;
    };
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) add(vertex_class(v));
    for (int dim = 1; dim <= 3; ++dim)
      for_each_entity(mesh_.list(dim), [&](auto, ModelRef model) { add(own_class(model, dim)); });
    return refs;
  }

  /// The table, and behind it what only the classification names. Tag 0 too: Gmsh refuses blocks
  /// of entities that are not declared.
  [[nodiscard]] std::vector<ModelEntity> complete_table() const {
    std::set<ModelRef> refs = named();
    std::vector<ModelEntity> table = mesh_.model.entities, missing;
    for (const ModelEntity& entity : table) refs.erase(entity.ref);
    for (const ModelRef ref : refs) missing.push_back({ref, {}, {}, {}});
    set_boxes(mesh_, missing);
    table.insert(table.end(), missing.begin(), missing.end());
    std::stable_sort(table.begin(), table.end(), [](const ModelEntity& a, const ModelEntity& b) {
      return a.ref.dimension() < b.ref.dimension();
    });
    return table;
  }

  void entities() {
    const std::vector<ModelEntity> table = complete_table();
    out_.begin("Entities");
    for (int dim = 0; dim <= 3; ++dim)
      out_.count(static_cast<std::uint64_t>(
          std::count_if(table.begin(), table.end(),
                        [&](const ModelEntity& e) { return e.ref.dimension() == dim; })));
    out_.end_line();
    for (const ModelEntity& entity : table) write_entity(entity);
    out_.end("Entities");
  }

  void write_entity(const ModelEntity& entity) {
    const bool point = entity.ref.dimension() == 0;
    out_.integer(entity.ref.tag());
    for (std::size_t k = 0; k < (point ? 3u : 6u); ++k) out_.real(entity.box[k]);
    write_tags(entity.groups);
    if (!point) write_tags(entity.boundary);
    out_.end_line();
  }

  void write_tags(const std::vector<std::int32_t>& tags) {
    out_.count(tags.size());
    for (const std::int32_t tag : tags) out_.integer(tag);
  }

  void position(std::size_t v) {
    for (int axis = 0; axis < 3; ++axis) out_.real(mesh_.positions[v][axis]);
    out_.end_line();
  }

  /// Calls use(indices) for each run of indices below n with the same key, keys ascending.
  template <class Key, class Use>
  static void each_group(std::size_t n, Key&& key, Use&& use) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); };
    if (!std::is_sorted(order.begin(), order.end(), less))
      std::stable_sort(order.begin(), order.end(), less);
    for (auto from = order.begin(); from != order.end();) {
      const auto to =
          std::find_if(from, order.end(), [&](std::uint32_t i) { return key(*from) < key(i); });
      use(std::span(from, to));
      from = to;
    }
  }

  /// The counts and the range of tags that start a section of 4.1.
  void section4(std::string_view name, std::uint64_t blocks, std::uint64_t n) {
    out_.begin(name);
    out_.count(blocks);
    out_.count(n);
    out_.count(n > 0 ? 1 : 0);
    out_.count(n);
    out_.end_line();
  }

  void nodes4() {
    const auto key = [&](std::size_t v) { return vertex_class(v); };
    std::uint64_t blocks = 0;
    each_group(mesh_.positions.size(), key, [&](auto) { ++blocks; });
    section4("Nodes", blocks, mesh_.positions.size());
    each_group(mesh_.positions.size(), key, [&](auto vertices) {
      const ModelRef model = vertex_class(vertices.front());
      out_.integer(model.dimension());
      out_.integer(model.tag());
      out_.integer(0);
      out_.count(vertices.size());
      out_.end_line();
      for (const std::uint32_t v : vertices) {
        out_.count(v + 1);
        out_.end_line();
      }
      for (const std::uint32_t v : vertices) position(v);
    });
    out_.end("Nodes");
  }

  template <class Use>
  void each_element_block(Use&& use) const {
    for (int dim = 0; dim <= 3; ++dim) {
      const Elements& elements = elements_[static_cast<std::size_t>(dim)];
      const auto key = [&](std::size_t i) {
        const ModelRef model = elements.model(i, dim);
        return std::pair(model.tag(), elements.list->shapes[i]);
      };
      each_group(elements.list->size(), key, [&](auto indices) { use(dim, elements, indices); });
    }
  }

  void elements4() {
    std::uint64_t blocks = 0;
    each_element_block([&](int, const Elements&, auto) { ++blocks; });
    section4("Elements", blocks, element_count_);
    each_element_block([&](int dim, const Elements& elements, auto indices) {
      out_.integer(dim);
      out_.integer(elements.model(indices.front(), dim).tag());
      out_.integer(msh_number(elements.list->shapes[indices.front()]));
      out_.count(indices.size());
      out_.end_line();
      for (const std::uint32_t i : indices) {
        out_.count(elements.first_tag + i);
        for (const std::uint32_t v : elements.vertices(i)) out_.count(v + 1);
        out_.end_line();
      }
    });
    out_.end("Elements");
  }

  void nodes2() {
    out_.begin("Nodes");
    out_.text() << mesh_.positions.size() << '\n';
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      out_.integer(static_cast<std::int64_t>(v + 1));
      position(v);
    }
    out_.end("Nodes");
  }

  void elements2() {
    std::map<ModelRef, std::int32_t> groups;
    for (const ModelEntity& entity : mesh_.model.entities)
      if (!entity.groups.empty()) groups.emplace(entity.ref, entity.groups.front());
    out_.begin("Elements");
    out_.text() << element_count_ << '\n';
    for (int dim = 0; dim <= 3; ++dim) write_list2(dim, groups);
    out_.end("Elements");
  }

  void write_list2(int dim, const std::map<ModelRef, std::int32_t>& groups) {
    const Elements& elements = elements_[static_cast<std::size_t>(dim)];
    const std::vector<Shape>& shapes = elements.list->shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (out_.binary() && (i == 0 || shapes[i] != shapes[i - 1])) start_run(shapes, i);
      const ModelRef model = elements.model(i, dim);
      const auto group = groups.find(model);
      out_.integer(static_cast<std::int64_t>(elements.first_tag + i));
      if (!out_.binary()) {
        out_.integer(msh_number(shapes[i]));
        out_.integer(2);
      }
      out_.integer(group == groups.end() ? 0 : group->second);
      out_.integer(model.tag());
      for (const std::uint32_t v : elements.vertices(i)) out_.integer(v + 1);
      out_.end_line();
    }
  }

  /// Binary: the type and number of the elements that follow, and how many tags each has.
  void start_run(const std::vector<Shape>& shapes, std::size_t i) {
    const auto from = shapes.begin() + static_cast<std::ptrdiff_t>(i);
    const auto to =
        std::find_if(from, shapes.end(), [&](Shape shape) { return shape != shapes[i]; });
    out_.integer(msh_number(shapes[i]));
    out_.integer(to - from);
    out_.integer(2);
  }

  void periodic4() {
    out_.begin("Periodic");
    out_.count(mesh_.periodic.size());
    out_.end_line();
    for (const Periodicity& link : mesh_.periodic) {
      for (const int number : {link.entity.dimension(), link.entity.tag(), link.source.tag()})
        out_.integer(number);
      out_.end_line();
      out_.count(link.transformation.size());
      for (const double x : link.transformation) out_.real(x);
      out_.end_line();
      out_.count(link.pairs.size());
      out_.end_line();
      for (const auto& [vertex, counterpart] : link.pairs) {
        out_.count(std::uint64_t{vertex} + 1);
        out_.count(std::uint64_t{counterpart} + 1);
        out_.end_line();
      }
    }
    out_.end("Periodic");
  }

  /// Text in binary files too.
  void periodic2() {
    ByteWriter& text = out_.text();
    text << "$Periodic\n" << mesh_.periodic.size() << '\n';
    for (const Periodicity& link : mesh_.periodic) {
      text << link.entity.dimension() << ' ' << link.entity.tag() << ' ' << link.source.tag()
           << '\n';
      if (!link.transformation.empty()) text << "Affine";
      for (const double x : link.transformation) text << ' ' << x;
      if (!link.transformation.empty()) text << '\n';
      text << link.pairs.size() << '\n';
      for (const auto& [vertex, counterpart] : link.pairs)
        text << std::uint64_t{vertex} + 1 << ' ' << std::uint64_t{counterpart} + 1 << '\n';
    }
    text << "$EndPeriodic\n";
  }

  /// What is NaN is left out, as far as all components of an entity are.
  void view(const Attribute& attribute) {
    const auto components = static_cast<std::size_t>(attribute.components);
    const auto values = [&](std::size_t i) {
      return std::span(attribute.values).subspan(i * components, components);
    };
    std::vector<std::size_t> present;
    for (std::size_t i = 0; i < attribute.values.size() / components; ++i)
      if (any_known(values(i))) present.push_back(i);
    const std::string_view section = attribute.dimension == 0 ? "NodeData" : "ElementData";
    const std::uint64_t first =
        attribute.dimension == 0
            ? 1
            : elements_[static_cast<std::size_t>(attribute.dimension)].first_tag;
    begin_view(section, attribute, present.size());
    for (const std::size_t i : present) {
      out_.integer(static_cast<std::int64_t>(first + i));
      for (const double value : values(i)) out_.real(value);
      out_.end_line();
    }
    out_.end(section);
  }

  /// The same of an array on the corners of faces, as far as all values of a face are.
  void corner_view(const Attribute& attribute) {
    struct ListedFace {
      std::size_t face, corners;
      std::span<const double> values;
    };
    std::vector<ListedFace> present;
    std::size_t next = 0;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const auto corners =
          static_cast<std::size_t>(shape_template(mesh_.faces.shapes[f]).vertex_count);
      const std::size_t n = corners * static_cast<std::size_t>(attribute.components);
      const auto values = std::span(attribute.values).subspan(next, n);
      if (any_known(values)) present.push_back({f, corners, values});
      next += n;
    }
    begin_view("ElementNodeData", attribute, present.size());
    for (const ListedFace& row : present) {
      out_.integer(static_cast<std::int64_t>(elements_[2].first_tag + row.face));
      out_.integer(static_cast<std::int64_t>(row.corners));
      for (const double value : row.values) out_.real(value);
      out_.end_line();
    }
    out_.end("ElementNodeData");
  }

  [[nodiscard]] static bool any_known(std::span<const double> values) {
    return !std::all_of(values.begin(), values.end(), [](double x) { return std::isnan(x); });
  }

  void begin_view(std::string_view section, const Attribute& attribute, std::size_t rows) {
    out_.begin(section);
    out_.text() << "1\n"
                << quoted(attribute.name) << "\n1\n0\n3\n0\n"
                << attribute.components << '\n'
                << rows << '\n';
  }

  const MeshData& mesh_;
  MshOut out_;
  EntityList points_;  ///< the vertices on model vertices
  std::array<Elements, 4> elements_;
  std::uint64_t element_count_ = 0;
  int highest_ = 0;  ///< dimension of the elements
};

}  // namespace

std::string write_msh(const MeshData& mesh, bool binary, bool msh2) {
  return MshWriter(mesh, binary).write(msh2);
}

}  // namespace aomd::io::detail
