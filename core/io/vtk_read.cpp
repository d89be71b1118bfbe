// Legacy VTK files: unstructured grids and polygonal data, versions 1 to 5.1, text and binary.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_legacy.h"

namespace aomd::io::detail {
namespace {

/// Cells of one list of the file, and where its indices stand, for messages.
struct CellBlock {
  std::uint8_t type = 0;  ///< of all cells in polygonal data
  std::vector<std::int64_t> connectivity, ends;
  std::size_t offset = 0;      ///< of the first index, or the first count
  std::size_t value_size = 0;  ///< of an index in binary
  bool counts = false;         ///< the number of a cell's indices stands before them
};

class LegacyReader : LegacyInput {
 public:
  explicit LegacyReader(const Source& source) : LegacyInput(source) {}

  ReadResult read() {
    header();
    while (!cursor_.skip_to_content()) section();
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
    if (!passed_over_.empty()) result.notes.push_back("passed over: " + passed_over_);
    return result;
  }

 private:
  [[noreturn]] void fail_at_cell(std::size_t cell, const std::string& what) const {
    std::size_t k = cell, b = 0;
    while (b + 1 < blocks_.size() && k >= cells_in_[b]) k -= cells_in_[b++];
    const CellBlock& block = blocks_[b];
    const std::size_t before = k == 0 ? 0 : static_cast<std::size_t>(block.ends[k - 1]);
    fail_at_value(block.offset, before + (block.counts ? k : 0), block.value_size, what);
  }

  void header() {
    const std::string_view first = cursor_.rest_of_line();
    constexpr std::string_view magic = "# vtk DataFile Version ";
    if (!first.starts_with(magic))
      source_.fail_at_line(0, "does not start with \"# vtk DataFile Version\"");
    major_ = first.size() > magic.size() ? first[magic.size()] - '0' : 0;
    if (major_ < 1 || major_ > 5)
      source_.fail_at_line(
          0, "version " + shown(first.substr(magic.size())) + " is not read, only 1 to 5.1");
    cursor_.skip_line();  // the title
    const std::string encoding = lower(word("ASCII or BINARY"));
    if (encoding != "ascii" && encoding != "binary")
      cursor_.fail("expected ASCII or BINARY, found " + shown(encoding));
    if (lower(word("DATASET")) != "dataset") cursor_.fail("expected DATASET");
    const std::string kind = lower(word("the kind of dataset"));
    if (kind != "unstructured_grid" && kind != "polydata")
      cursor_.fail("a dataset of kind " + shown(kind) +
                   "; only UNSTRUCTURED_GRID and POLYDATA are read");
    polygonal_ = has_cells_ = kind == "polydata";  // where any of the lists may lack
    binary_ = encoding == "binary";
  }

  void section() {
    const std::size_t start = cursor_.offset();
    const std::string_view name = cursor_.word();
    const std::string keyword = lower(name);
    if (keyword == "metadata") return skip_metadata();
    if (keyword == "field") return fields();
    if (arrays(keyword)) return;
    if (target_) fail_at(start, "unexpected " + shown(name) + " among the data");
    if (!geometry(keyword)) fail_at(start, "unexpected " + shown(name));
  }

  bool geometry(const std::string& keyword) {
    if (keyword == "points") {
      points();
    } else if (keyword == "cells" && !polygonal_) {
      cells(0);
    } else if (keyword == "cell_types" && !polygonal_) {
      cell_types();
    } else if (polygonal_) {
      constexpr std::string_view names[] = {"vertices", "lines", "polygons", "triangle_strips"};
      const auto found = std::find(std::begin(names), std::end(names), keyword);
      if (found == std::end(names)) return false;
      cells(static_cast<std::size_t>(found - std::begin(names)));
    } else {
      return false;
    }
    return true;
  }

  void points() {
    const std::uint64_t n = count("the number of points");
    const NumberType type = number_type("the points");
    check_room(n);
    const std::size_t start = data_start();
    std::vector<double> numbers;
    values(type, 3 * n, numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (!std::isfinite(numbers[k]))
        fail_at_value(start, k, size_of(type), "a coordinate is not a finite number");
    }
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
    if (keyword == "point_data" || keyword == "cell_data") {
      target_ = keyword == "point_data" ? &grid_.point_data : &grid_.cell_data;
      tuples_ = keyword == "point_data" ? grid_.points.size() : cell_count();
      const std::uint64_t n = count("the number of values");
      if (n != tuples_) fail("data for " + std::to_string(n) + " of " + std::to_string(tuples_));
      return true;
    }
    return target_ && attribute(keyword);
  }

  bool attribute(const std::string& keyword) {
    if (keyword == "scalars") {
      scalars();
    } else if (keyword == "color_scalars") {
      color_scalars();
    } else if (keyword == "lookup_table") {
      lookup_table();
    } else if (keyword == "texture_coordinates") {
      const std::string name = decoded(word("a name"));
      const std::uint64_t n = count("the number of components");
      array(*target_, name, n, tuples_);
    } else {
      const std::size_t n = components_of(keyword);
      if (n == 0) return false;
      const std::string name = decoded(word("a name"));
      array(*target_, name, n, tuples_);
    }
    return true;
  }

