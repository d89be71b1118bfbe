// Legacy VTK files: grids of every kind and polygonal data, versions 1 to 5.1, text and binary.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/vtk_arrays.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_structured.h"

namespace aomd::io::detail {
namespace {

/// Cells of one list of the file, and where its indices stand, for messages.
struct CellBlock {
  std::uint8_t type = 0;  ///< of all cells, but in unstructured grids
  std::vector<std::int64_t> connectivity, ends;
  std::size_t offset = 0;      ///< of the first index, or the first count
  std::size_t value_size = 0;  ///< of an index in binary
  bool counts = false;         ///< the number of a cell's indices stands before them
};

class LegacyReader : LegacyArrays {
 public:
  explicit LegacyReader(const Source& source) : LegacyArrays(source) {}

  ReadResult read() {
    header();
    while (!cursor_.skip_to_content()) section();
    build_structured();
    if (!has_points_) fail("the file ends before POINTS");
    if (!has_cells_) fail("the file ends before CELLS");
    join_blocks();
    if (grid_.types.size() != grid_.ends.size()) {
      fail(std::to_string(grid_.types.size()) + " cell types for " +
           counted(grid_.ends.size(), "cell"));
    }
    ReadResult result =
        mesh_of(std::move(grid_), source_,
                [this](std::size_t cell, const std::string& what) { fail_at_cell(cell, what); });
    result.format = Format::Vtk;
    if (!passed_over().empty()) result.notes.push_back("passed over: " + passed_over().text());
    return result;
  }

 private:
  [[noreturn]] void fail_at_cell(std::size_t cell, const std::string& what) const {
    if (structured()) source_.fail("cell " + std::to_string(cell) + ": " + what);
    std::size_t k = cell, b = 0;
    while (b + 1 < blocks_.size() && k >= cells_in_[b]) k -= cells_in_[b++];
    const CellBlock& block = blocks_[b];
    const std::size_t before = k == 0 ? 0 : static_cast<std::size_t>(block.ends[k - 1]);
    fail_at_value(block.offset, before + (block.counts ? k : 0), block.value_size, what);
  }

  void header() {
    version();
    const std::string encoding = encoding_after_title();
    binary_ = encoding == "binary";
    if (!binary_) read_as_text();
    if (lower(word("DATASET")) != "dataset") cursor_.fail("expected DATASET");
    kind_ = kind_of(lower(word("the kind of dataset")));
    has_cells_ = kind_ != Kind::Unstructured;  // polygonal data may lack any of the lists
  }

  void version() {
    cursor_.skip_to_content();
    if (!is_vtk(cursor_.rest())) cursor_.fail("does not start with \"# vtk DataFile Version\"");
    for (int i = 0; i < 3; ++i) (void)cursor_.word();
    if (lower(cursor_.word()) != "version") cursor_.fail("the first line names no version");
    const std::string_view number = cursor_.word();
    major_ = number.empty() ? 0 : number[0] - '0';
    if (major_ < 1 || major_ > 5)
      cursor_.fail("version " + shown(number) + " is not read, only 1 to 5.1");
    cursor_.skip_line();
  }

  /// The title is the second line, empty or not, or the first after empty ones.
  std::string encoding_after_title() {
    const bool empty = cursor_.rest_of_line().empty();
    cursor_.pass_comment_lines();
    std::string encoding = lower(word("ASCII or BINARY"));
    const auto known = [&] { return encoding == "ascii" || encoding == "binary"; };
    if (empty && !known()) {
      cursor_.skip_line();
      encoding = lower(word("ASCII or BINARY"));
    }
    if (!known()) cursor_.fail("expected ASCII or BINARY, found " + shown(encoding));
    return encoding;
  }

  enum class Kind { Unstructured, Polygonal, Uniform, Rectilinear, Curvilinear };

  Kind kind_of(const std::string& name) const {
    constexpr std::pair<std::string_view, Kind> section_kinds[] = {
        {"unstructured_grid", Kind::Unstructured},
        {"polydata", Kind::Polygonal},
        {"structured_points", Kind::Uniform},
        {"rectilinear_grid", Kind::Rectilinear},
        {"structured_grid", Kind::Curvilinear}};
    for (const auto& [known, kind] : section_kinds) {
      if (known == name) return kind;
    }
    cursor_.fail("a dataset of kind " + shown(name) +
                 "; save it as UNSTRUCTURED_GRID or POLYDATA, which are read");
  }
  [[nodiscard]] bool structured() const { return kind_ > Kind::Polygonal; }

  void section() {
    const std::size_t start = cursor_.offset();
    const std::string_view name = cursor_.word();
    const std::string keyword = lower(name);
    if (keyword == "metadata") return skip_metadata();
    if (keyword == "field") return fields(grid_.field_data);
    if (arrays(keyword)) return;
    if (data_begun()) fail_at(start, "unexpected " + shown(name) + " among the data");
    if (!geometry(keyword)) fail_at(start, "unexpected " + shown(name));
  }

