#include "core/io/streamed_vtu.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/vtk_cells.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_numbers.h"
#include "core/io/vtk_pieces.h"
#include "core/io/vtu_packing.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

constexpr std::uint64_t tuples_a_piece = 1 << 15;
constexpr int triangle_cell = 5;

/// What the element of all arrays says of one, or its name.
Meaning meaning_in(const pugi::xml_node& data, const RecordArray& array) {
  Meaning active = Meaning::Any;
  for (const auto& [word, meaning] : vtu_actives)
    if (active == Meaning::Any && data.attribute(std::string(word).c_str()).value() == array.name)
      active = meaning;
  if (active != Meaning::Any && active != Meaning::Scalars) return active;
  const Meaning usual = usual_meaning(
      {array.name, array.components, is_integer(array.type), {}, array.type, Meaning::Any});
  return usual == Meaning::Any ? active : usual;
}

std::string name_of_cell(std::uint64_t number) { return "cell " + std::to_string(number); }

/// The records of some tuples: what each column has of the first, then of the second, and so on.
void weave(const std::vector<std::string>& columns, const std::vector<std::size_t>& sizes,
           std::size_t count, std::string& records) {
  records.clear();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k)
      records.append(columns[k], i * sizes[k], sizes[k]);
}

}  // namespace

StreamedVtu::StreamedVtu(const std::filesystem::path& path) : StreamedFile(path) {
  const VtuSkeleton skeleton(path);
  take_root(skeleton.root());
  pugi::xml_node only;
  for (const pugi::xml_node piece : skeleton.root().child("UnstructuredGrid").children("Piece")) {
    if (count_in(piece, "NumberOfPoints") == 0 && count_in(piece, "NumberOfCells") == 0) continue;
    if (only) refuse("a VTU file of several pieces");
    only = piece;
  }
  if (only) take_piece(skeleton, only);
}

void StreamedVtu::fail(const std::string& what) const { throw ReadError(name(), {}, what); }

void StreamedVtu::take_root(const pugi::xml_node& root) {
  const std::string_view type = root.attribute("type").value();
  if (std::string_view(root.name()) != "VTKFile") fail("the root element is not VTKFile");
  if (type != "UnstructuredGrid" || !root.child("UnstructuredGrid"))
    fail("a VTK file of type " + shown(type) + "; only UnstructuredGrid is read");
  packing_ = packing_of(root, [this](const std::string& what) { fail(what); });
}

std::uint32_t StreamedVtu::count_in(const pugi::xml_node& piece, const char* name) const {
  const std::uint64_t count = piece.attribute(name).as_ullong();
  if (count >= no_index)
    throw LimitError(StreamedFile::name(), {}, "has more than 4294967294 elements");
  return static_cast<std::uint32_t>(count);
}

void StreamedVtu::take_piece(const VtuSkeleton& skeleton, const pugi::xml_node& piece) {
  points_ = count_in(piece, "NumberOfPoints");
  cells_ = count_in(piece, "NumberOfCells");
  const pugi::xml_node points = piece.child("Points").child("DataArray");
  if (!points) fail("has no array of points");
  layout_.order = packing_.order;
  of_points_.push_back(column(skeleton, points, points_, 3));
  layout_.coordinate = of_points_[0].array.type;
  connectivity_ = cells_column(skeleton, piece, "connectivity", 3 * std::uint64_t{cells_});
  ends_ = cells_column(skeleton, piece, "offsets", cells_);
  types_ = cells_column(skeleton, piece, "types", cells_);
  take_data(skeleton, piece.child("PointData"), "vertex ", points_, of_points_,
            layout_.of_vertices);
  take_data(skeleton, piece.child("CellData"), "cell ", cells_, of_cells_, layout_.of_faces);
}

void StreamedVtu::take_data(const VtuSkeleton& skeleton, const pugi::xml_node& data, const char* of,
                            std::uint64_t count, std::vector<Column>& columns,
                            std::vector<RecordArray>& arrays) {
  for (const pugi::xml_node node : data.children("DataArray")) {
    const std::string named = node.attribute("Name").value();
    if (named == point_ids_name || named == cell_ids_name) continue;  // of the whole
    const bool text = std::string_view(node.attribute("type").value()) == "String";
    if (text || named == dimension_name || named == tag_name) {
      leave_out(of + shown(named));
      continue;
    }
    columns.push_back(column(skeleton, node, count, 0));
    columns.back().array.meaning = meaning_in(data, columns.back().array);
    arrays.push_back(columns.back().array);
  }
}

StreamedVtu::Column StreamedVtu::cells_column(const VtuSkeleton& skeleton,
                                              const pugi::xml_node& piece, const char* name,
                                              std::uint64_t count) const {
  const pugi::xml_node node =
      piece.child("Cells").find_child_by_attribute("DataArray", "Name", name);
  if (!node) fail(std::string("has no array of the cells' ") + name);
  Column found = column(skeleton, node, count, 1);
  if (!is_integer(found.array.type)) fail(std::string(name) + " are no whole numbers");
  return found;
}