  static std::size_t components_of(const std::string& keyword) {
    constexpr std::pair<std::string_view, std::size_t> known[] = {
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    for (const auto& [name, n] : known) {
      if (name == keyword) return n;
    }
    return 0;
  }

  void scalars() {
    const std::string name = decoded(word("a name"));
    const std::string type(word("the type of the scalars"));
    const std::uint64_t n = cursor_.line_done() ? 1 : count("the number of components");
    TextCursor ahead = cursor_;
    if (!ahead.skip_to_content() && lower(ahead.word()) == "lookup_table") {
      (void)ahead.word();  // its name
      cursor_ = ahead;
    }
    array(*target_, name, n, tuples_, type);
  }

  /// 0 to 1 in text, 0 to 255 in binary.
  void color_scalars() {
    const std::string name = decoded(word("a name"));
    const std::uint64_t n = count("the number of components");
    array(*target_, name, n, tuples_, binary_ ? "unsigned_char" : "float");
    if (!binary_ || target_->empty()) return;
    target_->back().integer = false;
    for (double& x : target_->back().values) x /= 255;
  }

  void lookup_table() {
    (void)word("a name");
    std::vector<VtkArray> colours;
    array(colours, "", 4, count("the size of the table"), binary_ ? "unsigned_char" : "float");
  }

  void fields() {
    (void)word("a name");
    const std::uint64_t n = count("the number of arrays");
    for (std::uint64_t i = 0; i < n; ++i) {
      if (cursor_.skip_to_content())
        fail("the file ends after " + std::to_string(i) + " of " + counted(n, "array"));
      TextCursor ahead = cursor_;
      if (lower(ahead.word()) == "metadata") {
        cursor_ = ahead;
        skip_metadata();
      }
      const std::string name = decoded(word("the name of an array"));
      if (name == "NULL_ARRAY") continue;
      const std::uint64_t components = count("the number of components"),
                          tuples = count("the number of tuples");
      if (target_ && tuples != tuples_)
        fail("array " + shown(name) + " has " + std::to_string(tuples) + " tuples, not " +
             std::to_string(tuples_));
      array(target_ ? *target_ : grid_.field_data, name, components, tuples);
    }
  }

  void array(std::vector<VtkArray>& into, const std::string& name, std::uint64_t components,
             std::uint64_t tuples) {
    array(into, name, components, tuples, word("the type of an array"));
  }

  void array(std::vector<VtkArray>& into, const std::string& name, std::uint64_t components,
             std::uint64_t tuples, std::string_view type_name) {
    constexpr std::uint64_t most_components = 1u << 20;
    if (components == 0 || components > most_components)
      fail("an array of " + counted(components, "component"));
    check_room(tuples);
    const std::uint64_t n = components * tuples;
    const std::string type = lower(type_name);
    VtkArray result{name, static_cast<int>(components), true, {}};
    if (type == "bit") {
      bits(n, result.values);
    } else if (type == "string" || type == "utf8_string") {
      return skip_strings(name, n);
    } else if (const auto number = number_type_of_legacy(type)) {
      result.integer = is_integer(*number);
      values(*number, n, result.values);
    } else {
      fail("unknown type " + shown(type_name) + " of array " + shown(name));
    }
    into.push_back(std::move(result));
  }

  void bits(std::uint64_t n, std::vector<double>& out) {
    if (!binary_) return values(NumberType::UInt8, n, out);
    const std::string_view bytes = take((n + 7) / 8, 1);
    for (std::uint64_t i = 0; i < n; ++i)
      out.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
  }

  /// One a line, in text.
  void skip_strings(const std::string& name, std::uint64_t n) {
    if (binary_) fail("binary text in array " + shown(name) + " is not read");
    check_room(n);
    cursor_.skip_line();
    for (std::uint64_t i = 0; i < n; ++i) cursor_.skip_line();
    passed_over_ += (passed_over_.empty() ? "text " : ", text ") + shown(name);
  }

  /// Up to an empty line.
  void skip_metadata() {
    cursor_.skip_line();
    while (cursor_.left() > 0 && !cursor_.line_done()) cursor_.skip_line();
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
      if (polygonal_) grid_.types.insert(grid_.types.end(), block.ends.size(), block.type);
    }
  }

  int major_ = 0;
  bool polygonal_ = false, has_points_ = false, has_cells_ = false;
  VtkDataset grid_;
  std::array<CellBlock, 4> blocks_;  ///< an unstructured grid has only the first
  std::array<std::size_t, 4> cells_in_{};
  std::vector<VtkArray>* target_ = nullptr;  ///< what follows belongs to points or cells
  std::uint64_t tuples_ = 0;
  std::string passed_over_;
};

}  // namespace

ReadResult read_vtk(const Source& source) { return LegacyReader(source).read(); }

}  // namespace aomd::io::detail