  bool geometry(const std::string& keyword) {
    if (keyword == "points" && kind_ != Kind::Uniform && kind_ != Kind::Rectilinear) {
      points();
      return true;
    }
    if (structured()) return structure(keyword);
    if (kind_ == Kind::Polygonal) return polygonal_cells(keyword);
    if (keyword == "cells") {
      cells(0);
    } else if (keyword == "cell_types") {
      cell_types();
    } else {
      return false;
    }
    return true;
  }

  bool polygonal_cells(const std::string& keyword) {
    constexpr std::string_view names[] = {"vertices", "lines", "polygons", "triangle_strips"};
    const auto found = std::find(std::begin(names), std::end(names), keyword);
    if (found == std::end(names)) return false;
    cells(static_cast<std::size_t>(found - std::begin(names)));
    return true;
  }

  /// What describes a structured grid.
  bool structure(const std::string& keyword) {
    constexpr std::string_view axes[] = {"x_coordinates", "y_coordinates", "z_coordinates"};
    const auto axis = std::find(std::begin(axes), std::end(axes), keyword);
    if (keyword == "dimensions") {
      for (std::uint64_t& n : size_) n = count("a number of points");
    } else if (keyword == "origin") {
      for (double& x : origin_) x = cursor_.real("the origin");
    } else if (keyword == "spacing" || keyword == "aspect_ratio") {
      for (double& x : spacing_) x = cursor_.real("the spacing");
    } else if (kind_ == Kind::Rectilinear && axis != std::end(axes)) {
      coordinates(axes_[static_cast<std::size_t>(axis - std::begin(axes))]);
    } else {
      return false;
    }
    return true;
  }

  void coordinates(std::vector<double>& axis) {
    const std::uint64_t n = count("the number of coordinates");
    const NumberType type = number_type("the coordinates");
    axis.clear();
    const std::size_t start = data_start();
    values(type, n, axis);
    check_finite(axis, start, type);
  }

  void check_finite(const std::vector<double>& numbers, std::size_t start, NumberType type) const {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!std::isfinite(numbers[k]))
        fail_at_value(start, k, size_of(type), "a coordinate is not a finite number");
    }
  }

  /// Once everything that describes the grid has been read.
  void build_structured() {
    if (!structured() || !blocks_[0].ends.empty()) return;
    const std::uint64_t most = (1u << 16) + 16 * std::uint64_t{source_.bytes.size()},
                        n = points_of(size_, most);
    if (n == 0) fail("DIMENSIONS are missing, or one of them is 0");
    if (n > most)
      throw LimitError(source_.name, {},
                       "a structured grid of more points than 16 for each byte of the file: save "
                       "it as an unstructured grid");
    if (kind_ == Kind::Uniform) place_axes();
    if (kind_ != Kind::Curvilinear) points_on_axes();
    if (grid_.points.size() != n)
      fail("DIMENSIONS ask for " + counted(n, "point") + ", and there are " +
           std::to_string(grid_.points.size()));
    blocks_[0].type = add_cells(size_, blocks_[0].connectivity, blocks_[0].ends);
  }

