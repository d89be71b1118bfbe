// VTU: VTK's XML files of unstructured grids. pugixml reads the elements; the numbers are read from
// the file's own bytes, so that errors name their line.

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <pugixml.hpp>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/notes.h"
#include "core/io/stored_numbers.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_numbers.h"
#include "core/io/vtu_data.h"
#include "core/io/vtu_grid.h"

namespace aomd::io::detail {
namespace {

/// The cells and points of one piece end here in the joined grid; for messages.
struct PieceEnd {
  std::size_t cells = 0, points = 0;
  pugi::xml_node connectivity;
};

class VtuReader {
 public:
  explicit VtuReader(const Source& source)
      : source_(source), xml_end_(source.bytes.size()), room_(room_of(source.bytes.size())) {}

  VtuGrid grid() {
    read_grid();
    return {std::move(grid_), passed_over()};
  }

  ReadResult read() {
    read_grid();
    ReadResult result =
        mesh_of(std::move(grid_), source_,
                [this](std::size_t cell, const std::string& what) { fail_at_cell(cell, what); });
    result.format = Format::Vtu;
    if (const auto note = passed_over()) result.notes.push_back(*note);
    return result;
  }

 private:
  /// The most numbers that compressed arrays may unpack to: 128 bytes for each byte of the file,
  /// and small files may be packed tighter.
  static std::uint64_t room_of(std::size_t bytes) { return (1u << 18) + 16 * std::uint64_t{bytes}; }

  void read_grid() {
    parse();
    const pugi::xml_node root = document_.document_element();
    read_root(root);
    const pugi::xml_node grid = root.child("UnstructuredGrid");
    if (!grid) fail(root, "has no element UnstructuredGrid");
    read_coverage(grid.child("FieldData"));
    for (const pugi::xml_node piece : grid.children("Piece")) read_piece(piece);
  }

