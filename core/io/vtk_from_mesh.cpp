// A mesh as a VTK grid, for both writers.

#include <algorithm>
#include <unordered_map>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/vtk_cells.h"
#include "core/io/vtk_dataset.h"

namespace aomd::io::detail {
namespace {

class MeshToGrid {
 public:
  explicit MeshToGrid(const MeshData& mesh) : mesh_(mesh) {}

  VtkDataset convert() {
    grid_.points = mesh_.positions;
    for (int d = 1; d <= 3; ++d) add_cells(d);
    add_classes();
    for (const Attribute& a : mesh_.attributes) {
      if (a.dimension == 0) {
        grid_.point_data.push_back({a.name, a.components, a.integer, a.values, a.type, a.meaning});
      } else {
        add_cell_values(a);
      }
    }
    if (std::any_of(coverage_.begin(), coverage_.end(), [&](double c) { return c != present(); }))
      grid_.field_data.push_back({std::string(coverage_name), 1, true, coverage_});
    return std::move(grid_);
  }

 private:
  void add_cells(int d) {
    const EntityList& list = mesh_.list(d);
    first_cell_[d] = grid_.types.size();
    std::size_t i = 0;
    for_each_entity(list, [&](auto corners, ModelRef) {
      const std::uint8_t type = cell_type(list.shapes[i++]);
      for (const std::uint8_t k : corner_order(*cell_kind(type)))
        grid_.connectivity.push_back(corners[k]);
      grid_.ends.push_back(static_cast<std::int64_t>(grid_.connectivity.size()));
      grid_.types.push_back(type);
    });
  }

  /// Without classes, arrays that look like some would be taken for them.
  [[nodiscard]] bool mistakable() const {
    return std::any_of(mesh_.attributes.begin(), mesh_.attributes.end(), [](const Attribute& a) {
      return a.dimension > 0 &&
             std::find(label_names.begin(), label_names.end(), a.name) != label_names.end();
    });
  }

  void add_classes() {
    std::vector<ModelRef> classes;
    bool any = mistakable();
    for (int d = 1; d <= 3; ++d) {
      const EntityList& list = mesh_.list(d);
      any = any || !list.classes.empty();
      classes.insert(classes.end(), list.classes.begin(), list.classes.end());
      if (list.classes.empty()) classes.resize(classes.size() + list.size());
    }
    if (any) add_class_arrays(grid_.cell_data, classes);
    if (!mesh_.vertex_classes.empty()) add_class_arrays(grid_.point_data, mesh_.vertex_classes);
    own_arrays_ = grid_.cell_data.size();
  }

  static void add_class_arrays(std::vector<VtkArray>& arrays,
                               const std::vector<ModelRef>& classes) {
    VtkArray dimensions{std::string(dimension_name), 1, true, {}},
        tags{std::string(tag_name), 1, true, {}};
    for (const ModelRef m : classes) {
      dimensions.values.push_back(m.dimension());
      tags.values.push_back(m.tag());
    }
    arrays.push_back(std::move(dimensions));
    arrays.push_back(std::move(tags));
  }

  void add_cell_values(const Attribute& a) {
    const std::size_t k = array_for(a);
    VtkArray& array = grid_.cell_data[own_arrays_ + k];
    if (a.type) array.type = a.type;
    const auto n = static_cast<std::size_t>(a.components);
    std::copy(a.values.begin(), a.values.end(),
              array.values.begin() + static_cast<std::ptrdiff_t>(n * first_cell_[a.dimension]));
    coverage_[k] += 1 << a.dimension;
  }

  /// The array that takes these values: one of the same kind that has none of this dimension, or a
  /// new one.
  std::size_t array_for(const Attribute& a) {
    const bool usual = !a.type || *a.type == NumberType::Int64;
    const int type = usual ? -1 : static_cast<int>(*a.type);
    std::vector<std::size_t>& same = arrays_[(a.integer ? 'i' : 'r') + std::to_string(type) + ' ' +
                                             std::to_string(a.components) + ' ' + a.name];
    for (const std::size_t k : same) {
      if ((static_cast<int>(coverage_[k]) >> a.dimension & 1) == 0) return k;
    }
    grid_.cell_data.push_back({a.name, a.components, a.integer, {}, a.type, a.meaning});
    grid_.cell_data.back().values.resize(grid_.types.size() *
                                         static_cast<std::size_t>(a.components));
    same.push_back(coverage_.size());
    coverage_.push_back(0);
    return coverage_.size() - 1;
  }

  /// The dimensions that have entities, as `coverage_` counts them.
  [[nodiscard]] double present() const {
    int sum = 0;
    for (int d = 1; d <= 3; ++d) sum += mesh_.list(d).empty() ? 0 : 1 << d;
    return sum;
  }

  const MeshData& mesh_;
  VtkDataset grid_;
  std::size_t first_cell_[4] = {};
  std::size_t own_arrays_ = 0;    ///< cell arrays before those of attributes
  std::vector<double> coverage_;  ///< of each cell array of attributes
  std::unordered_map<std::string, std::vector<std::size_t>> arrays_;  ///< those of one kind
};

}  // namespace

VtkDataset grid_of(const MeshData& mesh) { return MeshToGrid(mesh).convert(); }

const VtkArray* find_array(const std::vector<VtkArray>& arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const VtkArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

Meaning usual_meaning(const VtkArray& array) {
  const bool of_colour = array.components == 3 || array.components == 4;
  if (of_colour && array.type == NumberType::UInt8) return Meaning::Colour;
  const std::string name = lower(array.name);
  constexpr std::string_view colours[] = {"color", "colors", "rgb", "rgba"};
  if (of_colour && !array.integer &&
      std::find(std::begin(colours), std::end(colours), name) != std::end(colours))
    return Meaning::Colour;
  const bool normal = array.components == 3 && !array.integer;
  if (normal && (name == "normal" || name == "normals")) return Meaning::Normal;
  return Meaning::Any;
}

}  // namespace aomd::io::detail