  void place_axes() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes_[axis].clear();
      for (std::uint64_t i = 0; i < size_[axis]; ++i)
        axes_[axis].push_back(origin_[axis] + static_cast<double>(i) * spacing_[axis]);
    }
  }

  void points_on_axes() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axes_[axis].size() != size_[axis])
        fail("DIMENSIONS ask for " + counted(size_[axis], "coordinate") +
             " along an axis that has " + std::to_string(axes_[axis].size()));
    }
    grid_.points = points_on(axes_);
    has_points_ = true;
  }

  void points() {
    const std::uint64_t n = count("the number of points");
    const NumberType type = number_type("the points");
    check_room(n);
    const std::size_t start = data_start();
    std::vector<double> numbers;
    values(type, 3 * n, numbers);
    check_finite(numbers, start, type);
    has_points_ = true;
    grid_.points.clear();
    grid_.points.reserve(static_cast<std::size_t>(n));
    for (std::size_t k = 0; k < numbers.size(); k += 3)
      grid_.points.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
  }

  void cells(std::size_t b) {
    constexpr std::uint8_t types[] = {2, 4, 7, 6};
    has_cells_ = true;
    CellBlock& block = blocks_[b];
    block = {};
    block.type = types[b];
    const std::uint64_t n = count("the number of cells"), size = count("the number of indices");
    if (major_ == 5) return offsets_and_connectivity(block, n, size);
    block.counts = true;
    block.value_size = 4;
    check_room(size);
    block.offset = data_start();
    if (n > size) fail(counted(n, "cell") + " do not fit into " + counted(size, "number"));
    values(NumberType::Int32, size, block.connectivity);
    split_counts(block, n);
  }

  /// Takes the counts out of the list.
  void split_counts(CellBlock& block, std::uint64_t n) {
    std::vector<std::int64_t>& list = block.connectivity;
    std::size_t from = 0, to = 0;
    block.ends.reserve(static_cast<std::size_t>(n));
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::int64_t size = from < list.size() ? list[from] : -1;
      if (size < 0 || static_cast<std::uint64_t>(size) > list.size() - from - 1) {
        fail_at_value(block.offset, std::min(from, list.size()), block.value_size,
                      "the vertices of cell " + std::to_string(i) + " go beyond the list");
      }
      std::copy_n(list.begin() + static_cast<std::ptrdiff_t>(from) + 1, size,
                  list.begin() + static_cast<std::ptrdiff_t>(to));
      from += 1 + static_cast<std::size_t>(size);
      to += static_cast<std::size_t>(size);
      block.ends.push_back(static_cast<std::int64_t>(to));
    }
    if (from != list.size())
      fail(counted(n, "cell") + " take " + std::to_string(from) + " of " +
           counted(list.size(), "number"));
    list.resize(to);
  }

  /// Version 5: n is the number of offsets, one more than there are cells.
  void offsets_and_connectivity(CellBlock& block, std::uint64_t n, std::uint64_t size) {
    if (n == 0) return;
    keyword("OFFSETS");
    const NumberType offset_type = number_type("OFFSETS");
    const std::size_t start = data_start();
    values(offset_type, n, block.ends);
    if (block.ends.size() != n || block.ends.front() != 0 ||
        !std::is_sorted(block.ends.begin(), block.ends.end()) ||
        static_cast<std::uint64_t>(block.ends.back()) != size)
      fail_at(start, "the offsets do not ascend from 0 to " + std::to_string(size));
    block.ends.erase(block.ends.begin());
    keyword("CONNECTIVITY");
    const NumberType type = number_type("CONNECTIVITY");
    block.offset = data_start();
    block.value_size = size_of(type);
    values(type, size, block.connectivity);
    if (block.connectivity.size() != size) fail_at(block.offset, "indices are whole numbers");
  }

  void cell_types() {
    const std::uint64_t n = count("the number of cell types");
    const std::size_t start = data_start();
    std::vector<std::int64_t> types;
    values(NumberType::Int32, n, types);
    grid_.types.clear();
    for (std::size_t k = 0; k < types.size(); ++k) {
      if (types[k] < 0 || types[k] > 255)
        fail_at_value(start, k, 4, "there is no cell type " + std::to_string(types[k]));
      grid_.types.push_back(static_cast<std::uint8_t>(types[k]));
    }
  }

  [[nodiscard]] std::size_t cell_count() const {
    std::size_t n = 0;
    for (const CellBlock& block : blocks_) n += block.ends.size();
    return n;
  }

  bool arrays(const std::string& keyword) {
    if (keyword != "point_data" && keyword != "cell_data") return attribute(keyword);
    build_structured();
    const bool of_points = keyword == "point_data";
    begin_data(of_points ? grid_.point_data : grid_.cell_data,
               of_points ? grid_.points.size() : cell_count());
    return true;
  }

  /// Polygonal data number their cells list after list.
  void join_blocks() {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      CellBlock& block = blocks_[b];
      const auto base = static_cast<std::int64_t>(grid_.connectivity.size());
      cells_in_[b] = block.ends.size();
      grid_.connectivity.insert(grid_.connectivity.end(), block.connectivity.begin(),
                                block.connectivity.end());
      for (const std::int64_t end : block.ends) grid_.ends.push_back(base + end);
      if (kind_ != Kind::Unstructured)
        grid_.types.insert(grid_.types.end(), block.ends.size(), block.type);
    }
  }

  int major_ = 0;
  Kind kind_ = Kind::Unstructured;
  bool has_points_ = false, has_cells_ = false;
  GridSize size_{};                                    ///< of structured grids, as what follows
  std::array<double, 3> origin_{}, spacing_{1, 1, 1};  ///< uniform
  std::array<std::vector<double>, 3> axes_;            ///< uniform and rectilinear
  VtkDataset grid_;
  std::array<CellBlock, 4> blocks_;  ///< all but polygonal data have only the first
  std::array<std::size_t, 4> cells_in_{};
};

}  // namespace

bool is_vtk(std::string_view bytes) {
  const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const Source source{{}, bytes.substr(start, 200)};
  TextCursor cursor(source, source.bytes);
  return cursor.word() == "#" && lower(cursor.word()) == "vtk" &&
         lower(cursor.word()) == "datafile";
}

ReadResult read_vtk(const Source& source) { return LegacyReader(source).read(); }

}  // namespace aomd::io::detail
