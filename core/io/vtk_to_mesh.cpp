// A VTK grid as a mesh: cells, then classes, then attributes.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/entities.h"
#include "core/io/face_sink.h"
#include "core/io/notes.h"
#include "core/io/polygon.h"
#include "core/io/stored_numbers.h"
#include "core/io/vtk_cells.h"
#include "core/io/vtk_dataset.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

using Indices = std::span<const std::int64_t>;

constexpr double largest_whole =
    9007199254740992.0;  // 2^53: below it every whole number is a double

/// One value a tuple, and whole.
bool is_label(const VtkArray* array) { return array && array->integer && array->components == 1; }

class GridToMesh {
 public:
  GridToMesh(VtkDataset&& grid, const Source& source, const FailAtCell& fail)
      : grid_(std::move(grid)), source_(source), fail_(fail) {}

  ReadResult convert() {
    if (grid_.points.size() >= no_index || grid_.connectivity.size() >= no_index)
      throw LimitError(source_.name, {}, "more than 2^32 - 2 points or cells");
    used_.resize(grid_.points.size());
    for (std::size_t i = 0; i < grid_.types.size(); ++i) add_cell(i);
    mesh_.positions = std::move(grid_.points);
    classify();
    add_attributes();
    if (!rounded_.empty())
      notes_.push_back("whole numbers of more than 53 bits are rounded, array " + rounded_.text());
    if (curved_ > 0) drop_inner_nodes();
    drop_empty_classes(mesh_);
    note_polygons(notes_, polygons_);
    repeats_.note(notes_);
    return {std::move(mesh_), {}, std::move(notes_)};
  }

 private:
  enum Use : std::uint8_t { Unused, Inner, Corner };

  Indices nodes_of(std::size_t cell) const {
    const auto begin = static_cast<std::size_t>(cell == 0 ? 0 : grid_.ends[cell - 1]);
    return Indices(grid_.connectivity)
        .subspan(begin, static_cast<std::size_t>(grid_.ends[cell]) - begin);
  }

  void add_cell(std::size_t i) {
    const CellKind* kind = cell_kind(grid_.types[i]);
    if (!kind) fail_(i, "cells of type " + cell_type_name(grid_.types[i]) + " are not read");
    const Indices nodes = nodes_of(i);
    if (kind->nodes != 0 && nodes.size() != kind->nodes) {
      fail_(i, "a " + std::string(kind->name) + " of " + counted(nodes.size(), "vertex") +
                   "; it has " + std::to_string(kind->nodes));
    }
    switch (kind->rule) {
      case CellRule::Nothing:
        return;
      case CellRule::Points:
        return add_points(nodes, i);
      case CellRule::Lines:
        return add_lines(nodes, i);
      case CellRule::Strip:
        return add_strip(nodes, i);
      case CellRule::Polygon:
        return add_polygon(nodes, i);
      case CellRule::Corners:
        return add_corners(*kind, nodes, i);
    }
  }

  void add(Shape shape, Indices corners, std::size_t cell) {
    const ShapeTemplate& t = shape_template(shape);
    const std::string wrong = entity_defect(shape, corners, grid_.points.size());
    if (!wrong.empty()) return add_rest(shape, corners, cell, wrong);
    append(mesh_.list(t.dimension), shape, corners);
    cells_[static_cast<std::size_t>(t.dimension)].push_back(static_cast<std::uint32_t>(cell));
    for (const std::int64_t v : corners) used_[static_cast<std::size_t>(v)] = Corner;
  }

  /// What is left of an edge or a face without its repeated corners.
  void add_rest(Shape shape, Indices corners, std::size_t cell, const std::string& wrong) {
    const auto left = without_repeats(shape, corners, grid_.points.size(), repeats_);
    if (!left) fail_(cell, wrong);
    if (!left->empty()) add(Shape::Triangle, *left, cell);
  }

  void check_indices(Indices nodes, std::size_t cell) const {
    for (const std::int64_t v : nodes) {
      if (outside(v, grid_.points.size())) fail_(cell, out_of_range(v, grid_.points.size()));
    }
  }

  void add_points(Indices nodes, std::size_t cell) {
    check_indices(nodes, cell);
    for (const std::int64_t v : nodes) {
      used_[static_cast<std::size_t>(v)] = Corner;
      points_.emplace_back(static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(cell));
    }
  }