  [[nodiscard]] std::optional<std::string> passed_over() const {
    if (passed_over_.empty()) return {};
    return "passed over: " + passed_over_.text();
  }

  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& what) const {
    source_.fail_at_line(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)),
                         what);
  }

  [[noreturn]] void fail_at_cell(std::size_t cell, const std::string& what) const {
    std::size_t first = 0, p = 0;
    while (p + 1 < pieces_.size() && cell >= pieces_[p].cells) first = pieces_[p++].cells;
    fail(pieces_[p].connectivity, "cell " + std::to_string(cell - first) + ": " + what);
  }

  /// Appended data are bytes, not XML: they are cut off, and the elements around them closed.
  void parse() {
    constexpr std::string_view tag = "<AppendedData";
    const std::size_t start = source_.bytes.find(tag);
    std::string text;
    if (start == std::string_view::npos) {
      text = source_.bytes;
    } else {
      const std::size_t close = source_.bytes.find('>', start);
      const std::size_t mark = source_.bytes.find('_', std::min(close, source_.bytes.size()));
      if (close == std::string_view::npos || mark == std::string_view::npos)
        source_.fail_at_line(start, "the file ends within AppendedData");
      text = std::string(source_.bytes.substr(0, close + 1)) + "</AppendedData></VTKFile>";
      xml_end_ = close + 1;
      appended_ = mark + 1;
    }
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text.data(), text.size(), pugi::parse_escapes, pugi::encoding_utf8);
    if (!parsed)
      source_.fail_at_line(std::min(static_cast<std::size_t>(parsed.offset), xml_end_),
                           std::string("XML: ") + parsed.description());
  }

  void read_root(const pugi::xml_node& root) {
    if (std::string_view(root.name()) != "VTKFile") fail(root, "the root element is not VTKFile");
    const std::string_view type = root.attribute("type").value();
    if (type != "UnstructuredGrid")
      fail(root, "a VTK file of type " + shown(type) +
                     "; only UnstructuredGrid is read: save it as .vtu, or as legacy .vtk");
    packing_ = packing_of(root, [&](const std::string& what) { fail(root, what); });
  }

  std::uint64_t count(const pugi::xml_node& node, const char* name, std::uint64_t absent) const {
    constexpr std::string_view blanks = " \t\r\n";
    std::string_view text = node.attribute(name).value();
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty()) return absent;
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      fail(node, std::string(name) + " is no number: " + shown(text));
    return value;
  }

  /// Where the text of an element lies in the file.
  std::pair<std::size_t, std::size_t> text_of(const pugi::xml_node& node) const {
    for (const pugi::xml_node child : node.children()) {
      if (child.type() != pugi::node_pcdata || child.offset_debug() < 0) continue;
      const auto start = static_cast<std::size_t>(child.offset_debug());
      return {start, std::min(source_.bytes.find('<', start), xml_end_)};
    }
    return {0, 0};
  }

  NumberType number_type(const pugi::xml_node& node) const {
    const std::string_view name = node.attribute("type").value();
    const auto type = number_type_of_xml(name);
    if (!type) fail(node, "arrays of type " + shown(name) + " are not read");
    return *type;
  }

  /// The numbers of an array that should have `wanted`, or not many more.
  template <class Value>
  std::vector<Value> numbers(const pugi::xml_node& node, std::uint64_t wanted) {
    const NumberType type = number_type(node);
    const std::string_view format = node.attribute("format").value();
    std::vector<Value> out;
    if (format == "ascii") {
      const auto [start, end] = text_of(node);
      TextCursor cursor(source_, source_.bytes.substr(0, end), start);
      if constexpr (std::is_same_v<Value, double>) {
        read_text(cursor, all_words, is_integer(type), out);
      } else {
        read_text(cursor, all_words, out);
      }
    } else {
      const std::uint64_t most = std::min(room_, std::max<std::uint64_t>(wanted, 1024));
      decode(bytes(node, format, most * size_of(type)), type, packing_.order, out);
      if (packing_.compressed) room_ -= out.size();
    }
    return out;
  }

  std::string bytes(const pugi::xml_node& node, std::string_view format, std::uint64_t most) {
    if (format == "binary") {
      const auto [start, end] = text_of(node);
      return start == end ? std::string() : unpack(source_, start, end, true, packing_, most).bytes;
    }
    if (format != "appended") fail(node, "unknown format " + shown(format) + " of an array");
    const std::uint64_t offset = count(node, "offset", 0);
    if (!appended_ || offset > source_.bytes.size() - *appended_)
      fail(node, "offset " + std::to_string(offset) + " lies beyond the file's end");
    const std::size_t start = *appended_ + static_cast<std::size_t>(offset);
    Unpacked data =
        unpack(source_, start, source_.bytes.size(), packing_.appended_base64, packing_, most);
    used_ += data.end - start;
    if (used_ > source_.bytes.size())
      fail(node, "arrays share their data");  // memory would have no bound
    return std::move(data.bytes);
  }

  /// Of what belongs to the whole, only how our own arrays are spread is of use.
  void read_coverage(const pugi::xml_node& data) {
    const std::string name(coverage_name);
    const auto array = data.find_child_by_attribute("DataArray", "Name", name.c_str());
    if (!array) return;
    if (auto read = data_array(array, room_)) grid_.field_data.push_back(std::move(*read));
  }

  /// Nothing for what is not made of numbers.
  std::optional<VtkArray> data_array(const pugi::xml_node& node, std::uint64_t tuples) {
    const std::string name = node.attribute("Name").value();
    if (std::string_view(node.attribute("type").value()) == "String") {
      passed_over_.add("text " + shown(name));
      return {};
    }
    const std::uint64_t components =
        std::max<std::uint64_t>(count(node, "NumberOfComponents", 1), 1);
    if (components > (1u << 20)) fail(node, "an array of " + counted(components, "component"));
    VtkArray array{name, static_cast<int>(components), false, {}, {}, Meaning::Any};
    store_as(array, number_type(node));
    array.values = numbers<double>(node, components * std::min(tuples, room_));
    round_as(number_type(node), array.values);
    if (array.values.size() % components != 0)
      fail(node, counted(array.values.size(), "value") + " are not tuples of " +
                     std::to_string(components));
    return array;
  }

  pugi::xml_node array_named(const pugi::xml_node& piece, const char* name) const {
    const pugi::xml_node array =
        piece.child("Cells").find_child_by_attribute("DataArray", "Name", name);
    if (!array) fail(piece, std::string("has no array of the cells' ") + name);
    return array;
  }

  void read_piece(const pugi::xml_node& piece) {
    const std::uint64_t points = count(piece, "NumberOfPoints", 0),
                        cells = count(piece, "NumberOfCells", 0);
    const std::size_t first_point = grid_.points.size(), first_cell = grid_.types.size();
    if (points > 0) read_points(piece, points);
    PieceEnd end;
    if (cells > 0) end.connectivity = read_cells(piece, points, cells, first_point);
    end.cells = grid_.types.size();
    end.points = grid_.points.size();
    read_data(piece.child("PointData"), point_data_, grid_.point_data, first_point, points);
    read_data(piece.child("CellData"), cell_data_, grid_.cell_data, first_cell, cells);
    pieces_.push_back(end);
  }

  void read_points(const pugi::xml_node& piece, std::uint64_t n) {
    const pugi::xml_node node = piece.child("Points").child("DataArray");
    if (!node) fail(piece, "has no array of points");
    const std::vector<double> x = numbers<double>(node, 3 * std::min(n, room_));
    if (x.size() % 3 != 0 || x.size() / 3 != n)
      fail(node, counted(x.size(), "coordinate") + " for " + counted(n, "point"));
    for (std::size_t k = 0; k < x.size(); k += 3) {
      if (!std::isfinite(x[k]) || !std::isfinite(x[k + 1]) || !std::isfinite(x[k + 2]))
        fail(node, "a coordinate of point " + std::to_string(k / 3) + " is not a finite number");
      grid_.points.emplace_back(x[k], x[k + 1], x[k + 2]);
    }
  }

  /// Returns the element of the connectivity.
  pugi::xml_node read_cells(const pugi::xml_node& piece, std::uint64_t points, std::uint64_t n,
                            std::size_t first_point) {
    const pugi::xml_node list = array_named(piece, "connectivity"),
                         ends = array_named(piece, "offsets");
    const std::vector<std::int64_t> types = numbers<std::int64_t>(array_named(piece, "types"), n);
    const std::vector<std::int64_t> indices = numbers<std::int64_t>(list, room_),
                                    stops = numbers<std::int64_t>(ends, n);
    if (types.size() != n)
      fail(array_named(piece, "types"),
           counted(types.size(), "type") + " for " + counted(n, "cell"));
    if (stops.size() != n || stops.front() < 0 || !std::is_sorted(stops.begin(), stops.end()) ||
        static_cast<std::uint64_t>(stops.back()) != indices.size()) {
      fail(ends, "the offsets of " + counted(n, "cell") + " do not ascend to " +
                     std::to_string(indices.size()));
    }
    const auto base = static_cast<std::int64_t>(grid_.connectivity.size());
    for (const std::int64_t type : types) {
      if (type < 0 || type > 255)
        fail(array_named(piece, "types"), "there is no cell type " + std::to_string(type));
      grid_.types.push_back(static_cast<std::uint8_t>(type));
    }
    for (const std::int64_t stop : stops) grid_.ends.push_back(base + stop);
    for (const std::int64_t v : indices)
      grid_.connectivity.push_back(joined_index(list, v, points, first_point));
    return list;
  }

  /// Indices count from the piece's own first point.
  std::int64_t joined_index(const pugi::xml_node& list, std::int64_t v, std::uint64_t points,
                            std::size_t first_point) const {
    if (v < 0 || static_cast<std::uint64_t>(v) >= points)
      fail(list, "vertex index " + std::to_string(v) + " is out of range (" +
                     counted(points, "vertex") + ")");
    return v + static_cast<std::int64_t>(first_point);
  }

  /// Where arrays of one name and kind are: the first of them in a piece continues the first.
  using Places = std::unordered_map<std::string, std::vector<std::size_t>>;

  /// What the element of all arrays says of one: that it is the active one of a kind.
  static Meaning meaning_of(const pugi::xml_node& data, const std::string& name) {
    for (const auto& [word, meaning] : vtu_actives)
      if (data.attribute(std::string(word).c_str()).value() == name) return meaning;
    return Meaning::Any;
  }

  static std::string kind_of(const VtkArray& array) {
    return (array.integer ? 'i' : 'r') + std::to_string(array.components) + ' ' + array.name;
  }

  /// Appends the arrays of a piece, whose first element is number `first` of the grid.
  void read_data(const pugi::xml_node& data, Places& places, std::vector<VtkArray>& into,
                 std::size_t first, std::uint64_t n) {
    if (n == 0) return;
    std::unordered_map<std::string, std::size_t> seen;
    for (const pugi::xml_node node : data.children("DataArray")) {
      std::optional<VtkArray> array = data_array(node, n);
      if (!array) continue;
      if (array->values.size() / static_cast<std::size_t>(array->components) != n)
        fail(node, "array " + shown(array->name) + " has " +
                       counted(array->values.size(), "value") + " for " + std::to_string(n));
      array->meaning = meaning_of(data, array->name);
      const std::string kind = kind_of(*array);
      std::vector<std::size_t>& same = places[kind];
      const std::size_t use = seen[kind]++;
      if (use < same.size()) {
        std::vector<double>& values = into[same[use]].values;
        values.insert(values.end(), array->values.begin(), array->values.end());
      } else if (first == 0) {
        same.push_back(into.size());
        into.push_back(std::move(*array));
      } else {
        fail(node, "array " + shown(array->name) + " is not in every piece");
      }
    }
    for (const VtkArray& array : into) {
      if (array.values.size() != (first + n) * static_cast<std::size_t>(array.components))
        fail(data, "array " + shown(array.name) + " is not in every piece");
    }
  }

  const Source& source_;
  pugi::xml_document document_;
  std::size_t xml_end_;
  std::optional<std::size_t> appended_;  ///< where offset 0 lies
  std::size_t used_ = 0;                 ///< bytes of the appended data
  VtuPacking packing_;
  VtkDataset grid_;
  std::vector<PieceEnd> pieces_;
  Places point_data_, cell_data_;
  std::uint64_t room_;  ///< numbers that compressed arrays may still unpack to
  ItemList passed_over_;
};

}  // namespace

ReadResult read_vtu(const Source& source) { return VtuReader(source).read(); }

VtuGrid read_vtu_grid(const Source& source) { return VtuReader(source).grid(); }

}  // namespace aomd::io::detail