StreamedVtu::Column StreamedVtu::column(const VtuSkeleton& skeleton, const pugi::xml_node& node,
                                        std::uint64_t count, int components) const {
  constexpr int most_components = 1 << 12;
  const std::string_view type = node.attribute("type").value();
  const std::optional<NumberType> number = number_type_of_xml(type);
  if (!number) fail("arrays of type " + shown(type) + " are not read");
  Column column;
  column.array.name = node.attribute("Name").value();
  column.array.type = *number;
  column.array.components =
      components != 0 ? components : std::max(1, node.attribute("NumberOfComponents").as_int(1));
  if (column.array.components > most_components) refuse("an array of so many components");
  column.place = place_of(skeleton, node);
  const std::uint64_t size = open(column).size();
  if (size % column.array.size() != 0 || size / column.array.size() != count)
    fail("array " + shown(column.array.name) + " has " + counted(size, "byte") + " for " +
         std::to_string(count) + " times " + std::to_string(column.array.size()) +
         (components == 1 ? " (only triangles can be read in blocks)" : ""));
  return column;
}

VtuPlace StreamedVtu::place_of(const VtuSkeleton& skeleton, const pugi::xml_node& node) const {
  const std::string_view format = node.attribute("format").value();
  const std::uint64_t file_size = std::filesystem::file_size(path());
  if (format == "ascii") refuse("VTU as text");
  if (format == "binary") {
    const VtuSkeleton::Range text = skeleton.text_of(node);
    return {text.begin, std::min(text.end, file_size), true};
  }
  if (format != "appended") fail("unknown format " + shown(format) + " of an array");
  const std::uint64_t offset = node.attribute("offset").as_ullong();
  if (!skeleton.appended() || offset > file_size - *skeleton.appended())
    fail("offset " + std::to_string(offset) + " lies beyond the file's end");
  return {*skeleton.appended() + offset, file_size, packing_.appended_base64};
}

VtuColumn StreamedVtu::open(const Column& column) const {
  return VtuColumn(path(), column.place, packing_);
}

std::string StreamedVtu::kind_of_records() const { return "vtu " + layout_.text(); }

/// Columns that are gone through together.
class StreamedVtu::Rows {
 public:
  Rows(const StreamedVtu& file, const std::vector<Column>& columns) {
    for (const Column& column : columns) {
      open_.push_back(file.open(column));
      sizes_.push_back(column.array.size());
    }
    columns_.resize(columns.size());
  }
  /// The records of the next ones, until the next call.
  const std::string& take(std::size_t count) {
    for (std::size_t k = 0; k < open_.size(); ++k) open_[k].take(count * sizes_[k], columns_[k]);
    if (columns_.size() == 1) return columns_[0];
    weave(columns_, sizes_, count, records_);
    return records_;
  }
  /// What the first column has of them.
  [[nodiscard]] const std::string& first() const { return columns_[0]; }

 private:
  std::vector<VtuColumn> open_;
  std::vector<std::size_t> sizes_;
  std::vector<std::string> columns_;
  std::string records_;
};

void StreamedVtu::each_vertices(const VisitVertices& visit) const {
  Rows rows(*this, of_points_);
  std::vector<glm::dvec3> positions;
  std::vector<double> x;
  for (std::uint64_t first = 0; first < points_; first += tuples_a_piece) {
    const std::size_t count = std::min(tuples_a_piece, points_ - first);
    const std::string& records = rows.take(count);
    x.clear();
    positions.clear();
    decode(rows.first(), layout_.coordinate, packing_.order, x);
    for (std::size_t i = 0; i < count; ++i) {
      positions.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      if (!std::isfinite(x[3 * i]) || !std::isfinite(x[3 * i + 1]) || !std::isfinite(x[3 * i + 2]))
        fail("a coordinate of point " + std::to_string(first + i) + " is not a finite number");
    }
    visit(positions, records);
  }
}

void StreamedVtu::check_cells(std::uint64_t first, const std::vector<std::int64_t>& ends,
                              const std::vector<std::int64_t>& types) const {
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] != triangle_cell)
      refuse(name_of_cell(first + i) + " of type " + cell_type_name(static_cast<int>(types[i])));
    if (static_cast<std::uint64_t>(ends[i]) != 3 * (first + i + 1))
      fail(name_of_cell(first + i) + ": a triangle of other than 3 vertices");
  }
}

void StreamedVtu::each_faces(const VisitFaces& visit) const {
  Rows rows(*this, of_cells_), corners(*this, {connectivity_}), ends(*this, {ends_}),
      types(*this, {types_});
  std::vector<Triangle> triangles;
  const auto whole = [&](Rows& from, const Column& column, std::size_t count) {
    std::vector<std::int64_t> numbers;
    decode(from.take(count), column.array.type, packing_.order, numbers);
    return numbers;
  };
  for (std::uint64_t first = 0; first < cells_; first += tuples_a_piece) {
    const std::size_t count = std::min(tuples_a_piece, cells_ - first);
    check_cells(first, whole(ends, ends_, count), whole(types, types_, count));
    const std::vector<std::int64_t> v = whole(corners, connectivity_, 3 * count);
    triangles.assign(count, {});
    for (std::size_t k = 0; k < v.size(); ++k) {
      if (v[k] < 0 || v[k] >= points_)
        fail(name_of_cell(first + k / 3) + ": there is no vertex " + std::to_string(v[k]));
      triangles[k / 3][k % 3] = static_cast<std::uint32_t>(v[k]);
    }
    visit(triangles, rows.take(count));
  }
}

MeshData StreamedVtu::mesh_of(const std::string& vertex_records, std::string face_records,
                              const std::vector<Triangle>& corners) const {
  return layout_.mesh_of(vertex_records, face_records, corners);
}

}  // namespace aomd::io::detail