  void add_lines(Indices nodes, std::size_t cell) {
    check_indices(nodes, cell);
    repeats_.edges += nodes.size() < 2;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) add(Shape::Line, nodes.subspan(k, 2), cell);
  }

  /// Every second triangle runs the other way; those that repeat a vertex are how strips turn
  /// corners.
  void add_strip(Indices v, std::size_t cell) {
    check_indices(v, cell);
    repeats_.faces += v.size() < 3;
    for (std::size_t k = 2; k < v.size(); ++k) {
      const bool odd = k % 2 == 1;
      const std::int64_t triangle[] = {v[k - 2], v[odd ? k : k - 1], v[odd ? k - 1 : k]};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        continue;
      add(Shape::Triangle, triangle, cell);
    }
  }

  void add_polygon(Indices nodes, std::size_t cell) {
    if (nodes.size() == 3) return add(Shape::Triangle, nodes, cell);
    if (nodes.size() == 4) return add(Shape::Quad, nodes, cell);
    const std::string wrong = polygon_defect(nodes, grid_.points.size());
    if (!wrong.empty()) fail_(cell, wrong);
    walk_.assign(nodes.begin(), nodes.end());
    const bool repeats = nodes.size() < 3 || repeats_vertex(nodes);
    if (repeats) trim_walk(walk_);
    ++(!repeats ? polygons_ : walk_.size() < 3 ? repeats_.faces : repeats_.cut);
    if (walk_.size() < 3) return;
    polygon_.assign(walk_.begin(), walk_.end());
    triangles_.clear();
    triangles_of_walk(grid_.points, polygon_, triangles_);
    for (std::size_t k = 0; k < triangles_.size(); k += 3) {
      const std::int64_t triangle[] = {triangles_[k], triangles_[k + 1], triangles_[k + 2]};
      add(Shape::Triangle, triangle, cell);
    }
  }

  void add_corners(const CellKind& kind, Indices nodes, std::size_t cell) {
    const std::span<const std::uint8_t> order = corner_order(kind);
    if (nodes.size() < order.size())
      fail_(cell, "a " + std::string(kind.name) + " of " + counted(nodes.size(), "vertex"));
    std::array<std::int64_t, 8> corners{};
    for (std::size_t k = 0; k < order.size(); ++k) corners[k] = nodes[order[k]];
    add(kind.shape, Indices(corners).first(order.size()), cell);
    if (nodes.size() == order.size()) return;
    ++curved_;
    const Indices inner = nodes.subspan(order.size());
    check_indices(inner, cell);
    for (const std::int64_t v : inner) {
      auto& use = used_[static_cast<std::size_t>(v)];
      use = std::max(use, std::uint8_t{Inner});
    }
  }

  /// The class that model_dimension and model_tag give entity i, whose own dimension is `lowest`.
  static std::optional<ModelRef> model(const VtkArray& dimensions, const VtkArray& tags,
                                       std::size_t i, int lowest) {
    const double dimension = dimensions.values[i], tag = tags.values[i];
    if (dimension == 7) return ModelRef();
    if (dimension < lowest || dimension > 3 || tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      return {};
    return ModelRef(static_cast<int>(dimension), static_cast<std::int32_t>(tag));
  }

  static std::string no_class(const VtkArray& dimensions, const VtkArray& tags, std::size_t i,
                              std::string_view what) {
    ByteWriter out;
    out << "a " << what << " cannot lie on model entity " << tags.values[i] << " of dimension "
        << dimensions.values[i];
    return out.take();
  }

  void classify() {
    classify_points();
    const VtkArray* dimensions = find_array(grid_.cell_data, dimension_name);
    const VtkArray* tags = find_array(grid_.cell_data, tag_name);
    if (is_label(dimensions) && is_label(tags)) {
      classify_cells([&](std::size_t cell, int own) {
        const auto found = model(*dimensions, *tags, cell, own);
        if (!found) fail_(cell, no_class(*dimensions, *tags, cell, entity_name(own)));
        return *found;
      });
    } else if (const VtkArray* labels = preferred_labels()) {
      classify_by(*labels);
    }
  }

  /// By the values themselves where they can be tags; else these count the values in ascending
  /// order, and the array stays as it is.
  void classify_by(const VtkArray& labels) {
    const std::string note = "classified by the cell array " + shown(labels.name);
    if (are_tags(labels.values)) {
      classify_cells([&](std::size_t cell, int own) {
        return ModelRef(own, static_cast<std::int32_t>(labels.values[cell]));
      });
      notes_.push_back(note);
      grid_.cell_data.erase(grid_.cell_data.begin() + (&labels - grid_.cell_data.data()));
      return;
    }
    std::map<double, std::int32_t> tags;
    for (const double value : labels.values) tags[value] = 0;
    std::int32_t last = 0;
    for (auto& [value, tag] : tags) tag = ++last;
    classify_cells(
        [&](std::size_t cell, int own) { return ModelRef(own, tags.at(labels.values[cell])); });
    notes_.push_back(note + ", whose " + counted(tags.size(), "value") + " count as 1, 2, ...");
  }

  static bool are_tags(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double tag) {
      return tag >= ModelRef::min_tag && tag <= ModelRef::max_tag;
    });
  }

  void classify_points() {
    const VtkArray* dimensions = find_array(grid_.point_data, dimension_name);
    const VtkArray* tags = find_array(grid_.point_data, tag_name);
    if (!is_label(dimensions) || !is_label(tags)) return;
    mesh_.vertex_classes.reserve(mesh_.positions.size());
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      const auto found = model(*dimensions, *tags, i, 0);
      if (!found)
        source_.fail("point " + std::to_string(i) + ": " +
                     no_class(*dimensions, *tags, i, "vertex"));
      mesh_.vertex_classes.push_back(*found);
    }
  }

  /// class_of(cell, dimension of the entity). Vertex cells count where the points have no classes
  /// themselves.
  template <class ClassOf>
  void classify_cells(ClassOf&& class_of) {
    for (int d = 1; d <= 3; ++d) {
      for (const std::uint32_t cell : cells_[static_cast<std::size_t>(d)])
        mesh_.list(d).classes.push_back(class_of(cell, d));
    }
    if (!mesh_.vertex_classes.empty() || points_.empty()) return;
    mesh_.vertex_classes.resize(mesh_.positions.size());
    for (const auto& [vertex, cell] : points_) mesh_.vertex_classes[vertex] = class_of(cell, 0);
  }

  const VtkArray* preferred_labels() const {
    const VtkArray* beyond_tags = nullptr;
    for (const std::string_view name : label_names) {
      const VtkArray* array = find_array(grid_.cell_data, name);
      if (!is_label(array)) continue;
      if (are_tags(array->values)) return array;
      if (!beyond_tags) beyond_tags = array;
    }
    return beyond_tags;
  }

  void add_attributes() {
    for (VtkArray& array : grid_.point_data) {
      if (array.name != dimension_name && array.name != tag_name)
        add_attribute(array, 0, std::move(array.values));
    }
    std::erase_if(grid_.cell_data, [&](const VtkArray& array) {
      return array.name == dimension_name || array.name == tag_name;
    });
    const VtkArray* coverage = find_array(grid_.field_data, coverage_name);
    if (!is_label(coverage) || coverage->values.size() != grid_.cell_data.size())
      coverage = nullptr;
    std::size_t room = room_for_copies();
    for (int d = 1; d <= 3; ++d) {
      if (mesh_.list(d).empty()) continue;
      for (std::size_t k = 0; k < grid_.cell_data.size(); ++k) {
        if (!coverage || covers(coverage->values[k], d))
          room = add_cell_attribute(grid_.cell_data[k], d, room);
      }
    }
  }

  static bool covers(double dimensions, int d) {
    return dimensions >= 0 && dimensions < 16 && (static_cast<unsigned>(dimensions) >> d & 1u) != 0;
  }

  /// How many values the attributes may have. Cells that are split repeat theirs, without bound:
  /// one long strip and many arrays.
  std::size_t room_for_copies() const {
    std::size_t values = 1024 + grid_.connectivity.size();
    for (const VtkArray& array : grid_.cell_data) values += array.values.size();
    return 4 * values;
  }

  /// Returns the room that is left.
  std::size_t add_cell_attribute(const VtkArray& array, int d, std::size_t room) {
    const std::vector<std::uint32_t>& cells = cells_[static_cast<std::size_t>(d)];
    const auto n = static_cast<std::size_t>(array.components);
    if (cells.size() > room / n) {
      throw LimitError(
          source_.name, {},
          "the values of split cells take too much memory, array " + shown(array.name));
    }
    std::vector<double> values;
    values.reserve(n * cells.size());
    for (const std::uint32_t cell : cells) {
      const auto from = array.values.begin() + static_cast<std::ptrdiff_t>(n * cell);
      values.insert(values.end(), from, from + array.components);
    }
    add_attribute(array, d, std::move(values));
    return room - n * cells.size();
  }

  void add_attribute(const VtkArray& array, int d, std::vector<double>&& values) {
    const bool exact = std::all_of(values.begin(), values.end(),
                                   [](double x) { return std::abs(x) < largest_whole; });
    if (array.integer && !exact) rounded_.add(shown(array.name));
    const Meaning meaning = array.meaning == Meaning::Any || array.meaning == Meaning::Scalars
                                ? usual_meaning(array)
                                : array.meaning;
    Attribute a{array.name, d, array.components, array.integer && exact, std::move(values)};
    const bool usual = array.type == NumberType::Int64 && !fit_int32(a.values);
    if (!usual && (exact || !array.integer)) a.type = array.type;
    a.meaning = meaning == Meaning::Any ? array.meaning : meaning;
    mesh_.attributes.push_back(std::move(a));
  }

  /// Nodes that only higher-order cells use, other than as a corner.
  void drop_inner_nodes() {
    notes_.push_back(counted(curved_, "higher-order cell") + " read by the corners");
    for (std::uint8_t& use : used_) use = use == Inner;
    drop_vertices(mesh_, used_);
  }

  VtkDataset grid_;
  const Source& source_;
  const FailAtCell& fail_;
  MeshData mesh_;
  std::array<std::vector<std::uint32_t>, 4> cells_;  ///< the cell that each entity comes from
  std::vector<std::pair<std::uint32_t, std::uint32_t>> points_;  ///< vertex cells: vertex, cell
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> polygon_, triangles_;
  std::size_t polygons_ = 0, curved_ = 0;
  ItemList rounded_;  ///< arrays
  Repeats repeats_;
  std::vector<std::int64_t> walk_;
  std::vector<std::string> notes_;
};

}  // namespace

ReadResult mesh_of(VtkDataset grid, const Source& source, const FailAtCell& fail) {
  return GridToMesh(std::move(grid), source, fail).convert();
}

}  // namespace aomd::io::detail
