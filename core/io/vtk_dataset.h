#pragma once
// What a VTK file holds, legacy or XML, and how it corresponds to a mesh.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/io.h"
#include "core/io/source.h"

namespace aomd::io::detail {

/// Numbers attached to points, to cells, or to the whole.
struct VtkArray {
  std::string name;
  int components = 1;
  bool integer = false;
  std::vector<double> values;        ///< `components` for each point or cell
  std::optional<NumberType> type{};  ///< as Attribute has it
  Meaning meaning = Meaning::Any;
};

/// An unstructured grid. The arrays have as many tuples as there are points or cells; indices are
/// unchecked.
struct VtkDataset {
  std::vector<glm::dvec3> points;
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> ends;   ///< where each cell's points end in `connectivity`; ascending
  std::vector<std::uint8_t> types;  ///< one a cell
  std::vector<VtkArray> point_data, cell_data, field_data;
};

/// Throws ReadError that says what is wrong with cell i and where in the file it stands.
using FailAtCell = std::function<void(std::size_t cell, const std::string& what)>;

/// The mesh of a grid. Cells of each dimension keep their order; polylines and strips are split,
/// polygons with more than 4 corners triangulated, higher-order cells reduced to their corners
/// (nodes that nothing else uses are dropped), vertex cells only classify. Arrays become
/// attributes. Classes come from the arrays model_dimension and model_tag of points and cells; else
/// from the first one-component array of whole numbers among label_names: the tag of a model entity
/// of the cell's own dimension. Throws ReadError, through `fail` where a cell is at fault. Linear;
/// memory in proportion to the grid's.
[[nodiscard]] ReadResult mesh_of(VtkDataset grid, const Source& source, const FailAtCell& fail);

/// The grid of a mesh: edges, faces, regions. Attributes of one name become one array of the cells;
/// where a dimension lacks it the values are 0, and the field array attribute_dimensions says so:
/// for each cell array the sum of 1 << dimension.
[[nodiscard]] VtkDataset grid_of(const MeshData& mesh);

/// The array of this name, or null.
[[nodiscard]] const VtkArray* find_array(const std::vector<VtkArray>& arrays,
                                         std::string_view name);

/// Calls visit(number as the file stores it, whether it ends its tuple) for every value.
template <class Visit>
void for_each_value(const VtkArray& array, NumberType type, Visit&& visit) {
  const auto n = static_cast<std::size_t>(array.components);
  for (std::size_t i = 0; i < array.values.size(); ++i)
    use_as(type, array.values[i], [&](auto x) { visit(x, i % n == n - 1); });
}

/// What an array stands for as far as its name and numbers tell: colours are bytes, 3 or 4 a tuple.
[[nodiscard]] Meaning usual_meaning(const VtkArray& array);

/// How VTU files name the arrays that are shown first.
inline constexpr std::array<std::pair<std::string_view, Meaning>, 5> vtu_actives{
    {{"Scalars", Meaning::Scalars},
     {"Vectors", Meaning::Vectors},
     {"Normals", Meaning::Normal},
     {"Tensors", Meaning::Tensors},
     {"TCoords", Meaning::Texture}}};

/// Names of our own arrays.
inline constexpr std::string_view dimension_name = "model_dimension", tag_name = "model_tag",
                                  coverage_name = "attribute_dimensions";

/// Cell arrays of other programs that classify, the most telling first.
inline constexpr std::array<std::string_view, 11> label_names{
    "CellEntityIds", "gmsh:geometrical", "gmsh:physical", "medit:ref", "material", "Material",
    "MaterialIds",   "attribute",        "region",        "Region",    "RegionIds"};

}  // namespace aomd::io::detail
